//! What the exact engine knows of a scene, and what a first-order engine may miss of it.
//!
//! An engine with a step finds a collision up to one step late, by which two balls have come up to `2 v dt` too near. Each collision hands
//! such an error on, grown as the exact run grows from there: by G_k / G_i from collision i to the k-th, where G_i is the largest factor by
//! which a perturbation of the start has grown just after collision i. So after k collisions a position may be off by
//! `2 v dt (1 + sum of G_k / G_i)`, v the largest speed of the exact run. To it comes rounding: each step and each collision rounds
//! positions and velocities once, which adds up to `(steps + k + 1) ulp (X + v t) G_k`, X the largest coordinate.

use crate::engine::Limits;
use crate::engine::exact::Precision;
use crate::engine::exact::horizon::{BAND, Horizon, Sight, horizon};
use crate::math::worse;
use crate::scene::{Scene, Simultaneous};
use crate::trace::{Ending, Trace};

/// What the exact engine knows of a scene.
#[derive(Clone, Debug)]
pub struct Oracle {
    /// Its run in f64.
    pub trace: Trace,
    /// Time up to which two precisions agree about it, s; infinite for the whole run.
    pub until: f64,
    /// Events up to there, and of the run.
    pub certain: (usize, usize),
    /// Largest factor by which a perturbation of the start has grown up to each collision, at least 1, never falling; the last is that of
    /// the whole run.
    pub growth: Vec<f64>,
    /// Largest speed of a ball at any event, length/s.
    pub fastest: f64,
}

impl Oracle {
    /// Asks the exact engine; `None` where it cannot say how far its own run can be believed.
    pub fn ask(scene: &Scene, limits: &Limits<'_>) -> Option<Oracle> {
        let found = horizon(scene, Precision::F64, true, limits)?;
        if found.trace.ending == Ending::Cancelled {
            return None;
        }
        let (certain, until) = match scene.simultaneous {
            Simultaneous::Refuse | Simultaneous::Ensemble => (found.certain, found.until),
            // a convention resolves contacts that have no margin
            Simultaneous::GeneralizedReflections => by_agreement(&found),
        };
        Some(Oracle {
            until,
            certain: (certain, found.sights.len()),
            growth: by_collision(&found),
            fastest: fastest(&found.trace),
            trace: found.trace,
        })
    }

    /// True where the run reached the end that the scene asks for.
    pub fn is_complete(&self) -> bool {
        self.trace.ending.is_complete()
    }

    /// True where the run can be believed to its end.
    pub fn is_whole(&self) -> bool {
        self.until.is_infinite()
    }

    /// Growth of the whole run.
    pub fn grown(&self) -> f64 {
        self.growth.last().copied().unwrap_or(1.0)
    }

    /// By how much a position may be off after `collisions`, before the next one, length.
    pub fn allowance(&self, scene: &Scene, allowance: &Allowance, collisions: usize) -> f64 {
        let all = self.growth.len().saturating_sub(1);
        let to = self.growth[collisions.min(all)];
        let before = self.growth.iter().take(collisions.min(all));
        let handed_on: f64 = before.map(|from| to / from).sum();
        let n = collisions as f64 + 1.0;
        let path = self.fastest * self.trace.end_time.min(scene.duration);
        let stepping = 2.0 * self.fastest * allowance.dt * (1.0 + handed_on);
        let rounding =
            (allowance.steps as f64 + n) * allowance.ulp * (scene.largest_coordinate() + path);
        stepping + rounding * to
    }
}

/// Number of events about which two precisions agree, and the time of the next, s, whatever their margins.
fn by_agreement(found: &Horizon) -> (usize, f64) {
    let differs = |sight: &Sight| !sight.apart.is_some_and(|apart| apart < BAND);
    let first = found.sights.iter().position(differs);
    let time = |index: usize| found.sights[index].event.time;
    (
        first.unwrap_or(found.sights.len()),
        first.map_or(f64::INFINITY, time),
    )
}

/// Growth up to each collision, and at the end.
fn by_collision(found: &Horizon) -> Vec<f64> {
    let factors = found.growth.as_ref().map_or(&[][..], |g| &g.factors);
    let mut most = 1.0;
    let mut grown = Vec::new();
    for (index, event) in found.trace.events.iter().enumerate() {
        most = worse(most, factors.get(index).copied().unwrap_or(most));
        if event.kind.is_collision() {
            grown.push(most);
        }
    }
    grown.push(most);
    // a factor that overflowed bounds nothing
    let bound = |g: f64| if g.is_nan() { f64::INFINITY } else { g };
    grown.into_iter().map(bound).collect()
}

/// What of an engine an error may come from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Allowance {
    /// Step, s; 0 without one.
    pub dt: f64,
    /// Steps taken.
    pub steps: u64,
    /// Rounding of the scalar.
    pub ulp: f64,
}

/// Largest speed of any ball at any knot, length/s.
pub fn fastest(trace: &Trace) -> f64 {
    let knots = trace.paths.iter().flat_map(|path| &path.knots);
    knots.map(|knot| knot.state.speed()).fold(0.0, worse)
}
