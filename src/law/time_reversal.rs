//! Without friction or losses, the reversed end state runs back to the start.

use super::energy::is_kept;
use super::finite::is_finite;
use super::image::Image;
use super::{Law, Reads};
use crate::math::worse;
use crate::physics::State;
use crate::physics::invariants::Invariant;
use crate::scene::{Ball, Scene};
use crate::trace::{Ending, Trace};

/// The invariant; its bound is [`bound`].
pub const LAW: Law = Law {
    invariant: Invariant::TimeReversal,
    unit: "R",
    what: "where nothing dissipates, running back from the end leads to the start",
    reads: Reads::Image(IMAGE),
};

/// The scene that starts where the run ended, with every motion reversed. That need not be one that an engine accepts: balls may overlap by
/// what a step explains.
pub const IMAGE: Image = Image {
    of: |scene, trace| {
        let whole = is_kept(scene) && trace.ending == Ending::Duration;
        whole.then(|| reversed(scene, trace)).flatten()
    },
    apart: |scene, _, image| from_start(scene, image),
    must_run: false,
};

/// How far from the start it may end, R: what rounding left on the way out, `rounding` in R, grows by the factor `growth` on the way back.
pub fn bound(rounding: f64, growth: f64) -> f64 {
    rounding * growth
}

/// The scene that starts where `trace` ended, with every motion reversed; `None` if a ball left play, or is no number.
fn reversed(scene: &Scene, trace: &Trace) -> Option<Scene> {
    let mut image = scene.clone();
    // the motion is the trace's and no longer the shot's
    image.shot = None;
    for (ball, state) in image.balls.iter_mut().zip(trace.final_states()) {
        let state = state.filter(is_finite)?;
        ball.state = State {
            position: state.position,
            velocity: -state.velocity,
            spin: -state.spin,
        };
    }
    Some(image)
}

/// Largest distance of a ball from its start after running back, R.
fn from_start(scene: &Scene, back: &Trace) -> Option<f64> {
    if !back.ending.is_complete() {
        return None;
    }
    let ends = back.final_states();
    let distance = |(ball, end): (&Ball, &Option<State>)| {
        end.map_or(f64::INFINITY, |end| {
            (end.position - ball.state.position).norm()
        })
    };
    let worst = scene.balls.iter().zip(&ends).map(distance).fold(0.0, worse);
    Some(worst / scene.smallest_radius())
}
