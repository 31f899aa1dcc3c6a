// Laws of motion between knots, without a browser.
import assert from "node:assert/strict";
import test from "node:test";
import { modules } from "./harness.mjs";
import { hit, rollingBall, slide, slidingBall, twoBalls } from "./scenes.mjs";

const { Path, Turning, motion, turn, runs, times, curves, speed, valueAt, outline, decimals, short, eventsUntil } = await modules("path", "turning", "run", "curves", "outline", "numbers");

/** Half a unit in the last place of an f32 near x: what the columns lose of a number of this size. */
const f32 = (x) => Math.max(Math.abs(x), 1e-30) * 2 ** -24;

function near(got, expected, tolerance, what) {
  assert.ok(Math.abs(got - expected) <= tolerance, `${what}: got ${got}, expected ${expected}, off by ${Math.abs(got - expected)}, allowed ${tolerance}`);
}

const triples = (...values) => Float64Array.from(values.flat());

test("under constant acceleration the cubic between two knots is the motion itself", () => {
  const [x, v, a, h] = [0.3, 1.7, -0.9, 2.5];
  const at = (t) => [x + v * t + (a * t * t) / 2, 0, 1];
  const path = new Path(Float64Array.of(0, h), triples(at(0), at(h)), triples([v, 0, 0], [v + a * h, 0, 0]), triples());
  const m = motion();
  for (const t of [0, 0.1, 0.77, 1.25, 2.4, 2.5]) {
    path.at(t, m);
    near(m.position[0], at(t)[0], 1e-14, `x at ${t}: a few roundings of numbers below 10`);
    near(m.velocity[0], v + a * t, 1e-14, `v at ${t}`);
    assert.equal(m.position[2], 1);
  }
});

test("two knots at one time are the near and the far side of a jump", () => {
  const path = new Path(Float64Array.of(0, 1, 1, 2), triples([0, 0, 0], [1, 0, 0], [1, 0, 0], [0, 0, 0]), triples([1, 0, 0], [1, 0, 0], [-1, 0, 0], [-1, 0, 0]), triples());
  const m = motion();
  path.at(1, m);
  assert.equal(m.velocity[0], -1, "at its time a jump is over");
  path.at(1, m, true);
  assert.equal(m.velocity[0], 1, "before it, not");
  path.at(1.5, m, true);
  assert.equal(m.position[0], 0.5, "elsewhere near and far are the same");
});

test("before its first and after its last knot a ball is where that knot has it", () => {
  const path = new Path(Float64Array.of(1, 2), triples([3, 0, 0], [4, 0, 0]), triples([1, 0, 0], [1, 0, 0]), triples());
  const m = motion();
  for (const [t, x] of [[0, 3], [9, 4], [-1, 3]]) {
    assert.ok(path.at(t, m));
    assert.equal(m.position[0], x, `x at ${t}`);
  }
  assert.equal(new Path(triples(), triples(), triples(), triples()).at(0, m), false, "a path without knots says so");
});

test("the order in which times are asked for does not change what is answered", () => {
  const n = 40;
  const at = Float64Array.from({ length: n }, (_, i) => Math.floor(i / 2) * 0.1);
  const places = triples(...Array.from({ length: n }, (_, i) => [i, -i, 0]));
  const still = triples(...Array.from({ length: n }, () => [0, 0, 0]));
  const asked = Array.from({ length: 300 }, (_, i) => ((i * 7919) % 211) / 100 - 0.05);
  const m = motion();
  const used = new Path(at, places, still, triples());
  for (const t of asked) {
    used.at(t, m);
    const got = m.position[0];
    new Path(at, places, still, triples()).at(t, m);
    assert.equal(got, m.position[0], `at ${t}`);
  }
});

test("unpacked knots are the packed ones to the digits of an f32", async () => {
  const [run] = await runs(slidingBall());
  const m = motion();
  const R = 0.03;
  for (const part of [0, 0.25, 0.5, 1]) {
    const t = part * slide.stop;
    run.paths[0].at(t, m);
    // columns hold (y - origin) / R; time is off by its own rounding times the speed
    near(m.position[1] * R + 1, slide.y(t), 4 * f32(1) + f32(slide.stop) * slide.v, `y at ${t}`);
    near(m.velocity[1] * R, slide.speed(t), 4 * f32(slide.v) + f32(slide.stop) * slide.a, `speed at ${t}`);
  }
});

