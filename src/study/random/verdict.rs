//! One trace held against everything that must hold whatever the scene: finite, no energy out of nothing, nobody outside, no overlap, no
//! collision passed over.
//!
//! Measures and bounds are those of [`crate::law`]; what is measured by the paths of a trace is believed before its own account. Parry is
//! asked for overlaps and sweeps.

use crate::compare::{Sweep, sweep, worst_overlap};
use crate::law::closed_forms::Laws;
use crate::law::{Fault, Reach, Run, energy, finite, outside, overlap};
use crate::math::{within, worse};
use crate::scene::Scene;
use crate::trace::{Ending, Trace};

/// What a check of one trace saw.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Verdict {
    /// What must not be; empty if all is well.
    pub faults: Vec<Fault>,
    /// Largest rise of the energy above its start, in the energy at the start.
    pub energy: f64,
    /// Farthest outside, in what is allowed.
    pub outside: f64,
    /// Deepest overlap, in what is allowed.
    pub overlap: f64,
    /// What the sweep for collisions that were passed over saw, where there was one.
    pub sweep: Option<Sweep>,
    /// What was held against the laws, where the engine promises them.
    pub laws: Option<Laws>,
}

/// Checks a trace of `scene`; `sweeps`: also for collisions that it passed over.
pub fn check(scene: &Scene, trace: &Trace, sweeps: bool) -> Verdict {
    let mut verdict = Verdict::default();
    if let Some(fault) = not_finite(trace) {
        verdict.faults.push(fault);
        // nothing else can be said of numbers that are none
        return verdict;
    }
    let run = Run::of(scene, trace);
    let reach = run.reach();
    check_energy(scene, trace, &mut verdict);
    check_outside(&run, &reach, &mut verdict);
    check_overlap(&run, &reach, &mut verdict);
    if sweeps && run.step() == 0.0 && scene.effects.contact.is_some() {
        let seen = sweep(scene, trace, reach.rounding);
        for (a, b, time) in &seen.overlaps {
            let words = format!("{} and {} at {time:e} s", trace.balls[*a], trace.balls[*b]);
            verdict.faults.push(Fault::new("passed-over", words));
        }
        verdict.sweep = Some(seen);
    }
    verdict
}

fn not_finite(trace: &Trace) -> Option<Fault> {
    if let Some((ball, knot)) = finite::strange(trace).next() {
        let id = &trace.balls[ball];
        let words = format!("ball {id} at {:e} s: {:?}", knot.time, knot.state);
        return Some(Fault::new("not-finite", words));
    }
    match &trace.ending {
        // an engine that steps has no excuse: legal numbers are far from where their products overflow
        Ending::NotFinite(spot) if trace.provenance.resolution > 0.0 => {
            let words = format!("ended so at {:e} s: {}", spot.time, spot.why);
            Some(Fault::new("not-finite", words))
        }
        _ => None,
    }
}

fn check_energy(scene: &Scene, trace: &Trace, verdict: &mut Verdict) {
    let Some((most, when)) = energy::highest(scene, trace) else {
        return;
    };
    let start = scene.initial_energy();
    verdict.energy = if start > 0.0 {
        (most - start) / start
    } else {
        f64::INFINITY
    };
    let allowed = energy::above_start(scene, trace.end_time);
    if !within(verdict.energy, allowed) {
        let gained = verdict.energy;
        let words =
            format!("{gained:e} of the {start:e} at the start, at {when:e} s, allowed {allowed:e}");
        verdict.faults.push(Fault::new("energy", words));
    }
}

fn check_outside(run: &Run<'_>, reach: &Reach, verdict: &mut Verdict) {
    let (part, first) = outside::worst(run, reach);
    verdict.outside = part;
    if let Some((ball, time, beyond, allowed)) = first {
        let id = &run.trace.balls[ball];
        let words = format!("ball {id} by {beyond:e} at {time:e} s, allowed {allowed:e}");
        verdict.faults.push(Fault::new("outside", words));
    }
}

fn check_overlap(run: &Run<'_>, reach: &Reach, verdict: &mut Verdict) {
    let (scene, trace) = (run.scene, run.trace);
    if scene.effects.contact.is_none() {
        return;
    }
    let mut report = |who: &str, balls: [usize; 2], time: f64, depth: f64, more: f64| {
        let allowed = overlap::in_contact(run, reach, balls, more);
        verdict.overlap = worse(verdict.overlap, depth / allowed);
        if !within(depth, allowed) {
            let [first, second] = balls.map(|ball| &trace.balls[ball]);
            let words = format!(
                "{first} and {second} by {depth:e} at {time:e} s by {who}, allowed {allowed:e}"
            );
            verdict.faults.push(Fault::new("overlap", words));
        }
    };
    let own = &trace.extrema.overlap;
    if let Some((a, b)) = own.ball.zip(own.other) {
        let pair = [a as usize, b as usize];
        report("its own account", pair, own.time, own.value, 0.0);
    }
    let more = overlap::AT_KNOTS;
    let allowed = |a, b| overlap::in_contact(run, reach, [a, b], more);
    if let Some(worst) = worst_overlap(scene, trace, &allowed) {
        let (a, b) = worst.balls;
        report("parry", [a, b], worst.time, worst.depth, more);
    }
}
