//! The distance between two traces over time.

use crate::math::{Vec3, worse};
use crate::trace::{Path, Trace};

/// Largest distance over all balls at each time at which either trace has a knot, seen from both sides of jumps.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Divergence {
    /// Time in s and distance in length, by time.
    pub points: Vec<(f64, f64)>,
}

impl Divergence {
    /// The largest distance before time `t`, length.
    pub fn largest_before(&self, t: f64) -> f64 {
        self.points
            .iter()
            .filter(|(time, _)| *time < t)
            .map(|&(_, distance)| distance)
            .fold(0.0, worse)
    }
}

/// Distance of two traces at the knots of both.
pub fn divergence(a: &Trace, b: &Trace) -> Divergence {
    let end = super::common_end(a, b);
    let mut points: Vec<(f64, f64)> = Vec::new();
    for (ours, theirs) in a.paths.iter().zip(&b.paths) {
        distances(ours, theirs, end, &mut points);
    }
    points.sort_by(|p, q| p.0.total_cmp(&q.0));
    points.dedup_by(|next, kept| {
        let same_time = next.0 == kept.0;
        if same_time {
            kept.1 = worse(kept.1, next.1);
        }
        same_time
    });
    Divergence { points }
}

fn distances(a: &Path, b: &Path, end: f64, points: &mut Vec<(f64, f64)>) {
    let mut times: Vec<f64> = a
        .knots
        .iter()
        .chain(&b.knots)
        .map(|knot| knot.time)
        .filter(|t| *t <= end)
        .collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    let apart = |p: Option<Vec3>, q: Option<Vec3>| p.zip(q).map(|(p, q)| (p - q).norm());
    for t in times {
        let position = |path: &Path, far: bool| {
            if far {
                path.state_at(t)
            } else {
                path.before(t)
            }
            .map(|state| state.position)
        };
        let near = apart(position(a, false), position(b, false));
        let far = apart(position(a, true), position(b, true));
        if let Some((near, far)) = near.zip(far) {
            points.push((t, worse(near, far)));
        }
    }
}