test("knots that are not what their counts promise are refused with both numbers", async () => {
  const data = slidingBall();
  data.runs[0].knots.counts = [3];
  await assert.rejects(runs(data), /56 bytes where 3 knots of 7 columns need 84/);
});

test("a ball that rolls one circumference is upright again, and upside down after half", async () => {
  const [run] = await runs(rollingBall());
  const [R, v] = [0.03, 0.5];
  const q = new Float64Array(4);
  for (const [turns, x, y, z, w] of [[0, 0, 0, 0, 1], [0.5, 0, 1, 0, 0], [1, 0, 0, 0, -1], [2, 0, 0, 0, 1], [3.5, 0, -1, 0, 0]]) {
    run.turnings[0].at((turns * 2 * Math.PI * R) / v, q);
    // the angle is a product of spin and time, each to an f32; half of it counts
    const tolerance = 2 * f32(2 * Math.PI * Math.max(1, turns)) + 1e-12;
    [x, y, z, w].forEach((expected, i) => near(q[i], expected, tolerance, `after ${turns} turns, part ${i}`));
  }
});

test("where the axis stays, the angle is the integral of the spin", () => {
  const [w0, w1, h] = [40, 3, 2];
  const path = new Path(Float64Array.of(0, h), triples([0, 0, 0], [0, 0, 0]), triples([0, 0, 0], [0, 0, 0]), triples([0, 0, w0], [0, 0, w1]));
  const turning = new Turning(path);
  const q = new Float64Array(4);
  for (const t of [0, 0.3, 1, 1.999, 2]) {
    const angle = w0 * t + ((w1 - w0) * t * t) / (2 * h);
    turning.at(t, q);
    near(q[2], Math.sin(angle / 2), 1e-13, `sine at ${t}: rounding of an angle below 50`);
    near(q[3], Math.cos(angle / 2), 1e-13, `cosine at ${t}`);
  }
});

test("where the axis turns, the rotation is that of many small steps", () => {
  const [a, b, h] = [[9, -4, 30], [-7, 12, 5], 0.8];
  const path = new Path(Float64Array.of(0, h), triples([0, 0, 0], [0, 0, 0]), triples([0, 0, 0], [0, 0, 0]), triples(a, b));
  const turning = new Turning(path);
  const small = (steps, until) => {
    const q = Float64Array.of(0, 0, 0, 1);
    for (let i = 0; i < steps; i += 1) {
      const s = ((i + 0.5) / steps) * (until / h);
      turn(q, ...[0, 1, 2].map((axis) => ((a[axis] + s * (b[axis] - a[axis])) * until) / steps));
    }
    return q;
  };
  const got = new Float64Array(4);
  for (const t of [0.05, 0.31, 0.8]) {
    const [coarse, fine] = [small(2000, t), small(4000, t)];
    turning.at(t, got);
    // steps of second order: the finer of the two is off by a third of what they differ by; pieces of half a radian leave 1e-4
    const own = Math.max(...fine.map((x, i) => Math.abs(x - coarse[i])));
    fine.forEach((expected, i) => near(got[i], expected, own + 1e-4, `at ${t}, part ${i}`));
    near(Math.hypot(...got), 1, 1e-12, "a rotation");
  }
});

test("an elastic hit of equal masses keeps the energy and hands over the speed", async () => {
  const data = twoBalls();
  const [run] = await runs(data);
  const when = times(data, [run], hit.end);
  const { energy, rms } = curves(data, run, when);
  const start = (0.17 * (hit.v / 0.03) ** 2) / 2;
  assert.ok(when.at.length > 100);
  energy.forEach((value, i) => near(value / start, 1, 4 * 2 ** -24, `energy at ${when.at[i]}`));
  rms.forEach((value, i) => near((value * 0.03) / hit.v, Math.SQRT1_2, 4 * 2 ** -24, `rms at ${when.at[i]}`));
  const [cue, one] = [0, 1].map((ball) => speed(run, ball, when));
  const at = Math.fround(hit.time);
  const sides = [...when.at.keys()].filter((i) => when.at[i] === at);
  assert.equal(sides.length, 2, "both sides of the hit are drawn");
  assert.ok(cue[sides[0]] > 0 && one[sides[0]] === 0 && cue[sides[1]] === 0 && one[sides[1]] > 0, "before: the cue ball moves; after: the other");
});

