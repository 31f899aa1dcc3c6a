// The place of the shot in units of R about the origin: table, pockets, cloth, and what of it is worth looking at.
import type { ReplayData } from "./format.ts";
import type { Run } from "./run.ts";

export interface Rect {
  x0: number;
  y0: number;
  x1: number;
  y1: number;
}

export interface Pocket {
  x: number;
  y: number;
  r: number;
}

export interface Stage {
  data: ReplayData;
  runs: Run[];
  /** Edges of the playing surface; null on an unbounded plane. */
  table: Rect | null;
  pockets: Pocket[];
  /** The cloth that is drawn: the table, or a piece of plane that all paths fit on. */
  cloth: Rect;
  /** What a camera should have in view: the whole table with its rails, or the balls where those are lost on it. */
  sight: Rect;
  /** Height of the cloth. */
  floor: number;
  /** Radii of the balls, R. */
  radii: Float64Array;
  /** Longest run, s. */
  end: number;
}

/** Widths of the cushion and of the wood behind it, R. */
export const CUSHION = 1.25;
export const WOOD = 2.9;

export const CLOTH = "#12694f";

/** A table this many times larger than all that moves on it, and this large in R, is not shown whole. */
const LOST = 4;
const LARGE = 90;

export function stage(data: ReplayData, runs: Run[]): Stage {
  const [ox, oy] = data.origin;
  const within = (x: number, y: number): [number, number] => [(x - ox) / data.R, (y - oy) / data.R];
  const radii = Float64Array.from(data.balls, (ball) => ball.radius / data.R);
  const pockets = data.pockets.map(([x, y, r]) => {
    const [px, py] = within(x, y);
    return { x: px, y: py, r: r / data.R };
  });
  const { moved, floor } = reach(runs, radii);
  let table: Rect | null = null;
  if (data.table) {
    const [x0, y0] = within(...data.table.min);
    const [x1, y1] = within(...data.table.max);
    table = { x0, y0, x1, y1 };
  }
  const plane = grow(moved, Math.max(4, 0.12 * Math.max(moved.x1 - moved.x0, moved.y1 - moved.y0)));
  const whole = table ? grow(table, CUSHION + WOOD) : plane;
  const action = grow(moved, 6);
  const sizes = [whole, action].map((rect) => Math.max(rect.x1 - rect.x0, rect.y1 - rect.y0));
  const lost = sizes[0] > LARGE && sizes[0] > LOST * sizes[1];
  const end = Math.max(0, ...runs.map((run) => run.facts.end));
  return { data, runs, table, pockets, cloth: table ?? plane, sight: lost ? action : whole, floor, radii, end };
}

export function grow(rect: Rect, by: number): Rect {
  return { x0: rect.x0 - by, y0: rect.y0 - by, x1: rect.x1 + by, y1: rect.y1 + by };
}

/** The rectangle that every ball stays in, and the lowest height that one reaches. */
function reach(runs: Run[], radii: Float64Array): { moved: Rect; floor: number } {
  const moved = { x0: Infinity, y0: Infinity, x1: -Infinity, y1: -Infinity };
  let floor = Infinity;
  for (const run of runs) {
    run.paths.forEach((path, ball) => {
      const r = radii[ball];
      for (let i = 0; i < path.positions.length; i += 3) {
        const [x, y, z] = [path.positions[i], path.positions[i + 1], path.positions[i + 2]];
        // an engine that lost its numbers says so; the others are shown
        if (!Number.isFinite(x + y + z)) {
          continue;
        }
        moved.x0 = Math.min(moved.x0, x - r);
        moved.y0 = Math.min(moved.y0, y - r);
        moved.x1 = Math.max(moved.x1, x + r);
        moved.y1 = Math.max(moved.y1, y + r);
        floor = Math.min(floor, z - r);
      }
    });
  }
  if (!Number.isFinite(moved.x1 - moved.x0 + moved.y1 - moved.y0)) {
    return { moved: { x0: -10, y0: -10, x1: 10, y1: 10 }, floor: 0 };
  }
  return { moved, floor: Number.isFinite(floor) ? floor : 0 };
}

/** Places of the sights on the rails: quarters of the short side, and as far apart on the long one; none where a pocket is. */
export function sights(edge: Rect, stage: Stage): [number, number][] {
  const [wide, long] = [edge.x1 - edge.x0, edge.y1 - edge.y0];
  const gap = Math.min(wide, long) / 4;
  const out = CUSHION + 0.55 * WOOD;
  const places: [number, number][] = [];
  const [nx, ny] = [Math.min(64, Math.round(wide / gap)), Math.min(64, Math.round(long / gap))];
  for (let i = 1; i < nx; i += 1) {
    places.push([edge.x0 + (wide * i) / nx, edge.y0 - out], [edge.x0 + (wide * i) / nx, edge.y1 + out]);
  }
  for (let i = 1; i < ny; i += 1) {
    places.push([edge.x0 - out, edge.y0 + (long * i) / ny], [edge.x1 + out, edge.y0 + (long * i) / ny]);
  }
  return places.filter(([x, y]) => stage.pockets.every((pocket) => Math.hypot(pocket.x - x, pocket.y - y) > pocket.r + 1.6));
}
