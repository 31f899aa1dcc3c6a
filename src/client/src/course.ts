// The way of a ball over the cloth as a line, and where events left their marks: shared by both ways of drawing.
import { motion, type Path } from "./path.ts";
import type { Run } from "./run.ts";
import type { Stage } from "./stage.ts";

/** Largest change of direction between two points of a line, rad, and most points of one piece. */
const BEND = 0.06;
const MOST = 24;

/** Points of a ball's way: time, x, y, by threes. A jump is two points at one time. */
export function course(path: Path, until: number): Float64Array {
  const out: number[] = [];
  const m = motion();
  const { times, positions, velocities } = path;
  for (let knot = 0; knot < path.count && times[knot] <= until; knot += 1) {
    const [x, y] = [positions[3 * knot], positions[3 * knot + 1]];
    const last = out.length - 3;
    const same = last >= 0 && out[last + 1] === x && out[last + 2] === y;
    if (!same || knot + 1 === path.count) {
      out.push(times[knot], x, y);
    } else {
      out[last] = times[knot];
    }
    const h = knot + 1 < path.count ? times[knot + 1] - times[knot] : 0;
    if (h > 0) {
      const bend = angle(velocities, 3 * knot, 3 * knot + 3);
      const cuts = Math.min(MOST, Math.ceil(bend / BEND));
      for (let cut = 1; cut < cuts; cut += 1) {
        const t = times[knot] + (h * cut) / cuts;
        path.at(t, m);
        out.push(t, m.position[0], m.position[1]);
      }
    }
  }
  return Float64Array.from(out);
}

function angle(v: Float64Array, a: number, b: number): number {
  const cross = v[a] * v[b + 1] - v[a + 1] * v[b];
  const dot = v[a] * v[b] + v[a + 1] * v[b + 1];
  return Math.abs(Math.atan2(cross, dot));
}

/** How long the ring of a hit is seen, s at 1x. */
export const LIFE = 0.45;

/** One mark on the cloth: where and when something was hit, and how large its ring starts. */
export interface Mark {
  at: number;
  x: number;
  y: number;
  r: number;
}

/** Rings of all hits and falls of a run. */
export function marks(stage: Stage, run: Run): Mark[] {
  const order = new Map(stage.data.balls.map((ball, index) => [ball.id, index]));
  const [m, n] = [motion(), motion()];
  const found: Mark[] = [];
  for (const event of run.events) {
    const a = order.get(event.a);
    if (a === undefined || !run.paths[a]?.at(event.at, m)) {
      continue;
    }
    const [x, y, r] = [m.position[0], m.position[1], stage.radii[a]];
    const b = order.get(event.b);
    if (event.kind === "ball-ball" && b !== undefined && run.paths[b]?.at(event.at, n)) {
      const part = r / (r + stage.radii[b]);
      found.push({ at: event.at, x: x + part * (n.position[0] - x), y: y + part * (n.position[1] - y), r: 1.25 * Math.max(r, stage.radii[b]) });
    } else if (event.kind === "ball-cushion") {
      const way: Record<string, [number, number]> = { x0: [-r, 0], x1: [r, 0], y0: [0, -r], y1: [0, r] };
      const [dx, dy] = way[event.b] ?? [0, 0];
      found.push({ at: event.at, x: x + dx, y: y + dy, r: 0.8 * r });
    } else if (event.kind === "pocket") {
      found.push({ at: event.at, x, y, r: 1.6 * r });
    }
  }
  return found;
}
