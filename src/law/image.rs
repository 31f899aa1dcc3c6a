//! A scene and its image must run alike: how far apart two such runs end, and how far they may.

use crate::math::{Vec3, worse};
use crate::physics::State;
use crate::scene::Scene;
use crate::trace::{Ending, Trace};

/// An image of a scene that must run alike.
#[derive(Clone, Copy, Debug)]
pub struct Image {
    /// The image of a scene, of which the trace is a run; `None` where there is none, or none that says more.
    pub of: fn(&Scene, &Trace) -> Option<Scene>,
    /// How far the run of the image, the second trace, ends from where that of the scene says, R; infinite where it ends otherwise; `None`
    /// where either has no end to compare.
    pub apart: fn(&Scene, &Trace, &Trace) -> Option<f64>,
    /// True where an engine that runs the scene must run the image as well.
    pub must_run: bool,
}

/// How far apart the ends of a run and of its image may be, R.
///
/// `rounding`: what rounding has grown to by the end, R ([`crate::oracle::rounding`] times the growth of the run, over R). `stepping`: what steps make of a
/// run, R; each of the two is off by as much. Where more than a radius would be explained nothing is.
pub fn bound(rounding: f64, stepping: f64) -> f64 {
    rounding.max(2.0 * stepping).min(1.0)
}

/// Largest distance of a ball's end from where its image ends, R, for an image that lists the balls in the same order. `back`: from a
/// state of the image to one of the scene.
pub(super) fn apart_in_order(
    scene: &Scene,
    trace: &Trace,
    image: &Trace,
    back: fn(&State) -> State,
) -> Option<f64> {
    let order: Vec<usize> = (0..scene.balls.len()).collect();
    apart(scene, trace, image, back, &order)
}

/// The same. `order`: whose image each ball of the image is.
///
/// Infinite where the image ends otherwise, or another ball leaves play; `None` where either run has no end.
pub(super) fn apart(
    scene: &Scene,
    trace: &Trace,
    image: &Trace,
    back: fn(&State) -> State,
    order: &[usize],
) -> Option<f64> {
    let broken = |trace: &Trace| matches!(trace.ending, Ending::NotFinite(_));
    if broken(trace) || broken(image) {
        return None;
    }
    let complete = (trace.ending.is_complete(), image.ending.is_complete());
    if complete.0 != complete.1 || (!complete.0 && trace.ending.id() != image.ending.id()) {
        return Some(f64::INFINITY);
    }
    let (ours, theirs) = if complete.0 {
        let ends = |trace: &Trace, back: fn(&State) -> State| -> Vec<Option<Vec3>> {
            let states = trace.final_states().into_iter();
            states.map(|s| s.map(|s| back(&s).position)).collect()
        };
        (ends(trace, |s| *s), ends(image, back))
    } else {
        // both ended early: where both still know
        let end = trace.end_time.min(image.end_time);
        let at = |trace: &Trace, back: fn(&State) -> State| -> Vec<Option<Vec3>> {
            (0..order.len())
                .map(|ball| trace.in_play_at(ball, end).map(|s| back(&s).position))
                .collect()
        };
        (at(trace, |s| *s), at(image, back))
    };
    let distance = |(at, &ball): (usize, &usize)| match (ours[ball], theirs[at]) {
        (Some(p), Some(q)) => (p - q).norm(),
        (None, None) => 0.0,
        _ => f64::INFINITY,
    };
    let worst = order.iter().enumerate().map(distance).fold(0.0, worse);
    Some(worst / scene.smallest_radius())
}
