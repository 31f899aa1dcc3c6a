//! What the models cost, side by side, with criterion: at rest, in the middle of a break, over a whole shot, and by what is
//! recorded; and the ratios that the README quotes, measured in one
//! run so that a slow moment of the machine hits both sides.

#![allow(missing_docs, clippy::expect_used, clippy::print_stdout)]

use carom::engine::Limits;
use carom::scene::Scene;
use carom::trace::Record;
use criterion::{BatchSize, Criterion, SamplingMode};
use std::hint::black_box;
use std::time::{Duration, Instant};

mod runs;

use runs::{at_rest, mid_break, prepared, scene, shot, step_time};

/// Engines and settings. In none of them a ball sleeps.
const COLUMNS: [(&str, &[&str]); 4] = [
    ("exact", &[]),
    ("stepper", &["contact=approaching-only"]),
    ("rapier-f64", &[]),
    ("rapier-f32", &[]),
];

/// Numbers of balls.
const SIZES: [usize; 4] = [2, 16, 100, 1000];

/// What is simulated of a rest, and of the middle of a break, s.
const PART: f64 = 0.1;

/// What rapier simulates of a shot of more than 100 balls, of which a whole one would take it minutes, s.
const BOUND: f64 = 0.05;

/// Interleaved rounds of the ratio measurement; the shortest time of each counts.
const ROUNDS: usize = 15;

/// One benchmark: a run of a scene in an engine, set-up outside the measurement.
fn bench(
    criterion: &mut Criterion,
    group: &str,
    name: String,
    (engine, pairs): (&str, &[&str]),
    scene: &Scene,
    record: Record,
) {
    let mut group = criterion.benchmark_group(group);
    group
        .sample_size(10)
        .sampling_mode(SamplingMode::Flat)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1));
    group.bench_function(name, |bencher| {
        bencher.iter_batched(
            || prepared(scene, engine, pairs),
            |run| black_box(run.simulate(record, &Limits::NONE)),
            BatchSize::PerIteration,
        );
    });
    group.finish();
}

/// Every engine on scenes of every size: nothing moves, half the hits have happened, and the whole shot.
fn states(criterion: &mut Criterion) {
    for n in SIZES {
        let shot = shot(n);
        let rest = at_rest(shot.clone(), PART);
        let middle = mid_break(shot.clone(), PART);
        for column in COLUMNS {
            let name = format!("{}/{n}", column.0);
            let bounded = column.0.starts_with("rapier") && n > 100;
            let mut whole = shot.clone();
            if bounded {
                whole.duration = BOUND;
            }
            let whole_name = if bounded {
                format!("{name}, first {BOUND} s")
            } else {
                name.clone()
            };
            let group = format!("at rest, {PART} s");
            bench(
                criterion,
                &group,
                name.clone(),
                column,
                &rest,
                Record::Final,
            );
            let group = format!("mid-break, {PART} s");
            bench(criterion, &group, name, column, &middle, Record::Final);
            bench(
                criterion,
                "whole shot",
                whole_name,
                column,
                &whole,
                Record::Final,
            );
        }
    }
    // many more hits: exact at a hundredth of the friction
    let mut slippery = scene("report-break");
    slippery.effects.cloth = Some(carom::physics::Cloth::Translational { mu: 0.002 });
    let name = "exact/16, mu 0.002".to_owned();
    bench(
        criterion,
        "whole shot",
        name,
        COLUMNS[0],
        &slippery,
        Record::Final,
    );
}

/// What recording costs each engine, on the report's break.
fn recording(criterion: &mut Criterion) {
    let mut part = scene("report-break");
    // the first 1.5 s of the shot, where balls touch
    part.duration = 1.5;
    for column in COLUMNS {
        for (what, record) in [
            ("final", Record::Final),
            ("events", Record::Events),
            ("every 0.02 s", Record::Every(0.02)),
        ] {
            let name = format!("{}/{what}", column.0);
            bench(
                criterion,
                "recording, first 1.5 s of the report's break",
                name,
                column,
                &part,
                record,
            );
        }
    }
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
    let scene = scene("report-break");
    // rapier: a quarter of a second of the shot around the break, where balls touch
    let mut part = scene.clone();
    part.duration = 1.5;
    let [mut exact, mut stepper, mut rapier] = [f64::INFINITY; 3];
    for _ in 0..ROUNDS {
        exact = exact.min(exact_shot(&scene));
        stepper = stepper.min(step_time(&scene, "stepper", COLUMNS[1].1).0);
        rapier = rapier.min(step_time(&part, "rapier-f64", &[]).0);
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
    states(&mut criterion);
    recording(&mut criterion);
    criterion.final_summary();
    // `cargo test --benches` only checks that everything runs
    if !std::env::args().any(|argument| argument == "--test") {
        ratios();
    }
}
