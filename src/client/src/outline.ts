// A rectangle with round pockets cut into its edge.
import type { Pocket, Rect } from "./stage.ts";

/** Part of a pocket's circle that lies outside the rectangle: counter-clockwise from `from` by `sweep`, rad. */
export interface Arc {
  pocket: Pocket;
  from: number;
  sweep: number;
}

/** A straight part of the edge, counter-clockwise; ends that meet a pocket, and ends that meet a corner. */
export interface Straight {
  x0: number;
  y0: number;
  x1: number;
  y1: number;
  /** Whether it starts, and ends, at a pocket. */
  pocketBefore: boolean;
  pocketAfter: boolean;
}

export interface Outline {
  /** Closed polygon, counter-clockwise. */
  points: [number, number][];
  arcs: Arc[];
  straights: Straight[];
}

interface Crossing {
  /** Way along the edge from (x0, y0). */
  at: number;
  enters: boolean;
  pocket: Pocket;
  x: number;
  y: number;
}

const ARC_STEPS = 28;

/** The union of the rectangle and the circles that cross its edge. Circles that overlap one another are left out. */
export function outline(rect: Rect, pockets: Pocket[]): Outline {
  const apart = pockets.every((a) => pockets.every((b) => a === b || Math.hypot(a.x - b.x, a.y - b.y) > a.r + b.r));
  const corners: [number, number][] = [
    [rect.x0, rect.y0],
    [rect.x1, rect.y0],
    [rect.x1, rect.y1],
    [rect.x0, rect.y1],
  ];
  const crossings: Crossing[] = [];
  let begin = 0;
  const starts: number[] = [];
  for (let edge = 0; edge < 4; edge += 1) {
    const [ax, ay] = corners[edge];
    const [bx, by] = corners[(edge + 1) % 4];
    const length = Math.hypot(bx - ax, by - ay);
    const [ux, uy] = [(bx - ax) / length, (by - ay) / length];
    starts.push(begin);
    for (const pocket of apart ? pockets : []) {
      const along = (pocket.x - ax) * ux + (pocket.y - ay) * uy;
      const off = (pocket.x - ax) * uy - (pocket.y - ay) * ux;
      if (Math.abs(off) >= pocket.r) {
        continue;
      }
      const half = Math.sqrt(pocket.r * pocket.r - off * off);
      for (const enters of [true, false]) {
        const at = along + (enters ? -half : half);
        if (at >= 0 && at <= length) {
          crossings.push({ at: begin + at, enters, pocket, x: ax + at * ux, y: ay + at * uy });
        }
      }
    }
    begin += length;
  }
  crossings.sort((a, b) => a.at - b.at);
  const alternate = crossings.every((crossing, i) => crossing.enters !== crossings[(i + 1) % crossings.length].enters);
  return walk(corners, starts, alternate && crossings.length > 1 ? crossings : []);
}

function walk(corners: [number, number][], starts: number[], crossings: Crossing[]): Outline {
  const found: Outline = { points: [], arcs: [], straights: [] };
  const corner = (edge: number): Crossing => ({ at: starts[edge], enters: false, pocket: { x: 0, y: 0, r: 0 }, x: corners[edge][0], y: corners[edge][1] });
  if (crossings.length === 0) {
    for (let edge = 0; edge < 4; edge += 1) {
      join(found, corner(edge), corner((edge + 1) % 4), false, false);
    }
    return found;
  }
  const first = crossings.findIndex((crossing) => !crossing.enters);
  for (let i = 0; i < crossings.length; i += 2) {
    const leave = crossings[(first + i) % crossings.length];
    const enter = crossings[(first + i + 1) % crossings.length];
    // the straight way from one pocket to the next, around the corners in between
    const passed = starts
      .map((at, edge) => ({ at, edge }))
      .filter(({ at }) => (leave.at < enter.at ? at > leave.at && at < enter.at : at > leave.at || at < enter.at))
      .sort((a, b) => order(a.at, leave.at) - order(b.at, leave.at));
    let from = leave;
    let pocketBefore = true;
    for (const { edge } of passed) {
      join(found, from, corner(edge), pocketBefore, false);
      from = corner(edge);
      pocketBefore = false;
    }
    join(found, from, enter, pocketBefore, true);
    const exit = crossings[(first + i + 2) % crossings.length];
    const { pocket } = enter;
    const begin = Math.atan2(enter.y - pocket.y, enter.x - pocket.x);
    let sweep = Math.atan2(exit.y - pocket.y, exit.x - pocket.x) - begin;
    sweep += sweep <= 0 ? 2 * Math.PI : 0;
    found.arcs.push({ pocket, from: begin, sweep });
    for (let k = 0; k < ARC_STEPS; k += 1) {
      const angle = begin + (sweep * k) / ARC_STEPS;
      found.points.push([pocket.x + pocket.r * Math.cos(angle), pocket.y + pocket.r * Math.sin(angle)]);
    }
  }
  return found;
}

/** Way along the edge after `from`, around the end. */
function order(at: number, from: number): number {
  return at > from ? at : at + 1e12;
}

function join(found: Outline, from: Crossing, to: Crossing, pocketBefore: boolean, pocketAfter: boolean): void {
  found.points.push([from.x, from.y]);
  if (Math.hypot(to.x - from.x, to.y - from.y) > 1e-9) {
    found.straights.push({ x0: from.x, y0: from.y, x1: to.x, y1: to.y, pocketBefore, pocketAfter });
  }
}
