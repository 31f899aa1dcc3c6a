//! What the benches run: scenes of any size, prepared runs, and their times.

#![allow(missing_docs, dead_code, clippy::expect_used)]

use carom::engine::{self, Limits, Roster, Run, Setting};
use carom::math::Vec3;
use carom::physics::State;
use carom::scene::generate::{Recipe, generate};
use carom::scene::{Ball, Scene, catalogue, parse};
use carom::trace::{Event, EventKind, Record, Trace};
use std::time::Instant;

/// Part of the box that discs cover.
pub const DENSITY: f64 = 0.3;

/// A scene of the catalogue.
pub fn scene(name: &str) -> Scene {
    catalogue::scene(name).expect("a scene of the catalogue")
}

/// A scene inside an engine, with settings as on the command line.
pub fn prepared<'a>(scene: &'a Scene, engine: &str, pairs: &[&str]) -> Box<dyn Run + 'a> {
    let setting = Setting::parse(pairs.iter().copied()).expect("a valid setting");
    let roster = Roster::built_in();
    let engine = roster.find(engine).expect("an engine");
    engine::prepare(engine.as_ref(), scene, &setting).expect("an engine that runs the scene")
}

/// One run and its time, s; set-up is outside.
pub fn timed(scene: &Scene, engine: &str, pairs: &[&str], limits: &Limits<'_>) -> (f64, Trace) {
    let run = prepared(scene, engine, pairs);
    let start = Instant::now();
    let trace = run.simulate(Record::Final, limits);
    (start.elapsed().as_secs_f64(), trace)
}

/// One run and its time for each step, s.
pub fn step_time(scene: &Scene, engine: &str, pairs: &[&str]) -> (f64, Trace) {
    let (seconds, trace) = timed(scene, engine, pairs, &Limits::NONE);
    (seconds / trace.counters["steps"] as f64, trace)
}

/// Discs in a box, as `carom scene generate` writes them.
pub fn discs(recipe: &Recipe) -> Scene {
    let text = generate(recipe).expect("a density at which discs fit");
    parse("generated", &text).expect("a generated scene")
}

/// The report's shot into a triangle of `balls` - 1, row by row; above 16 balls table and speed grow, so that each has the same
/// room and energy.
pub fn shot(balls: usize) -> Scene {
    let mut scene = scene("report-break");
    let cue = scene.balls[scene.cue_ball()].clone();
    let rack: Vec<Ball> = scene
        .balls
        .iter()
        .filter(|b| b.id != cue.id)
        .cloned()
        .collect();
    let grown = (balls as f64 / 16.0).max(1.0).sqrt();
    let pitch = (rack[0].state.position - rack[1].state.position).norm();
    let place = |k: usize| {
        let row = ((8.0 * k as f64 + 1.0).sqrt() as usize - 1) / 2;
        let column = k - row * (row + 1) / 2;
        Vec3::new(
            pitch * (column as f64 - 0.5 * row as f64),
            pitch * row as f64 * 0.75_f64.sqrt(),
            0.0,
        )
    };
    let stretched = |at: Vec3| Vec3::new(at.x * grown, at.y * grown, at.z);
    let apex = stretched(rack[0].state.position);
    let mut all = vec![Ball {
        state: State {
            // as far from the rack as in the report
            position: apex + cue.state.position - rack[0].state.position,
            velocity: cue.state.velocity * grown,
            spin: cue.state.spin,
        },
        ..cue
    }];
    all.extend((1..balls).map(|number| Ball {
        id: number.to_string(),
        state: State::at_rest(apex + place(number - 1)),
        ..rack[0].clone()
    }));
    scene.balls = all;
    scene.shot = None;
    if let Some(table) = &mut scene.table {
        table.max = table.max.map(|edge| edge * grown);
    }
    scene
}

/// The same balls with nothing in motion, for `seconds`.
pub fn at_rest(mut scene: Scene, seconds: f64) -> Scene {
    for ball in &mut scene.balls {
        ball.state = State::at_rest(ball.state.position);
    }
    scene.duration = seconds;
    scene.run_to_duration = true;
    scene
}

/// `seconds` of a shot from the moment at which half of its hits have happened; what `exact` says the balls do by then.
pub fn mid_break(mut scene: Scene, seconds: f64) -> Scene {
    let run = prepared(&scene, "exact", &[]);
    let trace = run.simulate(Record::Events, &Limits::NONE);
    let is_hit = |event: &&Event| matches!(event.kind, EventKind::BallBall(..));
    let hits = trace.events.iter().filter(is_hit).count();
    let mut half = trace.events.iter().filter(is_hit).skip(hits / 2);
    let from = half.next().expect("a shot that hits something").time;
    // between two events: no pair is at contact
    let next = trace.events.iter().find(|event| event.time > from);
    let time = next.map_or(from, |next| 0.5 * (from + next.time));
    for (ball, path) in scene.balls.iter_mut().zip(&trace.paths) {
        ball.state = path.state_at(time).expect("a path with knots");
    }
    scene.duration = seconds;
    scene.run_to_duration = true;
    scene
}
