//! The scene with its balls in another order gives the same trace.

use super::image::{Image, apart};
use super::{Law, Reads};
use crate::physics::invariants::Invariant;
use crate::scene::{Scene, Shot};

/// The invariant; its bound is that of every image, [`super::image::bound`].
pub const LAW: Law = Law {
    invariant: Invariant::Relabelling,
    unit: "R",
    what: "the scene with its balls listed in reverse ends in the same places, within the same",
    reads: Reads::Image(IMAGE),
};

/// The scene with its balls listed in reverse; none for a ball alone.
pub const IMAGE: Image = Image {
    of: |scene, _| (scene.balls.len() > 1).then(|| relabelled(scene)),
    apart: |scene, trace, image| {
        let order: Vec<usize> = (0..scene.balls.len()).rev().collect();
        apart(scene, trace, image, |state| *state, &order)
    },
    must_run: true,
};

/// The scene with its balls listed in reverse. Who is shot does not change.
fn relabelled(scene: &Scene) -> Scene {
    let mut image = scene.clone();
    image.balls.reverse();
    let last = scene.balls.len() - 1;
    match &mut image.shot {
        Some(
            Shot::Force { ball, .. } | Shot::Velocity { ball, .. } | Shot::Strike { ball, .. },
        ) => *ball = last - *ball,
        None => {}
    }
    image
}
