// Unpacks the knots of a run: base64, deflate-raw, byte planes, columns.
//
// A column holds one quantity of all balls one after another, as little-endian f32 whose bytes are sorted by plane: all first
// bytes, then all second bytes, and so on.
import type { Knots, ReplayData } from "./format.ts";
import { Path } from "./path.ts";

/** Names of the columns in their order; the last three only where balls turn. */
const COLUMNS = 7;
const COLUMNS_WITH_SPIN = 10;

/** The paths of a run, one a ball, in R, R/s and rad/s. Rejects where the bytes are not what the counts promise. */
export async function unpack(knots: Knots, data: ReplayData): Promise<Path[]> {
  const total = knots.counts.reduce((sum, count) => sum + count, 0);
  const columns = data.rotates ? COLUMNS_WITH_SPIN : COLUMNS;
  const bytes = await inflate(decode(knots.bytes));
  if (bytes.length !== total * columns * 4) {
    throw new Error(`the knots hold ${bytes.length} bytes where ${total} knots of ${columns} columns need ${total * columns * 4}`);
  }
  // speeds come in units of the initial speed; the component counts in R/s
  const rate = data.scene.speed_scale / data.R;
  const column = (index: number, unit: number): Float64Array => values(bytes, index * total, total, unit);
  const times = column(0, 1);
  const place = [1, 2, 3].map((index) => column(index, 1));
  const velocity = [4, 5, 6].map((index) => column(index, rate));
  const spin = data.rotates ? [7, 8, 9].map((index) => column(index, rate)) : [];
  let from = 0;
  return knots.counts.map((count) => {
    const to = from + count;
    const part = (whole: Float64Array): Float64Array => whole.subarray(from, to);
    const path = new Path(part(times), interleave(place.map(part)), interleave(velocity.map(part)), interleave(spin.map(part)));
    from = to;
    return path;
  });
}

function decode(base64: string): Uint8Array<ArrayBuffer> {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i += 1) {
    bytes[i] = text.charCodeAt(i);
  }
  return bytes;
}

async function inflate(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** One column from its four byte planes; `first`: knots before it. */
function values(bytes: Uint8Array, first: number, count: number, unit: number): Float64Array {
  const plane = (index: number): number => first * 4 + index * count;
  const [p0, p1, p2, p3] = [plane(0), plane(1), plane(2), plane(3)];
  const word = new DataView(new ArrayBuffer(4));
  const out = new Float64Array(count);
  for (let i = 0; i < count; i += 1) {
    const bits = (bytes[p3 + i] << 24) | (bytes[p2 + i] << 16) | (bytes[p1 + i] << 8) | bytes[p0 + i];
    word.setInt32(0, bits);
    out[i] = word.getFloat32(0) * unit;
  }
  return out;
}

/** Three columns as one array of triples; none as an empty array. */
function interleave(columns: Float64Array[]): Float64Array {
  const [x, y, z] = columns;
  if (!x) {
    return new Float64Array(0);
  }
  const out = new Float64Array(3 * x.length);
  for (let i = 0; i < x.length; i += 1) {
    out[3 * i] = x[i];
    out[3 * i + 1] = y[i];
    out[3 * i + 2] = z[i];
  }
  return out;
}
