//! What an event of the exact engine costs from 16 to 100 000 balls, and a break against a step of rapier, in one run.

#![allow(missing_docs, clippy::expect_used, clippy::print_stdout)]

use carom::engine::Limits;
use carom::scene::generate::{Recipe, generate};
use carom::scene::{Scene, parse, plan_vector};
use carom::trace::{Record, Trace, files};
use criterion::{BatchSize, Criterion, Throughput};
use std::hint::black_box;
use std::time::Instant;

mod runs;

use runs::{DENSITY, prepared, scene, step_time};

/// Numbers of balls.
const SIZES: [usize; 5] = [16, 100, 1_000, 10_000, 100_000];

/// Interleaved rounds; the shortest time of each counts.
const ROUNDS: usize = 5;

/// Breaks that are timed together, each with an aim of its own: one shot again and again would be learnt by heart by the
/// processor, and one alone would be timed with cold caches, which no step of rapier is.
const SHOTS: usize = 100;

fn discs(balls: usize, mu: Option<f64>) -> Scene {
    let recipe = Recipe {
        balls,
        density: DENSITY,
        mu,
        // with a cloth, fast enough for some hits before everything stops
        speed: if mu.is_some() { 10.0 } else { 1.0 },
        // longer than the budget of events lasts
        duration: 1e5,
        ..Recipe::default()
    };
    runs::discs(&recipe)
}

/// Events of one timed run: enough to pass over all of memory several times.
fn budget(balls: usize) -> u64 {
    20_000.max(4 * balls as u64)
}

/// A run of so many events, and its time in s.
fn timed(scene: &Scene, pairs: &[&str], max_events: u64) -> (f64, Trace) {
    let limits = Limits {
        max_events,
        ..Limits::NONE
    };
    runs::timed(scene, "exact", pairs, &limits)
}

/// Time of an event, s, without the first prediction of all balls, which is the second number for each ball.
fn costs(scene: &Scene, pairs: &[&str], max_events: u64) -> (f64, f64, Trace) {
    let (start, _) = timed(scene, pairs, 0);
    let (whole, trace) = timed(scene, pairs, max_events);
    let event = (whole - start) / trace.counters["events"] as f64;
    (event, start / scene.balls.len() as f64, trace)
}

/// The table of sizes: cost, exponent between a size and the one before, rate, work.
fn sizes(title: &str, mu: Option<f64>) {
    let scenes = SIZES.map(|n| discs(n, mu));
    let mut best = [(f64::INFINITY, f64::INFINITY); SIZES.len()];
    let mut works = Vec::new();
    for _ in 0..ROUNDS {
        works.clear();
        for (scene, best) in scenes.iter().zip(&mut best) {
            let (event, start, trace) = costs(scene, &[], budget(scene.balls.len()));
            *best = (best.0.min(event), best.1.min(start));
            works.push(trace);
        }
    }
    println!();
    println!("{title}, shortest of {ROUNDS} interleaved rounds");
    println!(
        "{:>8} {:>9} {:>9} {:>11} {:>11} {:>14} {:>12} {:>11}",
        "balls",
        "events",
        "ns/event",
        "exponent",
        "events/s",
        "crossings/ev.",
        "roots/ev.",
        "start ns"
    );
    for (i, n) in SIZES.into_iter().enumerate() {
        let (event, start) = best[i];
        let exponent = i.checked_sub(1).map_or(String::new(), |before| {
            let ratio = (n as f64 / SIZES[before] as f64).ln();
            format!("{:.3}", (event / best[before].0).ln() / ratio)
        });
        let count = |name: &str| works[i].counters[name] as f64;
        println!(
            "{n:>8} {:>9} {:>9.0} {exponent:>11} {:>11.3e} {:>14.2} {:>12.1} {:>11.0}",
            works[i].counters["events"],
            event * 1e9,
            1.0 / event,
            count("cell_crossings") / count("events"),
            count("root_calls") / count("events"),
            start * 1e9
        );
    }
    let between = |from: usize, to: usize| {
        (best[to].0 / best[from].0).ln() / (SIZES[to] as f64 / SIZES[from] as f64).ln()
    };
    println!(
        "  exponent from 16 to 10^4 balls  {:8.3}   (demanded: 0.2)",
        between(0, 3)
    );
    println!(
        "  exponent from 16 to 10^5 balls  {:8.3}   (demanded: 0.3)",
        between(0, 4)
    );
}

