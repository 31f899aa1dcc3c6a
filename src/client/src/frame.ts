// Where every ball of every run is at one time: what both ways of drawing draw.
import { motion } from "./path.ts";
import type { Run } from "./run.ts";
import type { Stage } from "./stage.ts";
import type { Quaternion } from "./turning.ts";

/** One run at one time. */
export interface Scatter {
  run: Run;
  /** Centres, triples, R. */
  positions: Float64Array;
  /** Velocities, triples, R/s. */
  velocities: Float64Array;
  /** Spins, triples, rad/s. */
  spins: Float64Array;
  /** Orientations, fours; the identity where balls do not turn. */
  orientations: Float64Array;
  /** 1 for balls in play. */
  present: Uint8Array;
}

export class Frame {
  time = 0;
  readonly scatters: Scatter[];
  private readonly motion = motion();
  private readonly quaternion: Quaternion = new Float64Array(4);

  constructor(private readonly stage: Stage) {
    const n = stage.data.balls.length;
    this.scatters = stage.runs.map((run) => ({
      run,
      positions: new Float64Array(3 * n),
      velocities: new Float64Array(3 * n),
      spins: new Float64Array(3 * n),
      orientations: new Float64Array(4 * n).map((_, i) => (i % 4 === 3 ? 1 : 0)),
      present: new Uint8Array(n),
    }));
  }

  /** Moves to time t. */
  go(t: number): void {
    this.time = t;
    const { motion: m, quaternion: q, stage } = this;
    for (const scatter of this.scatters) {
      const { run } = scatter;
      for (let ball = 0; ball < stage.radii.length; ball += 1) {
        const path = run.paths[ball];
        const there = path !== undefined && path.at(t, m);
        scatter.present[ball] = there && t < run.leaves[ball] ? 1 : 0;
        if (there) {
          scatter.positions.set(m.position, 3 * ball);
          scatter.velocities.set(m.velocity, 3 * ball);
          scatter.spins.set(m.spin, 3 * ball);
        }
        if (stage.data.rotates && there) {
          run.turnings[ball].at(t, q);
          scatter.orientations.set(q, 4 * ball);
        }
      }
    }
  }
}
