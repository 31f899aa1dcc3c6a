//! Scenes with a number: the closed form beside what the exact engine and the report's model give.

use super::{contacts, motions, scene};
use crate::support::run;
use carom::scene::Scene;
use carom::trace::{EventKind, Record, Trace};
use std::collections::BTreeSet;

/// Radius of a pool ball, m.
pub const R: f64 = 0.028575;
/// Gravity, m/s^2.
pub const G: f64 = 9.81;
/// Step at which the report's model is held to its order.
const DT: f64 = 1e-4;

/// One number of a scene.
#[derive(Clone, Copy, Debug)]
pub enum What {
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
pub struct Answer {
    scene: &'static str,
    what: What,
    right: [f64; 2],
    /// Absolute error that rounding may cause in the exact engine.
    rounding: f64,
    /// Error of the stepper in the same unit for each second of step; `None`: its step is too long for the scene.
    per_step: Option<f64>,
}

/// A number that sees `n` roundings at size `size`.
pub fn ulps(n: f64, size: f64) -> f64 {
    n * f64::EPSILON * size
}

pub fn answer(
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

fn all() -> Vec<Answer> {
    [
        contacts::cradles(),
        contacts::frozen(),
        contacts::grazes(),
        contacts::collapsing(),
        motions::speeds(),
        motions::laws(),
        motions::turning(),
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
