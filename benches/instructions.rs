//! Instructions of whole pieces of work, counted by callgrind and held against committed counts.
//!
//! `.ci/instructions` installs what this needs, runs it and fails where a count has moved; `.ci/instructions --accept` takes new
//! counts. Without valgrind or gungraun's runner nothing is counted, and it says so.

#![allow(missing_docs, clippy::expect_used, clippy::print_stdout)]

mod bare;
mod counts;
mod runs;

use carom::compare::{self, Comparison};
use carom::engine::{Limits, Run};
use carom::finding::Finding;
use carom::scene::generate::Recipe;
use carom::scene::{Scene, parse};
use carom::trace::{Record, Trace};
use gungraun::{library_benchmark, library_benchmark_group};
use std::hint::black_box;

/// A prepared run of a scene that lives as long as the process, which counts one piece of work and ends.
fn ready(scene: Scene, engine: &str, pairs: &[&str]) -> Box<dyn Run> {
    runs::prepared(Box::leak(Box::new(scene)), engine, pairs)
}

fn gas(balls: usize, duration: f64) -> Scene {
    runs::discs(&Recipe {
        balls,
        density: runs::DENSITY,
        duration,
        ..Recipe::default()
    })
}

fn whole_break() -> Box<dyn Run> {
    ready(runs::scene("report-break"), "exact", &[])
}

fn thousand_discs() -> Box<dyn Run> {
    ready(gas(1000, 1e5), "exact", &[])
}

/// 1000 steps of the report's break from its middle, or of a box of discs.
fn stepped(balls: usize) -> Box<dyn Run> {
    let scene = match balls {
        16 => runs::mid_break(runs::shot(16), 1.0),
        _ => gas(balls, 1.0),
    };
    ready(scene, "stepper", &[])
}

/// 250 steps of the report's break from its middle.
fn middle() -> Scene {
    runs::mid_break(runs::shot(16), 250.0 * bare::DT)
}

fn in_rapier() -> Box<dyn Run> {
    ready(middle(), "rapier-f64", &[])
}

fn in_bare_rapier() -> bare::Bare {
    bare::Bare::new(&middle())
}

/// The stepper's break and its reference.
fn row() -> (Scene, Trace, Trace) {
    let scene = runs::scene("report-break");
    let trace = |engine, pairs: &[&str]| {
        let run = runs::prepared(&scene, engine, pairs);
        run.simulate(Record::Every(0.02), &Limits::NONE)
    };
    let stepper = trace("stepper", &["contact=approaching-only"]);
    let exact = trace("exact", &[]);
    (scene, stepper, exact)
}

#[library_benchmark]
#[bench::exact_break(setup = whole_break)]
#[bench::stepper_16_balls(args = (16), setup = stepped)]
#[bench::stepper_1000_balls(args = (1000), setup = stepped)]
#[bench::rapier_f64_16_balls(setup = in_rapier)]
fn run(run: Box<dyn Run>) -> Trace {
    black_box(run.simulate(Record::Final, &Limits::NONE))
}

#[library_benchmark]
#[bench::exact_1000_balls(setup = thousand_discs)]
fn events(run: Box<dyn Run>) -> Trace {
    let limits = Limits {
        max_events: 2000,
        ..Limits::NONE
    };
    black_box(run.simulate(Record::Final, &limits))
}

#[library_benchmark]
#[bench::rapier_alone_16_balls(setup = in_bare_rapier)]
fn steps(bare: bare::Bare) -> Vec<[f64; 3]> {
    black_box(bare.run(250))
}

#[library_benchmark]
#[bench::row(setup = row)]
fn compared((scene, trace, exact): (Scene, Trace, Trace)) -> Vec<Finding> {
    let comparison = Comparison::new(&scene, &trace, &exact);
    let mut findings = compare::of_trace(&scene, "stepper", &trace);
    findings.extend(compare::of_pair(&comparison, "stepper"));
    black_box(findings)
}

#[library_benchmark]
#[bench::scene(include_str!("../validation/scenes/report-break.toml"))]
fn parsed(text: &str) -> Scene {
    black_box(parse("report-break.toml", text).expect("a scene of the catalogue"))
}

library_benchmark_group!(
    name = counted,
    benchmarks = [run, events, steps, compared, parsed]
);

/// gungraun's own `main`, in a room of its own: ours decides whether it runs.
mod gungraun_main {
    use super::counted;

    gungraun::main!(library_benchmark_groups = counted);

    pub fn run() {
        main();
    }
}

fn main() {
    if counts::inside() {
        gungraun_main::run();
    } else {
        counts::hold();
    }
}
