//! Splits a divergence into its causes: four measurements in one unit.
//!
//! They are measured one by one and need not add up: an error in time and an error in position can cancel, and past the
//! first wrong hit nothing is small any more.

use super::{Comparison, common_end};
use crate::math::worse;
use crate::scene::Scene;
use crate::trace::Trace;
use serde::Serialize;

/// What a divergence is made of, each in R; `None` where it was not measured.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Attribution {
    /// |engine(dt) - exact| with the same effects: what stepping in time costs.
    pub step: Option<f64>,
    /// Part of `step`: largest error of an event's time x relative speed there, over matched events.
    pub timing: Option<f64>,
    /// |the same engine in two precisions|.
    pub arithmetic: Option<f64>,
    /// |exact(this scene) - exact(the scene named `richer`)|: what the scene leaves out.
    pub model: Option<f64>,
}

/// `step` and `timing` of a comparison with the exact engine.
pub fn attribute(comparison: &Comparison<'_>) -> Attribution {
    let radius = comparison.scene.smallest_radius();
    Attribution {
        step: largest_distance_at_end(comparison.scene, comparison.trace, comparison.reference),
        timing: timing(comparison).map(|length| length / radius),
        arithmetic: None,
        model: None,
    }
}

/// Largest distance of a ball between the ends of two traces, in R of `scene`; `None` if no ball is in play in both.
pub fn largest_distance_at_end(scene: &Scene, a: &Trace, b: &Trace) -> Option<f64> {
    let distances = distances_at_end(a, b);
    let largest = distances.into_iter().flatten().reduce(worse)?;
    Some(largest / scene.smallest_radius())
}

/// Distance of each ball between the ends of two traces, seen in plan, length; `None` for a ball that left play in either. How deep
/// an engine lets a ball sink into the cloth is no place on the table.
///
/// Two traces that ended at rest are compared there, others at the earlier end.
pub(super) fn distances_at_end(a: &Trace, b: &Trace) -> Vec<Option<f64>> {
    let end = common_end(a, b);
    let distance = |i: usize| {
        if a.pocketed(i) || b.pocketed(i) {
            return None;
        }
        let (p, q) = (a.paths[i].state_at(end)?, b.paths[i].state_at(end)?);
        Some((p.position - q.position).xy().norm())
    };
    (0..a.paths.len().min(b.paths.len()))
        .map(distance)
        .collect()
}

/// Largest error of an event's time x relative speed before the event, over matched collisions, length.
///
/// `None` without a matched collision.
pub fn timing(comparison: &Comparison<'_>) -> Option<f64> {
    let ours: Vec<_> = comparison.trace.collisions().collect();
    let theirs: Vec<_> = comparison.reference.collisions().collect();
    let shift = |&(i, j): &(usize, usize)| {
        let (a, b) = theirs[j].kind.balls();
        let time = theirs[j].time;
        let velocity = |ball: usize| {
            comparison.reference.paths[ball]
                .before(time)
                .map(|s| s.velocity)
        };
        let relative = match b {
            Some(b) => velocity(a)? - velocity(b)?,
            None => velocity(a)?,
        };
        Some((ours[i].time - time).abs() * relative.norm())
    };
    comparison
        .order
        .matched
        .iter()
        .filter_map(shift)
        .reduce(worse)
}
