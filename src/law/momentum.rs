//! An impact of two balls keeps their momentum.

use super::{Held, Law, Reads};
use crate::physics::invariants::Invariant;
use crate::scene::Scene;

/// An impact may miss so many ulp of the largest momentum that a ball can have.
///
/// An impact projects the velocities of two balls on their normal (three products and two sums each), changes them by one impulse over each
/// mass and adds that in three components: some ten roundings a ball, each of half an ulp of a speed that is at most the fastest possible,
/// and the impulse of friction as many again. Rapier's own figure is 1e-15 in f64.
const ULPS: f64 = 64.0;

/// The invariant.
pub const LAW: Law = Law {
    invariant: Invariant::Momentum,
    unit: "m v0",
    what: "impacts of two balls keep their momentum within 64 ulp",
    reads: Reads::Run(|run| {
        Some(Held {
            seen: run.trace.extrema.momentum,
            bound: bound(run.scene, run.ulp),
        })
    }),
};

/// What the momentum of two balls may change by in an impact, mass * length/s; `ulp`: spacing of the engine's numbers just above 1.
///
/// The size of the numbers is the heaviest mass times the largest possible speed.
pub fn bound(scene: &Scene, ulp: f64) -> f64 {
    ULPS * ulp * heaviest(scene) * scene.fastest()
}

/// The largest mass of a ball.
pub fn heaviest(scene: &Scene) -> f64 {
    scene.balls.iter().map(|b| b.mass).fold(0.0, f64::max)
}
