//! Under friction every ball comes to rest.

use super::{Held, Law, Reads};
use crate::physics::invariants::Invariant;
use crate::physics::{Cloth, State};
use crate::scene::Scene;
use crate::trace::{Ending, Trace};

/// The invariant. An engine promises it where the law of friction stops everything within the scene's time.
pub const LAW: Law = Law {
    invariant: Invariant::EverythingStops,
    unit: "",
    what: "balls that the law of friction stops within the scene's time do stop",
    reads: Reads::Run(|run| applies(run.trace).then(|| Held::none_of(moving(run.trace).len()))),
};

/// True for a run that came to an end of its own: what was cut short says nothing.
pub fn applies(trace: &Trace) -> bool {
    matches!(trace.ending, Ending::Rest | Ending::Duration)
}

/// Balls that still move at the end, faster than the engine calls rest.
pub fn moving(trace: &Trace) -> Vec<usize> {
    let rest = trace.provenance.rest_speed;
    let moves =
        |state: &Option<State>| state.is_some_and(|s| s.speed().is_nan() || s.speed() > rest);
    let states = trace.final_states().into_iter().enumerate();
    let moving = states.filter(|(_, state)| moves(state));
    moving.map(|(ball, _)| ball).collect()
}

/// When a law of friction has stopped everything, s, whatever balls do to each other; `None` where no law here says so.
///
/// Under sliding friction alone `d/dt sqrt(E)` is at most `-mu g sqrt(m/2)` with the lightest mass while anything moves, and no impact
/// raises `E`: the fastest possible speed over `mu g`.
pub fn latest(scene: &Scene) -> Option<f64> {
    match scene.effects.cloth? {
        Cloth::Translational { mu } => Some(scene.fastest() / (mu * scene.gravity)),
        Cloth::Rotational { .. } => None,
    }
}
