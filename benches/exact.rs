//! Cost of the exact engine: whole shots, and events.

#![allow(clippy::unwrap_used, clippy::print_stderr, missing_docs)]

use carom::engine::{self, Limits, Setting};
use carom::scene::Scene;
use carom::trace::{Record, Trace};
use criterion::{BatchSize, Criterion, Throughput};
use std::hint::black_box;
use std::time::Duration;

#[path = "../tests/suite/support.rs"]
#[allow(dead_code)]
mod support;

use support::{MU, R, scenario};

/// The report's break: gap 1e-2 R, aimed .2 degrees off, v = F t / m = 10.09.
fn report_break() -> Scene {
    break_at(MU)
}

fn break_at(mu: f64) -> Scene {
    let (spacing, apex) = (2.0 * R + 1e-2 * R, 18.225);
    let mut builder = scenario("report-break")
        .cushions(12.63, 24.3)
        .cloth(mu)
        .shot("cue", [6.315, 6.075], 108.0 * 0.01 / 0.107, 90.2);
    let mut id = 0;
    for row in 0..5 {
        for place in 0..=row {
            id += 1;
            let x = 6.315 + spacing * (f64::from(place) - 0.5 * f64::from(row));
            let y = apex + spacing * f64::from(row) * 0.75_f64.sqrt();
            builder = builder.resting(&id.to_string(), [x, y]);
        }
    }
    builder.build()
}

fn simulate(scene: &Scene, record: Record) -> Trace {
    let engine = engine::find("exact").unwrap();
    let run = engine::prepare(engine, scene, &Setting::default()).unwrap();
    run.simulate(record, &Limits::NONE)
}

fn main() {
    let mut criterion = Criterion::default()
        .sample_size(50)
        .measurement_time(Duration::from_secs(3))
        .configure_from_args();
    let engine = engine::find("exact").unwrap();
    for (name, scene) in [
        ("report-break", report_break()),
        ("break-at-low-friction", break_at(0.002)),
    ] {
        let trace = simulate(&scene, Record::Events);
        eprintln!(
            "{name}: {} events, {:?}, ended {} at {}",
            trace.events.len(),
            trace.counters,
            trace.ending.id(),
            trace.end_time
        );
        let mut group = criterion.benchmark_group(name);
        group.throughput(Throughput::Elements(trace.counters["events"]));
        for (what, record) in [("final", Record::Final), ("events", Record::Events)] {
            group.bench_function(what, |bencher| {
                bencher.iter_batched(
                    || engine::prepare(engine, &scene, &Setting::default()).unwrap(),
                    |run| black_box(run.simulate(record, &Limits::NONE)),
                    BatchSize::SmallInput,
                );
            });
        }
        group.finish();
    }
    criterion.final_summary();
}
