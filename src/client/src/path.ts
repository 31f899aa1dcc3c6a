// The path of one ball: knots, and the motion between them.
//
// Between two knots the position is the cubic through both ends and velocity and spin are linear, as in the traces of the
// engines. Two knots at one time are the near and the far side of a jump. Lengths in R, speeds in R/s, spins in rad/s.

/** What can be asked of a ball at a time; filled in place, so that playing allocates nothing. */
export interface Motion {
  position: Float64Array;
  velocity: Float64Array;
  spin: Float64Array;
}

export function motion(): Motion {
  return { position: new Float64Array(3), velocity: new Float64Array(3), spin: new Float64Array(3) };
}

export class Path {
  /** Knots up to the last one asked for: playing forward finds the next at once. */
  private hint = 0;

  constructor(
    /** s, non-decreasing. */
    readonly times: Float64Array,
    /** Triples, one a knot. */
    readonly positions: Float64Array,
    readonly velocities: Float64Array,
    /** Triples, or empty where balls do not turn. */
    readonly spins: Float64Array,
  ) {}

  get count(): number {
    return this.times.length;
  }

  /** Knots with a time <= t; with `near`, < t. */
  knotsUntil(t: number, near = false): number {
    const { times } = this;
    const passed = (i: number): boolean => (near ? times[i] < t : times[i] <= t);
    let at = this.hint;
    if ((at === 0 || passed(at - 1)) && (at === times.length || !passed(at))) {
      return at;
    }
    if (at < times.length && passed(at) && (at + 1 === times.length || !passed(at + 1))) {
      return (this.hint = at + 1);
    }
    let low = 0;
    let high = times.length;
    while (low < high) {
      at = (low + high) >> 1;
      if (passed(at)) {
        low = at + 1;
      } else {
        high = at;
      }
    }
    return (this.hint = low);
  }

  /** The motion at t; with `near`, its near side where t is a jump. Before the first and after the last knot: that knot, at rest
   * in what it is. False where the path holds no knot. */
  at(t: number, out: Motion, near = false): boolean {
    const { times } = this;
    if (times.length === 0) {
      return false;
    }
    const next = this.knotsUntil(t, near);
    if (near && next < times.length && times[next] === t) {
      this.copy(next, out);
    } else if (next === 0 || next === times.length) {
      this.copy(next === 0 ? 0 : next - 1, out);
    } else {
      this.between(next - 1, t, out);
    }
    return true;
  }

  private copy(knot: number, out: Motion): void {
    for (let axis = 0; axis < 3; axis += 1) {
      out.position[axis] = this.positions[3 * knot + axis];
      out.velocity[axis] = this.velocities[3 * knot + axis];
      out.spin[axis] = this.spins.length > 0 ? this.spins[3 * knot + axis] : 0;
    }
  }

  private between(knot: number, t: number, out: Motion): void {
    const { times, positions, velocities, spins } = this;
    const h = times[knot + 1] - times[knot];
    const s = (t - times[knot]) / h;
    const [s2, s3] = [s * s, s * s * s];
    const [a, b] = [3 * knot, 3 * knot + 3];
    for (let axis = 0; axis < 3; axis += 1) {
      out.position[axis] =
        positions[a + axis] * (2 * s3 - 3 * s2 + 1) +
        velocities[a + axis] * (h * (s3 - 2 * s2 + s)) +
        positions[b + axis] * (3 * s2 - 2 * s3) +
        velocities[b + axis] * (h * (s3 - s2));
      out.velocity[axis] = velocities[a + axis] + s * (velocities[b + axis] - velocities[a + axis]);
      out.spin[axis] = spins.length > 0 ? spins[a + axis] + s * (spins[b + axis] - spins[a + axis]) : 0;
    }
  }
}
