//! Scenes with a number: the closed form beside what the exact engine and the report's model give.

use super::scene;
use crate::support::run;
use carom::scene::Scene;
use carom::trace::{EventKind, Record, Trace};
use std::collections::BTreeSet;

/// Radius of a pool ball, m.
const R: f64 = 0.028575;
const G: f64 = 9.81;
/// Step at which the report's model is held to its order.
const DT: f64 = 1e-4;

/// One number of a scene.
#[derive(Clone, Copy, Debug)]
enum What {
    /// x, y of a centre at the end.
    Position(&'static str),
    /// Velocity at the end.
    Velocity(&'static str),
    /// Stop time of a ball, in the first component.
    Stop(&'static str),
    /// Time of the first event, in the first component.
    FirstEvent,
    /// Number of collisions, in the first component.
    Collisions,
}
use What::{Collisions, FirstEvent, Position, Stop, Velocity};

/// What is right, and how close each model must come.
struct Answer {
    scene: &'static str,
    what: What,
    right: [f64; 2],
    /// Absolute error that rounding may cause in the exact engine.
    rounding: f64,
    /// Error of the stepper in the same unit for each second of step; `None`: its step is too long for the scene.
    per_step: Option<f64>,
}

/// A number that sees `n` roundings at size `size`.
fn ulps(n: f64, size: f64) -> f64 {
    n * f64::EPSILON * size
}

fn answer(
    scene: &'static str,
    what: What,
    right: [f64; 2],
    rounding: f64,
    per_step: impl Into<Option<f64>>,
) -> Answer {
    Answer {
        scene,
        what,
        right,
        rounding,
        per_step: per_step.into(),
    }
}

/// x folded at the ends of [lo, hi], as a ball between two cushions goes.
fn folded(x: f64, lo: f64, hi: f64) -> f64 {
    let period = 2.0 * (hi - lo);
    let along = (x - lo).rem_euclid(period);
    lo + along.min(period - along)
}

/// Rows of balls that are hit in line at speed 1: what enters at one end leaves at the other, ahead by 2 R for each ball.
fn cradles() -> Vec<Answer> {
    let mut answers = Vec::new();
    for (name, last, balls) in [
        ("cradle", "5", 5.0),
        ("cradle-3", "3", 3.0),
        ("cradle-15", "15", 15.0),
        ("cradle-gap-1e-2", "5", 5.0),
        ("cradle-gap-1e-4", "5", 5.0),
        ("cradle-gap-1e-6", "5", 5.0),
        ("cradle-gap-1e-9", "5", 5.0),
        ("cradle-15-gap-1e-6", "15", 15.0),
        ("cradle-two-in", "5", 5.0),
        ("cradle-two-in-gap-1e-6", "5", 5.0),
    ] {
        let at = scene(name).duration + 2.0 * R * balls;
        // the place of each impact rounds; in the stepper each comes up to a step late
        answers.push(answer(
            name,
            Position(last),
            [0.0, at],
            ulps(4.0 * balls, at),
            balls + 1.0,
        ));
        answers.push(answer(
            name,
            Velocity(last),
            [0.0, 1.0],
            ulps(4.0 * balls, 1.0),
            0.0,
        ));
    }
    for (name, gap) in [("cradle-two-in", 0.0), ("cradle-two-in-gap-1e-6", 1e-6 * R)] {
        let at = 2.0 - (2.0 * R + gap) + 10.0 * R;
        answers.push(answer(name, Position("4"), [0.0, at], ulps(20.0, at), 6.0));
    }
    let e = 0.999_f64;
    let last = (0.5 * (1.0 + e)).powi(5);
    let name = "cradle-nearly-elastic-gap-1e-4";
    answers.push(answer(
        name,
        Velocity("5"),
        [0.0, last],
        ulps(20.0, 1.0),
        0.0,
    ));
    // two balls at speed 1 under generalised reflections push out two
    let name = "cradle-reflections";
    answers.push(answer(
        name,
        Velocity("4"),
        [0.0, 1.0],
        ulps(20.0, 1.0),
        0.0,
    ));
    answers.push(answer(
        name,
        Velocity("3"),
        [0.0, 1.0],
        ulps(20.0, 1.0),
        0.0,
    ));
    answers
}

/// Balls that touch a cushion or each other before anything moves.
fn frozen() -> Vec<Answer> {
    let (h, s) = (0.5_f64.sqrt(), 0.75_f64.sqrt());
    // a table of 1.27 m: one ball further in for each that is frozen
    let turned = |balls: f64| 2.0 * (1.27 - R - 2.0 * R * balls) - 0.8 - 1.0;
    // the line of centres is found a step late: it turns by up to v dt / 2R
    let oblique = 1.0 / (2.0 * R);
    vec![
        answer(
            "frozen-to-cushion",
            Velocity("cue"),
            [-1.0, 0.0],
            ulps(16.0, 1.0),
            0.0,
        ),
        answer(
            "frozen-to-cushion",
            Position("cue"),
            [turned(1.0), 1.0],
            ulps(32.0, 1.0),
            6.0,
        ),
        answer(
            "frozen-to-cushion",
            Position("1"),
            [1.27 - R, 1.0],
            ulps(4.0, 1.27),
            4.0,
        ),
        answer(
            "frozen-to-cushion-oblique",
            Velocity("1"),
            [-0.5, s],
            ulps(64.0, 1.0),
            1.0,
        ),
        answer(
            "frozen-to-cushion-oblique",
            Velocity("cue"),
            [0.0, 0.0],
            ulps(64.0, 1.0),
            1.0,
        ),
        answer(
            "frozen-to-ball",
            Position("1"),
            [0.0, 2.0 * R + 1.0],
            ulps(4.0, 1.0),
            2.0,
        ),
        answer(
            "frozen-to-ball",
            Position("cue"),
            [0.0, 0.0],
            ulps(4.0, 1.0),
            2.0,
        ),
        answer(
            "frozen-to-ball-oblique",
            Velocity("1"),
            [0.0, h],
            ulps(4.0, 1.0),
            oblique,
        ),
        answer(
            "frozen-to-ball-oblique",
            Velocity("cue"),
            [h, 0.0],
            ulps(4.0, 1.0),
            oblique,
        ),
        answer(
            "frozen-to-ball-and-cushion",
            Velocity("cue"),
            [-1.0, 0.0],
            ulps(32.0, 1.0),
            0.0,
        ),
        answer(
            "frozen-to-ball-and-cushion",
            Position("cue"),
            [turned(2.0), 1.0],
            ulps(32.0, 1.0),
            10.0,
        ),
        answer(
            "frozen-in-corner",
            Velocity("cue"),
            [-h, -h],
            ulps(64.0, 1.0),
            oblique,
        ),
        answer(
            "corner-double-hit",
            Position("cue"),
            [0.75, 0.75],
            ulps(16.0, 1.25),
            2.0,
        ),
        answer("corner-double-hit", Velocity("cue"), [-1.0, -1.0], 0.0, 0.0),
    ]
}

/// Grazes with D = 1: a hit off by b gives the struck ball sqrt(1 - b^2) along the line of centres.
fn grazes() -> Vec<Answer> {
    let mut answers = Vec::new();
    for (name, b) in [
        ("thin-cut-1e-2", 1.0 - 1e-2),
        ("thin-cut-1e-6", 1.0 - 1e-6),
        ("thin-cut-1e-12", 1.0 - 1e-12),
    ] {
        let c = f64::sqrt((1.0 - b) * (1.0 + b));
        // an error of the place across the shot is 1/c as large along it; the stepper finds the pair up to a step deeper
        let rounding = ulps(16.0, 2.0) / c;
        answers.push(answer(name, Velocity("1"), [c * b, c * c], rounding, 2.0));
        answers.push(answer(name, Collisions, [1.0, 0.0], 0.0, 0.0));
    }
    for name in [
        "near-miss-1e-2",
        "near-miss-1e-6",
        "near-miss-1e-12",
        "prediction-distance",
    ] {
        let speed = if name == "prediction-distance" {
            3.0
        } else {
            1.0
        };
        answers.push(answer(name, Collisions, [0.0, 0.0], 0.0, 0.0));
        answers.push(answer(name, Velocity("cue"), [0.0, speed], 0.0, 0.0));
    }
    // one ball between two, hit 1e-6 R aside: the answer of the symmetric pair up to twice that offset
    let off = 4e-6;
    let oblique = 4.0 / (2.0 * R * 0.75_f64.sqrt());
    let s = 0.75_f64.sqrt();
    answers.push(answer(
        "triple-hit-off-centre",
        Velocity("left"),
        [-s / 2.0, 0.75],
        off,
        oblique,
    ));
    answers.push(answer(
        "triple-hit-off-centre",
        Velocity("right"),
        [s / 4.0, 0.375],
        off,
        oblique,
    ));
    answers.push(answer(
        "triple-hit-off-centre",
        Velocity("cue"),
        [s / 4.0, -0.125],
        off,
        oblique,
    ));
    // a cut of 45 and one of 30 degrees; the normal turns by v dt / (D cos)
    let turns = |v: f64, cos: f64| v * v / (2.0 * R * cos);
    let forty_five = turns(1.5, 0.5_f64.sqrt());
    answers.push(answer(
        "contact-recycling",
        Velocity("1"),
        [0.75, 0.75],
        ulps(64.0, 1.5),
        forty_five,
    ));
    answers.push(answer(
        "contact-recycling",
        Velocity("cue"),
        [-0.75, 0.75],
        ulps(64.0, 1.5),
        forty_five,
    ));
    let thirty = turns(200.0, s);
    answers.push(answer(
        "through-a-ball-oblique",
        Velocity("1"),
        [100.0 * s, 150.0],
        ulps(64.0, 200.0),
        thirty,
    ));
    answers
}

/// Speeds that differ by little, that are little, that are large.
fn speeds() -> Vec<Answer> {
    let mut answers = Vec::new();
    for (name, k) in [("catch-up-1e-6", 20), ("catch-up-1e-12", 40)] {
        let slower = 0.5_f64.powi(k);
        // a place is good to a few ulp of 3, and the gap closes at `slower`
        answers.push(answer(
            name,
            FirstEvent,
            [1.0, 0.0],
            ulps(8.0, 3.0) / slower,
            None,
        ));
        answers.push(answer(name, Velocity("1"), [0.0, 1.0], 0.0, 0.0));
        answers.push(answer(name, Velocity("cue"), [0.0, 1.0 - slower], 0.0, 0.0));
    }
    let cloth = 0.2 * G;
    let creeping = 1e-8;
    answers.extend([
        answer(
            "catch-up-on-cloth",
            FirstEvent,
            [0.25, 0.0],
            ulps(8.0, 1.25) * 1024.0,
            2.0,
        ),
        answer(
            "residual-1e-8",
            FirstEvent,
            [1.0, 0.0],
            ulps(8.0, 1.0) / creeping,
            2.0,
        ),
        answer("residual-1e-8", Velocity("1"), [0.0, creeping], 0.0, 0.0),
        answer(
            "residual-1e-8-on-cloth",
            Stop("cue"),
            [creeping / cloth, 0.0],
            ulps(8.0, creeping / cloth),
            1.0,
        ),
        // nowhere: less than an ulp of its radius
        answer(
            "residual-1e-8-on-cloth",
            Position("cue"),
            [0.0, 0.0],
            ulps(1.0, 0.5),
            0.0,
        ),
        answer(
            "residual-1e-300-on-cloth",
            Position("cue"),
            [0.0, 0.0],
            1e-299,
            0.0,
        ),
        answer("residual-1e-160", Position("cue"), [0.0, 0.0], 1e-159, 0.0),
        answer("residual-1e-160", Position("1"), [0.0, 1.0], 0.0, 0.0),
        answer("residual-1e-300", Velocity("1"), [0.0, 1.0], 1e-299, 1e-295),
        answer(
            "residual-1e-300",
            Position("cue"),
            [0.0, 1.0],
            ulps(4.0, 2.0),
            2.0,
        ),
        answer(
            "speed-1e6",
            Position("cue"),
            [0.0, 1.5],
            ulps(4.0, 2.0),
            None,
        ),
        answer(
            "speed-1e6",
            Position("1"),
            [0.0, 10_001.0],
            ulps(8.0, 10_001.0),
            None,
        ),
        answer(
            "speed-cap",
            Position("cue"),
            [100.0, 0.0],
            ulps(8.0, 100.0),
            0.0,
        ),
        answer("through-a-ball", Velocity("1"), [0.0, 200.0], 0.0, 0.0),
        answer(
            "through-a-ball",
            Position("cue"),
            [0.0, 0.5 - 2.0 * R],
            ulps(8.0, 0.5),
            200.0,
        ),
        answer("long-step", Velocity("left"), [-1.0, 0.0], 0.0, 0.0),
        answer(
            "long-step",
            Position("left"),
            [0.5 - 2.0 * R - 1.0, 0.0],
            ulps(8.0, 1.0),
            2.0,
        ),
    ]);
    let straight = |v: f64, x0: f64, hi: f64| folded(x0 + v * 0.05, R, hi - R);
    let right = [straight(600.0, 0.5, 1.27), straight(800.0, 1.0, 2.54)];
    // 40 m of way, folded 41 times
    answers.push(answer(
        "through-a-cushion",
        Position("cue"),
        right,
        ulps(41.0, 40.0),
        None,
    ));
    for (name, span, seconds) in [("bounces-1000", 0.2, 10.0), ("bounces-100000", 0.1, 500.0)] {
        let bounces: f64 = seconds * 20.0 / span;
        let start = R + 0.5 * span;
        answers.push(answer(name, Collisions, [bounces, 0.0], 0.0, None));
        // the clock of each bounce rounds to an ulp of its time
        let rounding = ulps(2.0 * bounces, seconds * 20.0);
        answers.push(answer(name, Position("cue"), [start, 1.0], rounding, None));
        answers.push(answer(name, Velocity("cue"), [20.0, 0.0], 0.0, None));
    }
    answers
}

/// Friction, masses, restitution, lengths.
fn laws() -> Vec<Answer> {
    let mut answers = vec![
        answer(
            "cloth-mu-0",
            Position("cue"),
            [2.0, 0.0],
            ulps(4.0, 2.0),
            1e-7,
        ),
        answer(
            "cloth-mu-1e-9",
            Position("cue"),
            [2.0 - 2e-9 * G, 0.0],
            ulps(8.0, 2.0),
            1e-7,
        ),
        answer(
            "cloth-mu-10",
            Position("cue"),
            [0.05 / G, 0.0],
            ulps(8.0, 0.01),
            1.0,
        ),
        answer(
            "cloth-mu-10",
            Stop("cue"),
            [0.1 / G, 0.0],
            ulps(8.0, 0.01),
            1.0,
        ),
        answer(
            "heavy-into-light",
            Velocity("1"),
            [0.0, 2.0 / (1.0 + 1e-9)],
            ulps(16.0, 2.0),
            0.0,
        ),
        answer(
            "heavy-into-light",
            Velocity("cue"),
            [0.0, (1.0 - 1e-9) / (1.0 + 1e-9)],
            ulps(16.0, 1.0),
            0.0,
        ),
        answer(
            "light-into-heavy",
            Velocity("1"),
            [0.0, 2e-9 / (1.0 + 1e-9)],
            ulps(16.0, 2e-9),
            0.0,
        ),
        answer(
            "light-into-heavy",
            Velocity("cue"),
            [0.0, (1e-9 - 1.0) / (1.0 + 1e-9)],
            ulps(16.0, 1.0),
            0.0,
        ),
        answer("galperin-314", Collisions, [galperin(1e4), 0.0], 0.0, None),
        answer(
            "galperin-99345",
            Collisions,
            [galperin(1e9), 0.0],
            0.0,
            None,
        ),
        answer(
            "plastic-hit",
            Velocity("cue"),
            [0.0, 0.5],
            ulps(4.0, 0.5),
            0.0,
        ),
        answer(
            "plastic-hit",
            Velocity("1"),
            [0.0, 0.5],
            ulps(4.0, 0.5),
            0.0,
        ),
    ];
    for (name, v) in [("cushion-slow", 0.05), ("cushion-medium", 0.3)] {
        answers.push(answer(
            name,
            Velocity("cue"),
            [0.8 * v, 0.0],
            ulps(4.0, v),
            0.0,
        ));
    }
    for (name, v) in [
        ("restitution-fast", 3.0),
        ("restitution-slow", 0.3),
        ("restitution-creeping", 0.03),
    ] {
        answers.push(answer(
            name,
            Velocity("cue"),
            [0.0, 0.1 * v],
            ulps(8.0, v),
            0.0,
        ));
        answers.push(answer(
            name,
            Velocity("1"),
            [0.0, 0.9 * v],
            ulps(8.0, v),
            0.0,
        ));
    }
    let slide: f64 = 1.5;
    let (path, time) = (slide * slide / (0.4 * G), slide / (0.2 * G));
    for (name, degrees) in [
        ("diagonal-slide-30", 30.0_f64),
        ("diagonal-slide-45", 45.0),
        ("fine-steps-in-f32", 0.0),
    ] {
        let (s, c) = degrees.to_radians().sin_cos();
        answers.push(answer(
            name,
            Position("cue"),
            [path * c, path * s],
            ulps(8.0, path),
            slide,
        ));
        answers.push(answer(name, Stop("cue"), [time, 0.0], ulps(8.0, time), 1.0));
    }
    // a slow slide of 4 m less 2 R, then the struck ball goes on with what is left
    let whole = slide * slide / (0.02 * G);
    let last = 4.0 + whole - (4.0 - 2.0 * R);
    answers.push(answer(
        "hit-a-sleeper",
        Position("1"),
        [last, 0.0],
        ulps(64.0, last),
        3.0 * slide,
    ));
    let slower = 0.2 * G;
    let left = 49.0 - 2.0 * slower * 2.5;
    let at = folded(5.0 + left / (2.0 * slower), 0.25, 11.75);
    for (name, scale, offset) in [
        ("lengths-1e-6", 1e-6, 0.0),
        ("lengths-1e6", 1e6, 0.0),
        ("table-far-away", 1.0, 1e8),
    ] {
        let right = [offset + 2.0 * scale, offset + at * scale];
        // an error of the first contact is that of its speed times 3 s afterwards
        let rounding = ulps(16.0, offset + 12.0 * scale) * 4.0;
        // late by a step at the hit and at the cushion, ahead by v dt / 2 for each slide
        answers.push(answer(
            name,
            Position("1"),
            right,
            rounding,
            4.0 * 7.0 * scale,
        ));
    }
    answers
}

/// Impacts of a light ball between a cushion and a ball `ratio` times as heavy: as often as the angle fits into pi.
fn galperin(ratio: f64) -> f64 {
    (std::f64::consts::PI / (1.0 / ratio.sqrt()).atan()).ceil() - 1.0
}

/// Balls that turn.
fn turning() -> Vec<Answer> {
    let (v, spin) = (1.0, 1000.0);
    let drive = 0.5 * G;
    let time = 2.0 * (R * spin - v) / (7.0 * drive);
    let rolling = v + drive * time;
    let slid = v * time + 0.5 * drive * time * time;
    let stop = time + rolling / (0.2 * G);
    let whole = slid + rolling * rolling / (0.4 * G);
    let rolled = |v: f64, mu: f64| v * v / (2.0 * mu * G);
    vec![
        answer(
            "spin-far-above-rolling",
            Position("cue"),
            [whole, 0.0],
            ulps(64.0, whole),
            4.0 * rolling,
        ),
        answer(
            "spin-far-above-rolling",
            Stop("cue"),
            [stop, 0.0],
            ulps(64.0, stop),
            4.0,
        ),
        answer("spin-in-place", Position("cue"), [0.0, 0.0], 0.0, 0.0),
        answer(
            "spin-in-place",
            FirstEvent,
            [2.0 * R * 200.0 / (5.0 * 0.05 * G), 0.0],
            ulps(16.0, 5.0),
            2.0,
        ),
        answer(
            "rolling-into-sleep",
            Position("cue"),
            [rolled(0.04, 0.0004), 0.0],
            ulps(64.0, 0.2),
            0.08,
        ),
        answer(
            "rotation-cap",
            Position("cue"),
            [rolled(3.0, 0.05), 0.0],
            ulps(64.0, 9.2),
            6.0,
        ),
    ]
}

/// Impacts without end.
fn collapsing() -> Vec<Answer> {
    // where two balls of 1 closing in from both sides leave the middle of three: touching, about their common centre
    let centre = (0.0 + 1.1 + 2.3) / 3.0;
    let places = [
        ("left", centre - 1.0),
        ("middle", centre),
        ("right", centre + 1.0),
    ];
    let place = |(ball, x): (&'static str, f64)| {
        // the last impacts are those that rounding still tells apart
        answer(
            "collapse-three",
            Position(ball),
            [x, 0.0],
            ulps(64.0, 2.3),
            4.0,
        )
    };
    places.map(place).into()
}

fn all() -> Vec<Answer> {
    [
        cradles(),
        frozen(),
        grazes(),
        speeds(),
        laws(),
        turning(),
        collapsing(),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// Names of the scenes that have an answer here.
pub fn scenes() -> BTreeSet<&'static str> {
    all().iter().map(|answer| answer.scene).collect()
}

fn ball(scene: &Scene, id: &str) -> usize {
    let found = scene.balls.iter().position(|ball| ball.id == id);
    found.unwrap_or_else(|| panic!("{}: no ball {id}", scene.name))
}

fn found(scene: &Scene, trace: &Trace, what: What) -> [f64; 2] {
    let state = |id| trace.final_states()[ball(scene, id)].unwrap();
    match what {
        Position(id) => [state(id).position.x, state(id).position.y],
        Velocity(id) => [state(id).velocity.x, state(id).velocity.y],
        Stop(id) => [trace.stop_times[ball(scene, id)].unwrap_or(f64::NAN), 0.0],
        FirstEvent => [
            trace.events.first().map_or(f64::NAN, |event| event.time),
            0.0,
        ],
        Collisions => {
            let hits = trace.collisions().map(|event| match event.kind {
                EventKind::BallBall(..) | EventKind::BallCushion(..) => 1.0,
                _ => 0.0,
            });
            [hits.sum(), 0.0]
        }
    }
}

/// Every answer on which one engine is wrong by more than `allowed` says; how many it was asked.
fn wrong(
    engine: &str,
    settings: &[&str],
    allowed: impl Fn(&Answer) -> Option<f64>,
) -> (usize, Vec<String>) {
    let (mut asked, mut wrong) = (0, Vec::new());
    let mut last: Option<(Scene, Trace)> = None;
    for answer in all() {
        let Some(bound) = allowed(&answer) else {
            continue;
        };
        if last
            .as_ref()
            .is_none_or(|(scene, _)| scene.name != answer.scene)
        {
            let scene = scene(answer.scene);
            let trace = run(engine, settings, &scene, Record::Events);
            last = Some((scene, trace));
        }
        let Some((scene, trace)) = &last else {
            continue;
        };
        let got = found(scene, trace, answer.what);
        let error = (got[0] - answer.right[0]).hypot(got[1] - answer.right[1]);
        asked += 1;
        // false for NaN as well
        let close = error <= bound;
        if !close {
            wrong.push(format!(
                "{engine} in {}: {:?} is {got:?} instead of {:?}: error {error:e}, bound {bound:e}",
                answer.scene, answer.what, answer.right
            ));
        }
    }
    (asked, wrong)
}

#[test]
fn the_exact_engine_gives_the_number_that_each_hard_scene_names() {
    let (asked, wrong) = wrong("exact", &[], |answer| Some(answer.rounding));
    assert!(asked >= 100, "{asked} answers");
    assert!(
        wrong.is_empty(),
        "{} of {asked} wrong:\n{}",
        wrong.len(),
        wrong.join("\n")
    );
}

#[test]
fn the_model_with_its_missing_check_gives_each_number_to_the_order_of_its_step() {
    let dt = format!("dt={DT}");
    let settings = ["contact=approaching-only", dt.as_str()];
    // every step rounds a position once, and no scene here takes more than 1e5 of them
    let steps = |answer: &Answer| {
        let size = answer.right[0]
            .hypot(answer.right[1])
            .max(f64::MIN_POSITIVE);
        ulps(scene(answer.scene).duration / DT, size)
    };
    let (asked, wrong) = wrong("stepper", &settings, |answer| {
        Some(answer.rounding + answer.per_step? * DT + steps(answer))
    });
    assert!(asked >= 80, "{asked} answers");
    assert!(
        wrong.is_empty(),
        "{} of {asked} wrong:\n{}",
        wrong.len(),
        wrong.join("\n")
    );
}
