// Speed and energy over time, from the knots: what the plots draw.
import type { ReplayData } from "./format.ts";
import { motion } from "./path.ts";
import type { Run } from "./run.ts";

/** Most evaluations of a ball's motion for one set of curves, and fewest and most points of a curve between events. */
const MOST = 600_000;
const [FEW, PLENTY] = [60, 600];

/** Times at which curves are drawn: evenly spread, and both sides of every event. `near[i]`: the near side of a jump. */
export interface Times {
  at: Float64Array;
  near: Uint8Array;
}

export function times(data: ReplayData, runs: Run[], end: number): Times {
  const budget = MOST / Math.max(1, data.balls.length * runs.length);
  const even = Math.round(Math.min(PLENTY, Math.max(FEW, budget / 2)));
  const all = [...new Set(runs.flatMap((run) => run.events.map((event) => event.at)))].filter((at) => at > 0 && at < end).sort((a, b) => a - b);
  const stride = Math.max(1, Math.ceil((2 * all.length) / Math.max(1, budget - even)));
  const points: [number, number][] = [];
  for (let i = 0; i <= even; i += 1) {
    points.push([(end * i) / even, 0]);
  }
  for (let i = 0; i < all.length; i += stride) {
    points.push([all[i], 1], [all[i], 0]);
  }
  points.sort((a, b) => a[0] - b[0] || b[1] - a[1]);
  return { at: Float64Array.from(points, (point) => point[0]), near: Uint8Array.from(points, (point) => point[1]) };
}

/** Speeds in R/s and energies in the mass unit times (R/s)^2, at given times; NaN after the end of a run. */
export interface Curves {
  /** Root of the mean square of the speeds of balls in play. */
  rms: Float64Array;
  energy: Float64Array;
}

/** Kinetic energy and rms speed of the balls of a run in play. */
export function curves(data: ReplayData, run: Run, when: Times): Curves {
  const n = when.at.length;
  const squares = new Float64Array(n);
  const playing = new Float64Array(n);
  const energy = new Float64Array(n);
  const m = motion();
  data.balls.forEach((ball, index) => {
    const inertia = ball.inertia / (data.R * data.R);
    for (let i = 0; i < n; i += 1) {
      const t = when.at[i];
      const near = when.near[i] === 1;
      if ((near ? t > run.leaves[index] : t >= run.leaves[index]) || !run.paths[index]?.at(t, m, near)) {
        continue;
      }
      const v2 = square(m.velocity);
      squares[i] += v2;
      playing[i] += 1;
      energy[i] += (ball.mass * v2 + inertia * square(m.spin)) / 2;
    }
  });
  const rms = squares.map((sum, i) => (playing[i] > 0 ? Math.sqrt(sum / playing[i]) : 0));
  return { rms: cut(rms, when, run.facts.end), energy: cut(energy, when, run.facts.end) };
}

/** Speed of one ball, R/s; NaN once it has left play. */
export function speed(run: Run, ball: number, when: Times): Float64Array {
  const m = motion();
  const values = Float64Array.from(when.at, (t, i) => {
    const near = when.near[i] === 1;
    const gone = near ? t > run.leaves[ball] : t >= run.leaves[ball];
    return !gone && run.paths[ball]?.at(t, m, near) ? Math.sqrt(square(m.velocity)) : NaN;
  });
  return cut(values, when, run.facts.end);
}

function square(v: Float64Array): number {
  return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

/** A run that ended at rest stays as it is; what another would have gone on to do is not known. */
function cut(values: Float64Array, when: Times, end: number): Float64Array {
  const limit = Math.fround(end) * (1 + 1e-6);
  let last = NaN;
  return values.map((value, i) => {
    if (when.at[i] <= limit) {
      last = value;
      return value;
    }
    return last === 0 ? 0 : NaN;
  });
}

/** The value of a curve at time t, linear between its points; NaN where there is none. */
export function valueAt(at: ArrayLike<number>, values: ArrayLike<number | null | undefined>, t: number): number {
  let low = 0;
  let high = at.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (at[middle] <= t) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  if (low === 0) {
    return NaN;
  }
  const a = values[low - 1] ?? NaN;
  if (low === at.length || t === at[low - 1]) {
    return a;
  }
  const b = values[low] ?? NaN;
  return a + ((t - at[low - 1]) / (at[low] - at[low - 1])) * (b - a);
}