/// What comes before and after a run, for each ball: flat if it is linear.
fn set_up() {
    println!();
    println!("us for each ball, shortest of {ROUNDS} rounds");
    println!(
        "{:>8} {:>9} {:>9} {:>9}",
        "balls", "parse", "prepare", "write"
    );
    for n in SIZES {
        let recipe = Recipe {
            balls: n,
            density: DENSITY,
            ..Recipe::default()
        };
        let text = generate(&recipe).expect("a density at which discs fit");
        let mut best = [f64::INFINITY; 3];
        for _ in 0..ROUNDS {
            let mut lap = |part: usize, since: Instant| {
                let seconds = since.elapsed().as_secs_f64();
                best[part] = best[part].min(seconds / n as f64);
            };
            let start = Instant::now();
            let scene = parse("generated", &text).expect("a generated scene");
            lap(0, start);
            let start = Instant::now();
            let run = prepared(&scene, "exact", &[]);
            lap(1, start);
            let limits = Limits {
                max_events: n as u64,
                ..Limits::NONE
            };
            let trace = run.simulate(Record::Events, &limits);
            let start = Instant::now();
            black_box(files::write(&trace).expect("a trace that can be written"));
            lap(2, start);
        }
        let [parse, prepare, write] = best.map(|seconds| seconds * 1e6);
        println!("{n:>8} {parse:>9.2} {prepare:>9.2} {write:>9.2}");
    }
}

/// Looking at all balls against looking at those nearby.
fn cells() {
    println!();
    println!("ns for an event, all balls / those nearby, shortest of {ROUNDS} interleaved rounds");
    for n in [12, 16, 20, 24, 32, 64, 256, 1000] {
        let scene = discs(n, None);
        let [mut all, mut near] = [f64::INFINITY; 2];
        for _ in 0..ROUNDS {
            all = all.min(costs(&scene, &["partners=all"], 10_000).0);
            near = near.min(costs(&scene, &["partners=cells"], 10_000).0);
        }
        println!(
            "{n:>8} {:>9.0} {:>9.0} {:>8.2}",
            all * 1e9,
            near * 1e9,
            all / near
        );
    }
}

/// Breaks of the report, each aimed a little differently.
fn breaks() -> Vec<Scene> {
    let scene = scene("report-break");
    let cue = scene.cue_ball();
    let speed = scene.balls[cue].state.velocity.norm();
    let aimed = |i: usize| {
        let mut scene = scene.clone();
        let angle = 89.8 + 0.4 * i as f64 / SHOTS as f64 + 1e-3;
        scene.balls[cue].state.velocity = plan_vector(speed, angle);
        scene
    };
    (0..SHOTS).map(aimed).collect()
}

/// Breaks one after the other: their time, s, and their events.
fn shots(scenes: &[Scene]) -> (f64, u64) {
    let runs: Vec<_> = scenes.iter().map(|s| prepared(s, "exact", &[])).collect();
    let start = Instant::now();
    let mut events = 0;
    for run in runs {
        events += run.simulate(Record::Final, &Limits::NONE).counters["events"];
    }
    (start.elapsed().as_secs_f64(), events)
}

/// Prints whole breaks against a step of rapier.
fn against_rapier() {
    let scenes = breaks();
    let mut part = scene("report-break");
    // the first 1.5 s of the shot, where balls touch
    part.duration = 1.5;
    let [mut shot, mut event, mut step] = [f64::INFINITY; 3];
    for _ in 0..3 * ROUNDS {
        let (seconds, events) = shots(&scenes);
        shot = shot.min(seconds / SHOTS as f64);
        event = event.min(seconds / events as f64);
        step = step.min(step_time(&part, "rapier-f64", &[]).0);
    }
    println!();
    println!(
        "{SHOTS} breaks of 16 balls, shortest of {} interleaved rounds",
        3 * ROUNDS
    );
    println!(
        "  exact, whole shot          {:10.3} us   {:.0} shots/s",
        shot * 1e6,
        1.0 / shot
    );
    println!("  exact, one event           {:10.0} ns", event * 1e9);
    println!(
        "  rapier-f64, one step       {:10.3} us   (4 substeps, first 1.5 s)",
        step * 1e6
    );
    println!(
        "  exact shot / rapier step   {:10.3}      (demanded: below 0.5)",
        shot / step
    );
}

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    let mut group = criterion.benchmark_group("exact, discs in a box");
    for n in [16, 1_000] {
        let scene = discs(n, None);
        let limits = Limits {
            max_events: 4_000,
            ..Limits::NONE
        };
        group.sample_size(20);
        group.throughput(Throughput::Elements(limits.max_events));
        group.bench_function(n.to_string(), |bencher| {
            bencher.iter_batched(
                || prepared(&scene, "exact", &[]),
                |run| black_box(run.simulate(Record::Final, &limits)),
                BatchSize::LargeInput,
            );
        });
    }
    group.finish();
    criterion.final_summary();
    // `cargo test --benches` only checks that everything runs
    if !std::env::args().any(|argument| argument == "--test") {
        against_rapier();
        sizes("frictionless discs at density 0.3", None);
        sizes("discs at density 0.3 on a cloth, mu 0.1", Some(0.1));
        set_up();
        cells();
    }
}
