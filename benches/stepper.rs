//! What a step of the report's model costs: against its plain transcription and a step of rapier, from 16 to 100 000 balls.

#![allow(missing_docs, clippy::expect_used, clippy::print_stdout)]

use carom::engine::Limits;
use carom::scene::Scene;
use carom::scene::generate::Recipe;
use criterion::{BatchSize, Criterion, Throughput};
use std::hint::black_box;
use std::time::Instant;

mod runs;

#[path = "../tests/suite/transcription/program.rs"]
#[allow(dead_code)]
mod program;

use program::Program;
use runs::{DENSITY, discs, prepared, scene, step_time};

/// Numbers of balls.
const SIZES: [usize; 5] = [16, 100, 1_000, 10_000, 100_000];

/// Interleaved rounds; the shortest time of each counts.
const ROUNDS: usize = 5;

/// The rule under which pairs that overlap at rest are left alone.
const CLEAN: &str = "contact=approaching-only";

/// Time step, s.
const DT: f64 = 1e-3;

/// Steps that a run of so many balls is measured over: enough for several lists of pairs.
fn steps(balls: usize) -> f64 {
    (2e6 / balls as f64).clamp(500.0, 20_000.0)
}

/// Discs with as much motion after the run as before: elastic walls and no cloth.
fn gas(balls: usize) -> Scene {
    discs(&Recipe {
        balls,
        density: DENSITY,
        duration: steps(balls) * DT,
        ..Recipe::default()
    })
}

/// Discs that slide to rest, but not within the run.
fn sliding(balls: usize) -> Scene {
    discs(&Recipe {
        balls,
        density: DENSITY,
        mu: Some(1e-3),
        duration: steps(balls) * DT,
        ..Recipe::default()
    })
}

/// The table of sizes: cost of a step for each ball, and the exponent between a size and the one before.
fn sizes(title: &str, scenes: &[Scene]) {
    let mut best = vec![f64::INFINITY; scenes.len()];
    let mut exchanges = vec![0.0; scenes.len()];
    for _ in 0..ROUNDS {
        for (i, scene) in scenes.iter().enumerate() {
            let (seconds, trace) = step_time(scene, "stepper", &[CLEAN]);
            best[i] = seconds.min(best[i]);
            exchanges[i] = trace.counters["exchanges"] as f64 / trace.counters["steps"] as f64;
        }
    }
    println!();
    println!("stepper, {title}, dt {DT} s, shortest of {ROUNDS} interleaved rounds");
    println!(
        "{:>8} {:>12} {:>13} {:>9} {:>13}",
        "balls", "us/step", "ns/step/ball", "exponent", "exchanges/st."
    );
    for (i, scene) in scenes.iter().enumerate() {
        let n = scene.balls.len();
        let exponent = i.checked_sub(1).map_or(String::new(), |before| {
            let ratio = n as f64 / scenes[before].balls.len() as f64;
            format!("{:.3}", (best[i] / best[before]).ln() / ratio.ln())
        });
        println!(
            "{n:>8} {:>12.3} {:>13.2} {exponent:>9} {:>13.2}",
            best[i] * 1e6,
            best[i] * 1e9 / n as f64,
            exchanges[i]
        );
    }
    let (first, last) = (&scenes[1], &scenes[scenes.len() - 1]);
    let ratio = last.balls.len() as f64 / first.balls.len() as f64;
    println!(
        "  exponent from 100 to 10^5 balls {:8.3}   (linear: 1)",
        (best[scenes.len() - 1] / best[1]).ln() / ratio.ln()
    );
}

/// Looking at all pairs against those listed, where a list lasts, and where balls move by half of one in each step, so that every
/// list is made anew.
fn crossover() {
    println!();
    println!("ns for a step, shortest of {ROUNDS} interleaved rounds");
    println!(
        "{:>8} {:>9} {:>9} {:>8} {:>18}",
        "balls", "all pairs", "listed", "ratio", "listed, each step"
    );
    for n in [12, 16, 20, 24, 32, 48, 64, 100, 256, 1000] {
        let scene = gas(n);
        let mut fast = scene.clone();
        fast.duration = 1000.0;
        let [mut all, mut near, mut renewed] = [f64::INFINITY; 3];
        for _ in 0..ROUNDS {
            let time = |scene, pairs: &[&str]| step_time(scene, "stepper", pairs).0;
            all = all.min(time(&scene, &[CLEAN, "partners=all"]));
            near = near.min(time(&scene, &[CLEAN, "partners=near"]));
            renewed = renewed.min(time(&fast, &[CLEAN, "partners=near", "dt=1"]));
        }
        println!(
            "{n:>8} {:>9.0} {:>9.0} {:>8.2} {:>18.0}",
            all * 1e9,
            near * 1e9,
            all / near,
            renewed * 1e9
        );
    }
}

/// Time of a step of the transcription, s.
fn plain(scene: &Scene, approaching_only: bool) -> f64 {
    let mut program = Program::new(scene, DT, approaching_only);
    let start = Instant::now();
    program.run();
    black_box(&program.balls);
    start.elapsed().as_secs_f64() / program.steps as f64
}

/// Prints a step against one of the transcription and one of rapier.
fn ratios() {
    println!();
    println!(
        "a step of the report's break, 16 balls, shortest of {} interleaved rounds",
        3 * ROUNDS
    );
    let scene = scene("report-break");
    let mut part = scene.clone();
    // the first 1.5 s of the shot, where balls touch
    part.duration = 1.5;
    for (rule, approaching_only) in [("as-written", false), ("approaching-only", true)] {
        let contact = format!("contact={rule}");
        let [mut own, mut transcribed, mut rapier] = [f64::INFINITY; 3];
        for _ in 0..3 * ROUNDS {
            own = own.min(step_time(&scene, "stepper", &[&contact]).0);
            transcribed = transcribed.min(plain(&scene, approaching_only));
            rapier = rapier.min(step_time(&part, "rapier-f64", &[]).0);
        }
        println!("  contact={rule}");
        println!(
            "    stepper                  {:10.1} ns   (demanded: at most 180)",
            own * 1e9
        );
        println!("    transcription            {:10.1} ns", transcribed * 1e9);
        println!(
            "    rapier-f64               {:10.1} ns   (4 substeps, first 1.5 s)",
            rapier * 1e9
        );
        println!("    transcription / stepper  {:10.2}", transcribed / own);
        println!(
            "    rapier / stepper         {:10.0}      (demanded: above 100)",
            rapier / own
        );
    }
}

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    let mut group = criterion.benchmark_group("stepper, discs in a box");
    for n in [16, 1_000] {
        let scene = gas(n);
        group.sample_size(20);
        group.throughput(Throughput::Elements((steps(n) * n as f64) as u64));
        group.bench_function(n.to_string(), |bencher| {
            bencher.iter_batched(
                || prepared(&scene, "stepper", &[CLEAN]),
                |run| black_box(run.simulate(carom::trace::Record::Final, &Limits::NONE)),
                BatchSize::LargeInput,
            );
        });
    }
    group.finish();
    criterion.final_summary();
    // `cargo test --benches` only checks that everything runs
    if !std::env::args().any(|argument| argument == "--test") {
        ratios();
        crossover();
        sizes("frictionless discs at density 0.3", &SIZES.map(gas));
        sizes(
            "discs at density 0.3 on a cloth, mu 0.001",
            &SIZES.map(sliding),
        );
    }
}
