//! The scene turned by a quarter turn gives the turned trace.

use super::image::{Image, apart_in_order};
use super::{Law, Reads};
use crate::math::Vec3;
use crate::physics::State;
use crate::physics::invariants::Invariant;
use crate::scene::{Scene, Table};

/// The invariant; its bound is that of every image, [`super::image::bound`].
pub const LAW: Law = Law {
    invariant: Invariant::QuarterTurn,
    unit: "R",
    what: "the scene turned by a quarter turn ends in the turned places, within rounding times the growth, and R",
    reads: Reads::Image(IMAGE),
};

/// The scene turned left about the origin.
pub const IMAGE: Image = Image {
    of: |scene, _| Some(turned(scene)),
    apart: |scene, trace, image| apart_in_order(scene, trace, image, back),
    must_run: true,
};

/// The scene turned left about the origin; every number only changes its place and sign.
fn turned(scene: &Scene) -> Scene {
    let turn = |v: Vec3| Vec3::new(-v.y, v.x, v.z);
    let mut image = scene.clone();
    // the motion is that of the balls
    image.shot = None;
    for ball in &mut image.balls {
        ball.state = State {
            position: turn(ball.state.position),
            velocity: turn(ball.state.velocity),
            spin: turn(ball.state.spin),
        };
    }
    image.table = scene.table.map(|table| Table {
        min: [-table.max[1], table.min[0]],
        max: [-table.min[1], table.max[0]],
    });
    let pockets = image.effects.pockets.iter_mut();
    for circle in pockets.flat_map(|p| &mut p.circles) {
        (circle[0], circle[1]) = (-circle[1], circle[0]);
    }
    image
}

/// A state turned right again.
fn back(state: &State) -> State {
    let back = |v: Vec3| Vec3::new(v.y, -v.x, v.z);
    State {
        position: back(state.position),
        velocity: back(state.velocity),
        spin: back(state.spin),
    }
}
