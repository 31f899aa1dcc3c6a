// How well words stand out from what is behind them.

/** Words within `root`, a selector, whose contrast is below 4.5 (WCAG 1.4.3), and how many were looked at. Runs in a page. */
export function contrasts(root) {
  const parse = (colour) => {
    const [r, g, b, a = 1] = colour.match(/[\d.]+/g).map(Number);
    return { r, g, b, a };
  };
  const light = ({ r, g, b }) => {
    const [x, y, z] = [r, g, b].map((c) => (c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4));
    return 0.2126 * x + 0.7152 * y + 0.0722 * z;
  };
  const weak = [];
  let seen = 0;
  const walk = document.createTreeWalker(document.querySelector(root), NodeFilter.SHOW_TEXT);
  while (walk.nextNode()) {
    const element = walk.currentNode.parentElement;
    if (!walk.currentNode.textContent.trim() || !element.checkVisibility() || element.closest(".rp-status, option, script, style")) {
      continue;
    }
    let behind = element;
    while (behind && parse(getComputedStyle(behind).backgroundColor).a < 0.5) {
      behind = behind.parentElement;
    }
    const [a, b] = [light(parse(getComputedStyle(element).color)), light(parse(behind ? getComputedStyle(behind).backgroundColor : "rgb(255,255,255)"))];
    const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    seen += 1;
    if (ratio < 4.5) {
      weak.push(`${walk.currentNode.textContent.trim()}: ${ratio.toFixed(2)}`);
    }
  }
  return { weak, seen };
}
