// The keyboard.
import type { Actions } from "./actions.ts";
import { make } from "./dom.ts";
import type { Camera, View } from "./view.ts";

/** Keys, and what they do; keys that are pressed together stand as one. */
const LIST: [string[], string][] = [
  [["Space"], "play, pause"],
  [["←", "→"], "back and on by a hundredth of the shot; with Alt by a thousandth"],
  [[",", "."], "event before, next event"],
  [["d"], "first divergence, then the next"],
  [["Home", "End"], "start, end"],
  [["[", "]"], "slower, faster"],
  [["v"], "next camera"],
  [["t"], "trails"],
  [["Shift + arrows"], "turn and tilt the camera"],
  [["+", "−", "0"], "closer, farther, the whole table"],
  [["?"], "this list"],
];

/** The list of keys, closed. */
export function list(): HTMLDetailsElement {
  const rows = LIST.map(([keys, what]) => make("div", {}, make("dt", {}, ...keys.map((key) => make("kbd", {}, key))), make("dd", {}, what)));
  return make("details", { class: "rp-keys" }, make("summary", {}, "Keys"), make("dl", {}, ...rows));
}

/** What keys need besides the actions. */
export interface Reach {
  actions: Actions;
  view(): View | null;
  end(): number;
  nextCamera(): void;
  toggleTrails(): void;
  camera(): Camera;
  again(): void;
  keys: HTMLDetailsElement;
}

/** Hears the keys pressed within an element. */
export function hear(element: HTMLElement, reach: Reach): void {
  element.addEventListener("keydown", (event) => {
    if (!event.ctrlKey && !event.metaKey && press(event, reach)) {
      event.preventDefault();
    }
  });
}

/** True where the key did something. */
function press(event: KeyboardEvent, reach: Reach): boolean {
  const { actions } = reach;
  const target = event.target as HTMLElement;
  // lists, buttons and boxes keep their own keys
  const own = target.closest("select, button, summary, input:not([type=range])");
  if (own && (own.matches("select") || event.key === " " || event.key === "Enter" || (event.key.startsWith("Arrow") && own.matches("input")))) {
    return false;
  }
  const ways: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  const way = ways[event.key];
  if (way && event.shiftKey) {
    reach.view()?.orbit(0.04 * way[0], 0.04 * way[1]);
    reach.again();
    return true;
  }
  if (way && (way[0] !== 0 || target.matches("input[type=range]"))) {
    actions.nudge((way[0] - way[1]) * (event.altKey ? 0.001 : 0.01));
    return true;
  }
  const doing: Record<string, () => void> = {
    " ": () => actions.toggle(),
    ".": () => actions.event(1),
    ",": () => actions.event(-1),
    d: () => actions.parting(),
    Home: () => actions.seek(0),
    End: () => actions.seek(reach.end()),
    PageUp: () => actions.nudge(0.1),
    PageDown: () => actions.nudge(-0.1),
    "[": () => actions.faster(-1),
    "]": () => actions.faster(1),
    v: () => reach.nextCamera(),
    t: () => reach.toggleTrails(),
    "+": () => near(reach, 0.85),
    "=": () => near(reach, 0.85),
    "-": () => near(reach, 1 / 0.85),
    "0": () => near(reach, 0),
    "?": () => void (reach.keys.open = !reach.keys.open),
  };
  const done = doing[event.key];
  done?.();
  return done !== undefined;
}

/** Closer by a factor; 0 shows the whole again. */
function near(reach: Reach, factor: number): void {
  if (factor === 0) {
    reach.actions.look(reach.camera());
  } else {
    reach.view()?.zoom(factor);
    reach.again();
  }
}
