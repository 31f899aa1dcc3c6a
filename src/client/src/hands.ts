// Mouse and touch on the picture: drag to turn, two fingers or the wheel to come closer, a tap to choose a ball.
import type { View } from "./view.ts";

/** A press that moves less than this is a tap, px. */
const TAP = 5;

export interface Touch {
  view(): View | null;
  /** The picture must be drawn again. */
  again(): void;
  choose(ball: number): void;
}

/** Listens on the frame around the picture, which stays while the canvas in it may change. */
export function hands(frame: HTMLElement, touch: Touch): void {
  const down = new Map<number, { x: number; y: number }>();
  let moved = 0;
  let spread = 0;
  frame.addEventListener("pointerdown", (event) => {
    down.set(event.pointerId, { x: event.clientX, y: event.clientY });
    moved = down.size === 1 ? 0 : TAP;
    spread = 0;
    frame.setPointerCapture(event.pointerId);
  });
  frame.addEventListener("pointermove", (event) => {
    const from = down.get(event.pointerId);
    const view = touch.view();
    if (!from || !view) {
      return;
    }
    const [dx, dy] = [event.clientX - from.x, event.clientY - from.y];
    moved += Math.hypot(dx, dy);
    down.set(event.pointerId, { x: event.clientX, y: event.clientY });
    const { width, height } = frame.getBoundingClientRect();
    if (down.size === 1) {
      if (event.shiftKey || (event.buttons & 2) !== 0) {
        view.pan(-dx / height, dy / height);
      } else {
        view.orbit(dx / width, dy / height);
      }
    } else {
      const [a, b] = [...down.values()];
      const now = Math.hypot(a.x - b.x, a.y - b.y);
      if (spread > 0 && now > 0) {
        view.zoom(spread / now);
      }
      spread = now;
      view.pan(-dx / 2 / height, dy / 2 / height);
    }
    touch.again();
  });
  const up = (event: PointerEvent): void => {
    if (down.delete(event.pointerId) && moved < TAP && event.type === "pointerup") {
      const box = frame.getBoundingClientRect();
      touch.choose(touch.view()?.pick(event.clientX - box.left, event.clientY - box.top) ?? -1);
    }
    spread = 0;
  };
  frame.addEventListener("pointerup", up);
  frame.addEventListener("pointercancel", up);
  frame.addEventListener("contextmenu", (event) => event.preventDefault());
  frame.addEventListener(
    "wheel",
    (event) => {
      // a reader who scrolls by must not be caught: the wheel zooms where the picture has the focus, or with Ctrl
      if (event.ctrlKey || document.activeElement === frame) {
        event.preventDefault();
        touch.view()?.zoom(Math.exp(0.0015 * event.deltaY));
        touch.again();
      }
    },
    { passive: false },
  );
}
