//! Answers of contacts: rows, frozen balls, grazes, balls that collapse onto each other.

use super::answers::What::{Collisions, Position, Velocity};
use super::answers::{Answer, R, answer, ulps};
use super::scene;

/// Rows of balls that are hit in line at speed 1: what enters at one end leaves at the other, ahead by 2 R for each ball.
pub fn cradles() -> Vec<Answer> {
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
pub fn frozen() -> Vec<Answer> {
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
pub fn grazes() -> Vec<Answer> {
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

/// Impacts without end.
pub fn collapsing() -> Vec<Answer> {
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
