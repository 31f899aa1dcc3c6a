//! A mirrored scene gives the mirrored trace.

use super::image::{Image, apart_in_order};
use super::{Law, Reads};
use crate::math::Vec3;
use crate::physics::State;
use crate::physics::invariants::Invariant;
use crate::scene::{Scene, Shot, Table};

/// The invariant; its bound is that of every image, [`super::image::bound`].
pub const LAW: Law = Law {
    invariant: Invariant::Mirror,
    unit: "R",
    what: "the mirrored scene ends in the mirrored places, within rounding times the growth, or twice what its steps make of it, and R",
    reads: Reads::Image(IMAGE),
};

/// The scene mirrored at x = 0.
pub const IMAGE: Image = Image {
    of: |scene, _| Some(mirrored(scene)),
    apart: |scene, trace, image| apart_in_order(scene, trace, image, mirror),
    must_run: true,
};

/// The scene mirrored at x = 0. Every number only changes its sign, so that rounding is mirrored as well.
fn mirrored(scene: &Scene) -> Scene {
    let mut image = scene.clone();
    for ball in &mut image.balls {
        ball.state = mirror(&ball.state);
    }
    image.table = scene.table.map(|table| Table {
        min: [-table.max[0], table.min[1]],
        max: [-table.min[0], table.max[1]],
    });
    for circle in image
        .effects
        .pockets
        .iter_mut()
        .flat_map(|p| &mut p.circles)
    {
        circle[0] = -circle[0];
    }
    match &mut image.shot {
        Some(Shot::Force { angle_deg, .. } | Shot::Velocity { angle_deg, .. }) => {
            *angle_deg = 180.0 - *angle_deg;
        }
        Some(Shot::Strike { strike, .. }) => {
            strike.angle_deg = 180.0 - strike.angle_deg;
            strike.side = -strike.side;
        }
        None => {}
    }
    image
}

/// A state mirrored at x = 0. A spin is the vector of a turn, whose sense a mirror reverses.
fn mirror(state: &State) -> State {
    let across = |v: Vec3| Vec3::new(-v.x, v.y, v.z);
    State {
        position: across(state.position),
        velocity: across(state.velocity),
        spin: -across(state.spin),
    }
}
