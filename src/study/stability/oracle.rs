//! What the exact engine knows of a scene, and what a first-order engine may miss of it.
//!
//! An engine with a step finds a collision up to one step late, by which two balls have come up to `2 v dt` too near; a later collision
//! hands the error on, grown. So a position may be off by `2 v dt (n + 1) G` after n collisions, where v is the largest speed of
//! the exact run and G the largest factor by which it lets a perturbation of the start grow. To it comes rounding: each step and
//! each collision rounds positions and velocities once, which adds up to `(steps + n + 1) ulp (X + v t) G`, X the largest coordinate.

use crate::engine::Limits;
use crate::engine::exact::Precision;
use crate::engine::exact::horizon::horizon;
use crate::math::worse;
use crate::scene::Scene;
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
    /// Largest factor by which a perturbation of the start grows, at least 1.
    pub growth: f64,
    /// Largest speed of a ball at any event, length/s.
    pub fastest: f64,
}

impl Oracle {
    /// Asks the exact engine; `None` where it cannot say how far its own run can be believed.
    pub fn ask(scene: &Scene, limits: &Limits<'_>) -> Option<Oracle> {
        let found = horizon(scene, Precision::F64, false, limits)?;
        if found.trace.ending == Ending::Cancelled {
            return None;
        }
        let growth = found.growth.as_ref().map_or(1.0, |growth| growth.last());
        Some(Oracle {
            until: found.until,
            certain: (found.certain, found.sights.len()),
            growth: if growth.is_nan() {
                f64::INFINITY
            } else {
                growth.max(1.0)
            },
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

    /// By how much a position may be off after `collisions`, length.
    ///
    /// `dt`: the engine's step, s, 0 without one. `steps`: how many it took. `ulp`: rounding of its scalar.
    pub fn allowance(&self, scene: &Scene, allowance: &Allowance, collisions: usize) -> f64 {
        let n = collisions as f64 + 1.0;
        let path = self.fastest * self.trace.end_time.min(scene.duration);
        let stepping = 2.0 * self.fastest * allowance.dt * n;
        let rounding =
            (allowance.steps as f64 + n) * allowance.ulp * (scene.largest_coordinate() + path);
        (stepping + rounding) * self.growth
    }
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
