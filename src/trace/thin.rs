//! Leaves out knots that the others give: a stepping engine records far more of a ball than its motion has.

use super::path::interpolate;
use super::{Knot, Path};
use crate::math::Vec3;
use std::collections::BTreeSet;

/// By how much a knot that is left out may differ from what the others give.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Of positions, length.
    pub position: f64,
    /// Of velocities, length/s.
    pub velocity: f64,
    /// Of spins, rad/s.
    pub spin: f64,
}

/// Which jumps of a path keep both of their sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Jumps<'a> {
    /// Every one.
    All,
    /// The first of each event for which the list, by the index of the event, says so: the others, and the further exchanges of a
    /// contact, may be left out as if nothing had jumped there.
    FirstOf(&'a [bool]),
}

impl Jumps<'_> {
    /// True if the jump into a knot keeps its sides; `first`: it is the first that belongs to its event.
    fn keeps(self, knot: &Knot, first: bool) -> bool {
        match (self, knot.after) {
            (Jumps::FirstOf(wanted), Some(event)) => {
                first && wanted.get(event as usize).is_none_or(|wanted| *wanted)
            }
            _ => true,
        }
    }
}

/// A path with fewer knots. Those of `path` that it lacks are within `tolerance` of its own: position of the cubic, velocity and
/// spin of the line between two of them.
///
/// Kept are the first and the last knot, both sides of the `jumps`, and the far sides of their events where nothing jumps. A knot
/// that is not finite is kept.
pub fn thin(path: &Path, tolerance: Tolerance, jumps: Jumps) -> Path {
    let knots = &path.knots;
    let mut fixed = vec![false; knots.len()];
    let mut seen = BTreeSet::new();
    for i in 0..knots.len() {
        let twin = i > 0 && knots[i - 1].time == knots[i].time;
        let first = knots[i].after.is_some_and(|event| seen.insert(event));
        let kept = jumps.keeps(&knots[i], first);
        fixed[i] |= (kept && (twin || first)) || i == 0 || i + 1 == knots.len();
        if kept && twin {
            fixed[i - 1] = true;
        }
    }
    let mut kept = Vec::new();
    let mut start = 0;
    while start < knots.len() {
        // a stretch between two knots that have to be kept
        let end = (start + 1..knots.len())
            .find(|&i| fixed[i])
            .unwrap_or(start);
        let inner = stretch(end - start + 1, |a, b| {
            fits(&knots[start + a..=start + b], tolerance)
        });
        // the last of a stretch is the first of the next one
        kept.extend(
            inner
                .iter()
                .take(inner.len().max(2) - 1)
                .map(|i| knots[start + i]),
        );
        start = end.max(start + 1);
    }
    Path { knots: kept }
}

/// Of `count` places the ones to keep, first and last among them, so that `fits(a, b)` holds for each two that follow each other.
/// A pair of neighbours always fits.
///
/// Each step reaches as far as doubling and halving finds it to fit; `fits` looks at some `n log n` places in all, however they lie.
pub fn stretch(count: usize, fits: impl Fn(usize, usize) -> bool) -> Vec<usize> {
    let Some(last) = count.checked_sub(1) else {
        return Vec::new();
    };
    let mut kept = vec![0];
    let mut at = 0;
    while at < last {
        let (mut reach, mut beyond) = (1, 2);
        while at + beyond <= last && fits(at, at + beyond) {
            (reach, beyond) = (beyond, 2 * beyond);
        }
        // `reach` fits, `beyond` does not or is past the end
        let mut beyond = beyond.min(last - at + 1);
        while beyond - reach > 1 {
            let middle = reach + (beyond - reach) / 2;
            if fits(at, at + middle) {
                reach = middle;
            } else {
                beyond = middle;
            }
        }
        at += reach;
        kept.push(at);
    }
    kept
}

/// True if the knots between the first and the last are what those two give.
fn fits(knots: &[Knot], tolerance: Tolerance) -> bool {
    let [first, between @ .., last] = knots else {
        return true;
    };
    let within = |a: Vec3, b: Vec3, bound: f64| (a - b).norm() <= bound;
    between.iter().all(|knot| {
        let given = interpolate(first, last, knot.time);
        within(given.position, knot.state.position, tolerance.position)
            && within(given.velocity, knot.state.velocity, tolerance.velocity)
            && within(given.spin, knot.state.spin, tolerance.spin)
    })
}
