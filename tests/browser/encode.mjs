// Writes replay data, format 1, as `report/replay.rs` does: for scenes whose motion is known in closed form.
import { deflateRawSync } from "node:zlib";

/** A knot: time, position, velocity and spin in the scene's units. */
export const knot = (time, position, velocity = [0, 0, 0], spin = [0, 0, 0]) => ({ time, position, velocity, spin });

/** base64 of the columns of all balls' knots. */
export function pack(paths, { origin, R, speedScale, rotates }) {
  const knots = paths.flat();
  const columns = [
    knots.map((k) => k.time),
    ...[0, 1, 2].map((axis) => knots.map((k) => (k.position[axis] - origin[axis]) / R)),
    ...[0, 1, 2].map((axis) => knots.map((k) => k.velocity[axis] / speedScale)),
    ...(rotates ? [0, 1, 2].map((axis) => knots.map((k) => (k.spin[axis] * R) / speedScale)) : []),
  ];
  return deflateRawSync(Buffer.concat(columns.map(shuffled))).toString("base64");
}

/** A column as f32, little-endian, its bytes sorted by plane. */
function shuffled(values) {
  const plain = Buffer.from(Float32Array.from(values).buffer);
  const out = Buffer.alloc(plain.length);
  for (let i = 0; i < values.length; i += 1) {
    for (let plane = 0; plane < 4; plane += 1) {
      out[plane * values.length + i] = plain[4 * i + plane];
    }
  }
  return out;
}

/** Replay data of a scene. `runs`: label, engine, reference, paths, events, ending. */
export function replay({ name, title, balls, runs, origin = [0, 0, 0], R, speedScale, rotates = false, table = null, pockets = [], partings = [], horizon = null, divergence = [], lengthUnit = "m" }) {
  const end = (paths) => Math.max(...paths.flat().map((k) => k.time));
  return {
    format: 1,
    scene: { name, title, duration: 60, length_unit: lengthUnit, time_unit: "s", speed_scale: speedScale },
    origin,
    R,
    table,
    pockets,
    rotates,
    balls,
    runs: runs.map((run) => ({
      label: run.label,
      engine: run.engine ?? run.label.split(" ")[0],
      reference: run.reference ?? false,
      end: run.end ?? end(run.paths),
      ending: run.ending ?? "at rest",
      resolution: run.resolution ?? 0,
      events: run.events ?? [],
      knots: { counts: run.paths.map((path) => path.length), left_out: 0, tolerance: 0, bytes: pack(run.paths, { origin, R, speedScale, rotates }) },
    })),
    partings,
    horizon,
    divergence,
  };
}
