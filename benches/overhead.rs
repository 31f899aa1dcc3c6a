//! What the workbench adds to rapier: the report's break stepped by rapier alone, set up by hand, against the same scene in the
//! engine `rapier-f64`, in one run.

#![allow(missing_docs, clippy::expect_used, clippy::print_stdout)]

use carom::engine::Limits;
use carom::scene::Scene;
use carom::trace::Record;
use std::time::Instant;

mod bare;
mod runs;

use bare::{Bare, DT};
use runs::{mid_break, prepared, shot};

/// Interleaved rounds; the shortest time of each counts.
const ROUNDS: usize = 150;

/// What a step may cost more than rapier's own.
const DEMANDED: f64 = 1.02;

/// Shortest times of a step, s: rapier alone, and in the engine with `record`.
fn measure(scene: &Scene, record: Record, rounds: usize) -> [f64; 2] {
    let steps = (scene.duration / DT).round() as u64;
    let mut best = [f64::INFINITY; 2];
    for _ in 0..rounds {
        let bare = Bare::new(scene);
        let start = Instant::now();
        let positions = bare.run(steps);
        best[0] = best[0].min(start.elapsed().as_secs_f64() / steps as f64);
        let run = prepared(scene, "rapier-f64", &[]);
        let start = Instant::now();
        let trace = run.simulate(record, &Limits::NONE);
        best[1] = best[1].min(start.elapsed().as_secs_f64() / steps as f64);
        assert_eq!(trace.counters["steps"], steps);
        // the same to the bit, or the two did not do the same work
        for (bare, path) in positions.iter().zip(&trace.paths) {
            let own = path.last().expect("a path with knots").position;
            assert_eq!(*bare, [own.x, own.y, own.z]);
        }
    }
    best
}

fn main() {
    let only_check = std::env::args().any(|argument| argument == "--test");
    let seconds = if only_check { 0.01 } else { 0.25 };
    let mut part = shot(16);
    part.duration = 6.0 * seconds;
    let scenes = [
        ("the first 1.5 s of the report's break", part),
        ("16 balls, mid-break", mid_break(shot(16), seconds)),
        ("2 balls, mid-break", mid_break(shot(2), seconds)),
        ("100 balls, mid-break", mid_break(shot(100), 0.4 * seconds)),
    ];
    println!();
    let rounds = if only_check { 1 } else { ROUNDS };
    println!(
        "us for a step, rapier alone / rapier-f64 with Record::Final, shortest of {rounds} interleaved rounds"
    );
    for (name, scene) in &scenes {
        let [bare, engine] = measure(scene, Record::Final, rounds);
        println!(
            "  {name:<38} {:9.3} {:9.3} {:8.4}   (demanded: at most {DEMANDED})",
            bare * 1e6,
            engine * 1e6,
            engine / bare
        );
    }
}
