// Scenes whose motion is known in closed form, as replay data.
import { knot, replay } from "./encode.mjs";

/** The cloth slows a sliding ball by mu g. */
const MU_G = 0.2 * 9.81;

/** One ball that slides from (x0, y0) along y and stops: y(t) = y0 + v t - mu g t^2 / 2. */
export const slide = { x0: 0.5, y0: 0.4, v: 1.8, a: MU_G, stop: 1.8 / MU_G };
slide.y = (t) => slide.y0 + slide.v * Math.min(t, slide.stop) - (slide.a * Math.min(t, slide.stop) ** 2) / 2;
slide.speed = (t) => Math.max(0, slide.v - slide.a * t);

const R = 0.03;
const TABLE = { min: [0, 0], max: [1, 2] };
const ball = (id) => ({ id, radius: R, mass: 0.17, inertia: 0 });

export function slidingBall(shift = [0, 0], scale = 1) {
  const at = (x, y) => [shift[0] + scale * x, shift[1] + scale * y, scale * R];
  const v = scale * slide.v;
  return replay({
    name: "slide",
    title: "A ball slides and stops",
    balls: [{ ...ball("cue"), radius: scale * R }],
    R: scale * R,
    origin: [shift[0] + 0.5 * scale, shift[1] + scale, 0],
    speedScale: v,
    table: { min: at(0, 0).slice(0, 2), max: at(1, 2).slice(0, 2) },
    runs: [
      {
        label: "exact",
        reference: true,
        paths: [[knot(0, at(slide.x0, slide.y0), [0, v, 0]), knot(slide.stop, at(slide.x0, slide.y(slide.stop)), [0, 0, 0])]],
        events: [[slide.stop, "stop", "cue", ""]],
      },
    ],
  });
}

/** Head on, equal masses, no cloth, elastic: the cue ball stops where it hits, the other goes on with its velocity. */
export const hit = { v: 1, from: 0.3, to: 1.0, time: (1.0 - 2 * R - 0.3) / 1, end: 1.6, late: 0.1 };
hit.cue = (t) => (t < hit.time ? hit.from + hit.v * t : hit.to - 2 * R);
hit.one = (t) => (t < hit.time ? hit.to : hit.to + hit.v * (t - hit.time));

/** The same in a second engine that passes the hit over by `late` seconds: runs part at the hit. */
export function twoBalls({ partings = true } = {}) {
  const run = (at) => [
    [knot(0, [0.5, hit.from, R], [0, hit.v, 0]), knot(at, [0.5, hit.from + hit.v * at, R], [0, hit.v, 0]), knot(at, [0.5, hit.from + hit.v * at, R]), knot(hit.end, [0.5, hit.from + hit.v * at, R])],
    [knot(0, [0.5, hit.to, R]), knot(at, [0.5, hit.to, R]), knot(at, [0.5, hit.to, R], [0, hit.v, 0]), knot(hit.end, [0.5, hit.to + hit.v * (hit.end - at), R], [0, hit.v, 0])],
  ];
  const late = hit.time + hit.late;
  const distance = (t) => (t < hit.time ? 1e-12 : Math.min(t, late) - hit.time + 1e-12) / R;
  return replay({
    name: "two",
    title: "One ball hits another",
    balls: [ball("cue"), ball("1")],
    R,
    origin: [0.5, 1, 0],
    speedScale: hit.v,
    table: TABLE,
    runs: [
      { label: "exact", reference: true, paths: run(hit.time), events: [[hit.time, "ball-ball", "cue", "1"]], ending: "duration" },
      { label: "stepper dt=0.1", paths: run(late), events: [[late, "ball-ball", "cue", "1"]], ending: "duration", resolution: 0.1 },
    ],
    partings: partings ? [{ time: hit.time, runs: [1, 0], balls: ["cue", "1"], words: "exact has cue and 1 meet; the stepper is late by a step." }] : [],
    divergence: [{ run: 1, against: 0, points: Array.from({ length: 33 }, (_, i) => [(hit.end * i) / 32, distance((hit.end * i) / 32)]) }],
  });
}

/** A ball that rolls a straight line: it turns once a circumference. */
export function rollingBall() {
  const v = 0.5;
  const end = 1.5;
  return replay({
    name: "roll",
    title: "A ball rolls",
    balls: [{ id: "9", radius: R, mass: 0.17, inertia: 0.4 * 0.17 * R * R }],
    R,
    origin: [0, 0, 0],
    speedScale: v,
    rotates: true,
    runs: [{ label: "exact", reference: true, paths: [[knot(0, [0, 0, R], [v, 0, 0], [0, v / R, 0]), knot(end, [v * end, 0, R], [v, 0, 0], [0, v / R, 0])]] }],
  });
}

/** Many balls on circles' chords: for the speed of drawing and for instanced balls. */
export function crowd(count) {
  const side = Math.ceil(Math.sqrt(count));
  const paths = Array.from({ length: count }, (_, i) => {
    const [x, y] = [0.1 * (i % side), 0.1 * Math.floor(i / side)];
    return [knot(0, [x, y, R], [0.05, 0.02, 0]), knot(2, [x + 0.1, y + 0.04, R], [0.05, 0.02, 0])];
  });
  return replay({ name: "crowd", title: "Many balls", balls: paths.map((_, i) => ball(`b${i}`)), R, speedScale: 0.05, runs: [{ label: "exact", reference: true, paths }] });
}
