// Elements in few words.

type Attributes = Record<string, string | number | boolean | undefined>;
type Child = Node | string;

/** An element with attributes and children; false and undefined attributes are left out. */
export function make<K extends keyof HTMLElementTagNameMap>(tag: K, attributes: Attributes = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  put(element, attributes);
  element.append(...children);
  return element;
}

const SVG = "http://www.w3.org/2000/svg";

/** The same for a drawing. */
export function draw<K extends keyof SVGElementTagNameMap>(tag: K, attributes: Attributes = {}, ...children: Node[]): SVGElementTagNameMap[K] {
  const element = document.createElementNS(SVG, tag);
  put(element, attributes);
  element.append(...children);
  return element;
}

/** An icon of one filled path in a 24 x 24 box. */
export function icon(path: string): SVGSVGElement {
  return draw("svg", { viewBox: "0 0 24 24", "aria-hidden": "true", class: "rp-icon" }, draw("path", { d: path }));
}

/** A button with an icon, words, or both; `label` is what it is called. */
export function button(label: string, content: Child[], press: () => void): HTMLButtonElement {
  const element = make("button", { type: "button", "aria-label": label, title: label }, ...content);
  element.addEventListener("click", press);
  return element;
}

function put(element: Element, attributes: Attributes): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== undefined && value !== false) {
      element.setAttribute(name, value === true ? "" : String(value));
    }
  }
}

/** Changes the text of a node only where it differs. */
export function say(element: Node, text: string): void {
  if (element.textContent !== text) {
    element.textContent = text;
  }
}