test("energy includes rotation, and a rolling sphere has 7/5 of what its motion alone has", async () => {
  const data = rollingBall();
  const [run] = await runs(data);
  const when = times(data, [run], 1.5);
  const { energy } = curves(data, run, when);
  const v = 0.5 / 0.03;
  energy.forEach((value, i) => near(value / ((0.17 * v * v) / 2), 1.4, 8 * 2 ** -24, `at ${when.at[i]}`));
});

test("a ball that falls leaves energy and speed at its time, and not before", async () => {
  const data = slidingBall();
  const fall = 0.5;
  data.runs[0].events.unshift([fall, "pocket", "cue", "p0"]);
  const [run] = await runs(data);
  const when = times(data, [run], slide.stop);
  const { energy } = curves(data, run, when);
  const moving = [...when.at.keys()].filter((i) => when.at[i] < fall);
  const gone = [...when.at.keys()].filter((i) => when.at[i] > fall);
  assert.ok(moving.length > 10 && gone.length > 10);
  assert.ok(moving.every((i) => energy[i] > 0) && gone.every((i) => energy[i] === 0));
  assert.ok(gone.every((i) => Number.isNaN(speed(run, 0, when)[i])), "a ball out of play has no speed");
});

test("what happened until a time is counted with what happens at it", () => {
  const events = [0.1, 0.2, 0.2, 0.5].map((at) => ({ at }));
  for (const [t, count] of [[0, 0], [0.1, 1], [0.19, 1], [0.2, 3], [0.5, 4], [9, 4]]) {
    assert.equal(eventsUntil(events, t), count, `until ${t}`);
  }
});

test("a curve between its points is linear, and a jump has two sides", () => {
  const [at, values] = [[0, 1, 1, 2], [0, 10, 20, 0]];
  for (const [t, value] of [[0.5, 5], [1, 20], [1.5, 10], [2, 0], [3, 0]]) {
    assert.equal(valueAt(at, values, t), value, `at ${t}`);
  }
  assert.ok(Number.isNaN(valueAt(at, values, -1)));
});

test("an outline with six pockets is closed, has six arcs, and cushions between them", () => {
  const rect = { x0: 0, y0: 0, x1: 40, y1: 80 };
  const pockets = [[0, 0], [40, 0], [0, 40], [40, 40], [0, 80], [40, 80]].map(([x, y]) => ({ x, y, r: 2 }));
  const { points, arcs, straights } = outline(rect, pockets);
  assert.equal(arcs.length, 6);
  assert.equal(straights.length, 6);
  for (const arc of arcs) {
    const corner = arc.pocket.y !== 40;
    near(arc.sweep, corner ? 1.5 * Math.PI : Math.PI, 1e-12, "three quarters of a circle at a corner, half at a side");
  }
  // the area by the shoelace is that of the rectangle and of what the pockets add, less what chords cut off the arcs
  const area = points.reduce((sum, [x, y], i) => sum + x * points[(i + 1) % points.length][1] - points[(i + 1) % points.length][0] * y, 0) / 2;
  const added = 4 * 0.75 * Math.PI * 4 + 2 * 0.5 * Math.PI * 4;
  near(area, 40 * 80 + added, 0.02 * added, "area: 28 chords to an arc cut off less than a fiftieth");
  assert.equal(outline(rect, []).straights.length, 4, "without pockets: four cushions");
});

test("numbers keep the digits that their size calls for", () => {
  for (const [whole, expected] of [[20, 3], [7, 4], [0.5, 5], [1e-6, 11], [3e4, 0]]) {
    assert.equal(decimals(whole), expected, `decimals of ${whole}`);
  }
  for (const [x, text] of [[0, "0"], [1, "1"], [0.25, "0.25"], [12.5, "12.5"], [1234.5678, "1235"], [1e-7, "1e-7"], [-0.5, "-0.5"], [2.5e8, "2.5e8"], [100, "100"], [10, "10"], [NaN, "–"]]) {
    assert.equal(short(x), text, `short ${x}`);
  }
});
