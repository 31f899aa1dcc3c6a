//! Lengths, speeds and gravity scaled together leave times unchanged.

use super::image::{Image, apart_in_order};
use super::{Law, Reads};
use crate::physics::invariants::Invariant;
use crate::physics::{Friction, State};
use crate::scene::{Scene, Table};

/// Lengths of the scaled scene are so many times as long: a power of two, which rounds nothing.
const SCALE: f64 = 4.0;

/// The invariant; its bound is that of every image, [`super::image::bound`].
pub const LAW: Law = Law {
    invariant: Invariant::Scaling,
    unit: "R",
    what: "the scene with lengths, speeds and gravity four times as large ends in the same places in its own measure, within rounding times \
           the growth, and R",
    reads: Reads::Image(IMAGE),
};

/// The scene four times as large.
pub const IMAGE: Image = Image {
    of: |scene, _| Some(scaled(scene)),
    apart: |scene, trace, image| apart_in_order(scene, trace, image, back),
    must_run: true,
};

/// The scene with lengths, speeds and gravity four times as large.
fn scaled(scene: &Scene) -> Scene {
    let mut image = scene.clone();
    image.shot = None;
    image.gravity *= SCALE;
    for ball in &mut image.balls {
        ball.radius *= SCALE;
        ball.state.position *= SCALE;
        ball.state.velocity *= SCALE;
    }
    image.table = scene.table.map(|table| Table {
        min: table.min.map(|x| SCALE * x),
        max: table.max.map(|x| SCALE * x),
    });
    let pockets = image.effects.pockets.iter_mut();
    for circle in pockets.flat_map(|p| &mut p.circles) {
        *circle = circle.map(|x| SCALE * x);
    }
    // a law with constants in metres: the same scene in another unit
    if let Some(Friction::Alciatore {
        length_in_metres, ..
    }) = &mut image.effects.friction
    {
        *length_in_metres /= SCALE;
    }
    image
}

/// A state in the measure of the scene. A spin is an inverse time.
fn back(state: &State) -> State {
    State {
        position: state.position / SCALE,
        velocity: state.velocity / SCALE,
        spin: state.spin,
    }
}
