// How a ball has turned: its spin, integrated from the start.
//
// Spin is linear between knots, and the rotation over a piece of it is the exponential of Magnus' series up to its second term,
// h (w0 + w1)/2 + h^2/12 w1 x w0, which is exact where the axis stays and of fourth order where it turns. Where the axis turns,
// pieces are cut so that a ball turns by no more than TURN in one.
import type { Path } from "./path.ts";

/** Largest angle of one piece where the axis turns, rad. */
const TURN = 0.5;
/** Most pieces between two knots. */
const PIECES = 4096;

/** A rotation as x, y, z, w. */
export type Quaternion = Float64Array;

/** The rotation by the vector (x, y, z), in rad, after what `q` has turned; in place. */
export function turn(q: Quaternion, x: number, y: number, z: number): void {
  const angle = Math.hypot(x, y, z);
  const k = angle > 1e-8 ? Math.sin(angle / 2) / angle : 0.5;
  const [ax, ay, az, aw] = [k * x, k * y, k * z, Math.cos(angle / 2)];
  const [bx, by, bz, bw] = q;
  q[0] = aw * bx + ax * bw + ay * bz - az * by;
  q[1] = aw * by - ax * bz + ay * bw + az * bx;
  q[2] = aw * bz + ax * by - ay * bx + az * bw;
  q[3] = aw * bw - ax * bx - ay * by - az * bz;
  const norm = Math.hypot(q[0], q[1], q[2], q[3]);
  for (let i = 0; i < 4; i += 1) {
    q[i] /= norm;
  }
}

/** Turns by the spin that goes from `a` to `b` (offsets of triples in `spins`) over the part s0..s1 of a piece of length h. */
function piece(q: Quaternion, spins: Float64Array, a: number, b: number, h: number, s0: number, s1: number): void {
  const at = (axis: number, s: number): number => spins[a + axis] + s * (spins[b + axis] - spins[a + axis]);
  const [x0, y0, z0] = [at(0, s0), at(1, s0), at(2, s0)];
  const [x1, y1, z1] = [at(0, s1), at(1, s1), at(2, s1)];
  const dt = h * (s1 - s0);
  const k = (dt * dt) / 12;
  turn(
    q,
    (dt * (x0 + x1)) / 2 + k * (y1 * z0 - z1 * y0),
    (dt * (y0 + y1)) / 2 + k * (z1 * x0 - x1 * z0),
    (dt * (z0 + z1)) / 2 + k * (x1 * y0 - y1 * x0),
  );
}

/** The orientation of one ball over its path. */
export class Turning {
  /** Times of the nodes, s, and the orientation at each: every knot, and the cuts of pieces whose axis turns. */
  private readonly times: number[] = [];
  private readonly nodes: number[] = [];
  /** The knot that each node follows, and how far beyond it, as a part of the piece. */
  private readonly knots: number[] = [];
  private readonly parts: number[] = [];
  private hint = 0;

  constructor(private readonly path: Path) {
    const { times, spins, count } = path;
    const q = new Float64Array([0, 0, 0, 1]);
    for (let knot = 0; knot < count; knot += 1) {
      this.push(times[knot], knot, 0, q);
      const h = knot + 1 < count ? times[knot + 1] - times[knot] : 0;
      if (h > 0 && spins.length > 0) {
        const [a, b] = [3 * knot, 3 * knot + 3];
        const cuts = pieces(spins, a, b, h);
        for (let cut = 1; cut <= cuts; cut += 1) {
          piece(q, spins, a, b, h, (cut - 1) / cuts, cut / cuts);
          if (cut < cuts) {
            this.push(times[knot] + (h * cut) / cuts, knot, cut / cuts, q);
          }
        }
      }
    }
  }

  /** The orientation at t, into `out`. */
  at(t: number, out: Quaternion): void {
    const { times, nodes, path } = this;
    const last = times.length - 1;
    if (last < 0 || path.spins.length === 0) {
      out.set([0, 0, 0, 1]);
      return;
    }
    const node = this.find(t);
    for (let i = 0; i < 4; i += 1) {
      out[i] = nodes[4 * node + i];
    }
    const knot = this.knots[node];
    if (t > times[node] && knot + 1 < path.count) {
      const h = path.times[knot + 1] - path.times[knot];
      const s = Math.min(1, (t - path.times[knot]) / h);
      piece(out, path.spins, 3 * knot, 3 * knot + 3, h, this.parts[node], s);
    }
  }

  private push(time: number, knot: number, part: number, q: Quaternion): void {
    this.times.push(time);
    this.knots.push(knot);
    this.parts.push(part);
    this.nodes.push(q[0], q[1], q[2], q[3]);
  }

  /** The last node with a time <= t, or the first. */
  private find(t: number): number {
    const { times } = this;
    const here = this.hint;
    if (times[here] <= t && (here + 1 === times.length || times[here + 1] > t)) {
      return here;
    }
    let low = 0;
    let high = times.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (times[middle] <= t) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return (this.hint = Math.max(0, low - 1));
  }
}

/** Into how many parts a piece is cut: one where the axis stays. */
function pieces(spins: Float64Array, a: number, b: number, h: number): number {
  const [x0, y0, z0, x1, y1, z1] = [spins[a], spins[a + 1], spins[a + 2], spins[b], spins[b + 1], spins[b + 2]];
  const cross = Math.hypot(y1 * z0 - z1 * y0, z1 * x0 - x1 * z0, x1 * y0 - y1 * x0);
  const [n0, n1] = [Math.hypot(x0, y0, z0), Math.hypot(x1, y1, z1)];
  if (cross <= 1e-9 * n0 * n1) {
    return 1;
  }
  return Math.min(PIECES, Math.max(1, Math.ceil((h * Math.max(n0, n1)) / TURN)));
}
