//! Two runs of one scene: two versions of an engine, two machines, two settings.

use super::held::{ENDING, WORK};
use super::{unit_of, written};
use crate::compare::{self, Comparison};
use crate::finding::Finding;
use crate::scene::Scene;
use crate::trace::Trace;

/// Everything that is measured of a trace, and of its distance from `reference`, and all that its files hold, under the label `engine`.
///
/// The distance of `reference` from itself is nothing, so that its findings and those of another run can be held against each other.
pub fn between(scene: &Scene, engine: &str, trace: &Trace, reference: &Trace) -> Vec<Finding> {
    let finding = |metric: &'static str, subject: &str, value: f64| Finding {
        scene: scene.name.clone(),
        engine: engine.to_owned(),
        metric,
        subject: subject.to_owned(),
        value: Some(value),
        unit: unit_of(metric),
        verdict: None,
    };
    let mut findings = vec![finding(ENDING, trace.ending.id(), trace.end_time)];
    findings.extend(compare::of_pair(
        &Comparison::new(scene, trace, reference),
        engine,
    ));
    findings.extend(compare::of_trace(scene, engine, trace));
    let work = trace.counters.iter();
    findings.extend(work.map(|(name, count)| finding(WORK, name, *count as f64)));
    findings.extend(written::findings(scene, engine, trace, reference));
    findings
}
