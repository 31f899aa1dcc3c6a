//! An impact without losses keeps the kinetic energy of its two balls.

use super::{Held, Law, Reads};
use crate::math::worse;
use crate::physics::State;
use crate::physics::invariants::{Invariant, kinetic_energy};
use crate::scene::Scene;
use crate::trace::{EventKind, Extremum, Trace};
use std::collections::BTreeMap;

/// Energy of an impact is kept to so many ulp: two squares, their sums and a projection for each of two balls.
const ULPS: f64 = 64.0;

/// The invariant.
pub const LAW: Law = Law {
    invariant: Invariant::ImpactEnergy,
    unit: "E0",
    what: "impacts of two balls keep their energy within 64 ulp of the initial energy",
    reads: Reads::Run(|run| {
        let whole = run.scene.initial_energy();
        Some(Held {
            seen: Extremum {
                value: largest_change(run.scene, run.trace),
                ..Extremum::default()
            },
            bound: bound(whole, run.ulp),
        })
    }),
};

/// What the energy of two balls may change by in an impact; `whole`: the initial energy, which no two balls exceed.
pub fn bound(whole: f64, ulp: f64) -> f64 {
    ULPS * ulp * whole
}

/// Largest change of energy over a meeting of two balls, from both sides of it.
fn largest_change(scene: &Scene, trace: &Trace) -> f64 {
    let mut change: BTreeMap<u32, f64> = BTreeMap::new();
    for (ball, path) in trace.paths.iter().enumerate() {
        let energy =
            |state: &State| kinetic_energy(state, scene.balls[ball].mass, scene.inertia(ball));
        for pair in path.knots.windows(2) {
            if let Some(event) = pair[1].after {
                *change.entry(event).or_default() +=
                    energy(&pair[1].state) - energy(&pair[0].state);
            }
        }
    }
    let meets = |event: u32| {
        let event = trace.events.get(event as usize);
        event.is_some_and(|event| matches!(event.kind, EventKind::BallBall(..)))
    };
    let hits = change.iter().filter(|(event, _)| meets(**event));
    hits.map(|(_, change)| change.abs()).fold(0.0, worse)
}
