//! What the models cost, side by side: whole shots with criterion, and the ratios that the README quotes, measured in one
//! run so that a slow moment of the machine hits both sides.

#![allow(missing_docs, clippy::expect_used, clippy::print_stdout)]

use carom::engine::{self, Limits, Setting};
use carom::scene::{Scene, catalogue};
use carom::trace::{Record, Trace};
use criterion::{BatchSize, Criterion};
use std::hint::black_box;
use std::time::Instant;

/// Engines and settings on the report's break.
const COLUMNS: [(&str, &[&str]); 4] = [
    ("exact", &[]),
    ("stepper", &["contact=approaching-only"]),
    ("rapier-f64", &[]),
    ("rapier-f32", &[]),
];

/// Interleaved rounds of the ratio measurement; the shortest time of each counts.
const ROUNDS: usize = 15;

fn scene() -> Scene {
    catalogue::scene("report-break").expect("a scene of the catalogue")
}

fn setting(pairs: &[&str]) -> Setting {
    Setting::parse(pairs.iter().copied()).expect("a valid setting")
}

fn prepared<'a>(scene: &'a Scene, engine: &str, pairs: &[&str]) -> Box<dyn engine::Run + 'a> {
    let engine = engine::find(engine).expect("an engine");
    engine::prepare(engine, scene, &setting(pairs)).expect("an engine that runs the report's break")
}

fn whole_shots(criterion: &mut Criterion) {
    let scene = scene();
    let mut group = criterion.benchmark_group("report-break, whole shot");
    for (engine, pairs) in COLUMNS {
        group.sample_size(if engine.starts_with("rapier") { 10 } else { 50 });
        group.bench_function(engine, |bencher| {
            // set-up is outside the measurement
            bencher.iter_batched(
                || prepared(&scene, engine, pairs),
                |run| black_box(run.simulate(Record::Final, &Limits::NONE)),
                BatchSize::PerIteration,
            );
        });
    }
    group.finish();
}

fn recording(criterion: &mut Criterion) {
    let scene = scene();
    let mut group = criterion.benchmark_group("exact, recording");
    for (name, record) in [("final", Record::Final), ("events", Record::Events)] {
        group.bench_function(name, |bencher| {
            bencher.iter_batched(
                || prepared(&scene, "exact", &[]),
                |run| black_box(run.simulate(record, &Limits::NONE)),
                BatchSize::SmallInput,
            );
        });
    }
    group.finish();
}

/// One run, its time in s.
fn timed(scene: &Scene, engine: &str, pairs: &[&str]) -> (f64, Trace) {
    let run = prepared(scene, engine, pairs);
    let start = Instant::now();
    let trace = run.simulate(Record::Final, &Limits::NONE);
    (start.elapsed().as_secs_f64(), trace)
}

/// Shots of the exact engine that are timed together: one alone would be timed with cold caches, which a step of the others,
/// one of thousands, never has.
const BATCH: usize = 50;

/// Time of one of several exact shots, s; set-up is outside.
fn exact_shot(scene: &Scene) -> f64 {
    let runs: Vec<_> = (0..BATCH).map(|_| prepared(scene, "exact", &[])).collect();
    let start = Instant::now();
    for run in runs {
        black_box(run.simulate(Record::Final, &Limits::NONE));
    }
    start.elapsed().as_secs_f64() / BATCH as f64
}

/// Prints exact per shot against a rapier step, and a stepper step against a rapier step.
fn ratios() {
    let scene = scene();
    // rapier: a quarter of a second of the shot around the break, where balls touch
    let mut part = scene.clone();
    part.duration = 1.5;
    let [mut exact, mut stepper, mut rapier] = [f64::INFINITY; 3];
    for _ in 0..ROUNDS {
        exact = exact.min(exact_shot(&scene));
        let (seconds, trace) = timed(&scene, "stepper", &["contact=approaching-only"]);
        stepper = stepper.min(seconds / trace.counters["steps"] as f64);
        let (seconds, trace) = timed(&part, "rapier-f64", &[]);
        rapier = rapier.min(seconds / trace.counters["steps"] as f64);
    }
    println!();
    println!("ratios on the report's break, 16 balls, shortest of {ROUNDS} interleaved rounds");
    println!("  exact, whole shot          {:10.3} us", exact * 1e6);
    println!("  stepper, one step          {:10.3} us", stepper * 1e6);
    println!(
        "  rapier-f64, one step       {:10.3} us   (4 substeps, first 1.5 s)",
        rapier * 1e6
    );
    println!(
        "  exact shot / rapier step   {:10.3}      (demanded: below 0.5)",
        exact / rapier
    );
    println!(
        "  rapier step / stepper step {:10.0}      (demanded: above 100)",
        rapier / stepper
    );
}

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    whole_shots(&mut criterion);
    recording(&mut criterion);
    criterion.final_summary();
    // `cargo test --benches` only checks that everything runs
    if !std::env::args().any(|argument| argument == "--test") {
        ratios();
    }
}
