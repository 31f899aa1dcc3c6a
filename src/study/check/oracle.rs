//! What the exact engine itself answers: what every other number is measured from must not move unseen.

use super::item::{CERTAIN, END_X, END_Y, ENDING, STOPPED};
use super::unit_of;
use crate::finding::Finding;
use crate::oracle::Oracle;
use crate::scene::Scene;

/// Label under which the exact answer of a scene is held, apart from every column.
pub const ORACLE: &str = "oracle";

/// Events within the horizon, how it ends, and where and when every ball stops if the whole run can be believed.
pub fn findings(scene: &Scene, oracle: &Oracle) -> Vec<Finding> {
    let finding = |metric: &'static str, subject: &str, value: Option<f64>| Finding {
        scene: scene.name.clone(),
        engine: ORACLE.to_owned(),
        metric,
        subject: subject.to_owned(),
        value,
        unit: unit_of(metric),
        verdict: None,
    };
    let trace = &oracle.trace;
    let whole = oracle.is_whole();
    let mut findings = vec![
        finding(CERTAIN, "", Some(oracle.certain.0 as f64)),
        finding(ENDING, trace.ending.id(), whole.then_some(trace.end_time)),
    ];
    if !whole {
        return findings;
    }
    let radius = scene.smallest_radius();
    let states = trace.final_states();
    for ((id, state), stopped) in trace.balls.iter().zip(states).zip(&trace.stop_times) {
        let at = |axis: usize| state.map(|s| s.position[axis] / radius);
        findings.push(finding(END_X, id, at(0)));
        findings.push(finding(END_Y, id, at(1)));
        findings.push(finding(STOPPED, id, *stopped));
    }
    findings
}
