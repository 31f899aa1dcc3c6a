// What both ways of drawing the table have in common.
import type { Frame } from "./frame.ts";
import type { Rect } from "./stage.ts";

export type Camera = "above" | "free" | "flat";

/** What the reader chose to see. */
export interface Choice {
  camera: Camera;
  /** Index of the run whose balls are solid. */
  solid: number;
  /** Which runs are shown, by index. */
  shown: boolean[];
  /** Every shown run on a table of its own. */
  apart: boolean;
  trails: boolean;
  marks: boolean;
  /** Index of the ball that the plots follow, -1 for none. */
  ball: number;
  /** Indices of the balls that a parting concerns. */
  called: number[];
}

/** A way of drawing. */
export interface View {
  readonly canvas: HTMLCanvasElement;
  /** Draws; true while the picture is still under way to where it should be. `rate`: scene seconds a second. */
  draw(frame: Frame, choice: Choice, rate: number, playing: boolean): boolean;
  /** Fits the picture into width x height CSS px. */
  resize(width: number, height: number): void;
  /** The ball at a place of the picture, CSS px; -1 for none. */
  pick(x: number, y: number): number;
  /** Takes a new camera of the choice, with everything in view. */
  look(choice: Choice): void;
  /** Comes close to a part of the cloth; null goes back to everything. */
  close(rect: Rect | null): void;
  /** Turns and tilts by parts of the picture, zooms by a factor, moves by parts of the picture. */
  orbit(right: number, down: number): void;
  zoom(factor: number): void;
  pan(right: number, up: number): void;
  dispose(): void;
}

/** The runs that get a table of their own, or the solid one alone. */
export function tables(choice: Choice): number[] {
  if (!choice.apart) {
    return [choice.solid];
  }
  const shown = choice.shown.flatMap((on, index) => (on || index === choice.solid ? [index] : []));
  return shown.length > 0 ? shown : [choice.solid];
}

/** The runs drawn as ghosts over a table. */
export function ghosts(choice: Choice, table: number): number[] {
  return choice.apart ? [] : choice.shown.flatMap((on, index) => (on && index !== table ? [index] : []));
}

/** The part of everything that a close look at `rect` shows: its share of the size, and its middle from the whole's. */
export function closeness(sight: Rect, rect: Rect): { zoom: number; x: number; y: number } {
  const [wide, tall] = [sight.x1 - sight.x0, sight.y1 - sight.y0];
  const zoom = Math.min(1, Math.max((rect.x1 - rect.x0) / wide, (rect.y1 - rect.y0) / tall));
  return { zoom, x: (rect.x0 + rect.x1 - sight.x0 - sight.x1) / 2, y: (rect.y0 + rect.y1 - sight.y0 - sight.y1) / 2 };
}

/** A part of the picture, CSS px. */
export interface Cell {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** The parts of the picture that `count` tables get, and whether their long side (y) lies across: whatever shows them largest. */
export function cells(sight: Rect, count: number, width: number, height: number): { cells: Cell[]; lying: boolean } {
  const [wide, tall] = [sight.x1 - sight.x0, sight.y1 - sight.y0];
  let best = { columns: 1, rows: count, lying: true, scale: 0 };
  for (let columns = 1; columns <= count; columns += 1) {
    const rows = Math.ceil(count / columns);
    for (const lying of [true, false]) {
      const [across, down] = lying ? [tall, wide] : [wide, tall];
      const scale = Math.min(width / columns / across, height / rows / down);
      if (scale > best.scale) {
        best = { columns, rows, lying, scale };
      }
    }
  }
  const [w, h] = [width / best.columns, height / best.rows];
  const all = Array.from({ length: count }, (_, i) => ({ x: (i % best.columns) * w, y: Math.floor(i / best.columns) * h, width: w, height: h }));
  return { cells: all, lying: best.lying };
}

/** The part that holds a place, or -1. */
export function cellAt(all: Cell[], x: number, y: number): number {
  return all.findIndex((cell) => x >= cell.x && x < cell.x + cell.width && y >= cell.y && y < cell.y + cell.height);
}

/** How far a ghost is from the solid ball for it to be seen at all, and to be seen in full, R. */
const HIDDEN = 0.03;
const PLAIN = 0.4;

/** How much of a ghost is seen: none where it is where the solid ball is. */
export function apartness(a: Float64Array, b: Float64Array, ball: number): number {
  const d = Math.hypot(a[3 * ball] - b[3 * ball], a[3 * ball + 1] - b[3 * ball + 1], a[3 * ball + 2] - b[3 * ball + 2]);
  const s = Math.min(1, Math.max(0, (d - HIDDEN) / (PLAIN - HIDDEN)));
  return s * s * (3 - 2 * s);
}
