//! Answers of motions and laws: speeds, friction, masses, restitution, lengths, rotation.

use super::answers::What::{Collisions, FirstEvent, Position, Stop, Velocity};
use super::answers::{Answer, G, R, answer, ulps};

/// x folded at the ends of [lo, hi], as a ball between two cushions goes.
fn folded(x: f64, lo: f64, hi: f64) -> f64 {
    let period = 2.0 * (hi - lo);
    let along = (x - lo).rem_euclid(period);
    lo + along.min(period - along)
}

/// Speeds that differ by little, that are little, that are large.
pub fn speeds() -> Vec<Answer> {
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
pub fn laws() -> Vec<Answer> {
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
pub fn turning() -> Vec<Answer> {
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
