//! The mirror with a loss: the velocity component into the cushion is reversed and multiplied by `e`, everything else stays.

use crate::math::Real;
use crate::physics::{Body, Motion, Side};

/// Motion of a ball after it meets the cushion `side` with restitution `e`, 0 to 1. With `e = 1` it is the elastic law to the bit.
pub fn impact<T: Real>(e: T, ball: &Body<T>, side: Side) -> Motion<T> {
    let mut velocity = ball.velocity;
    velocity[side.axis()] = -(e * velocity[side.axis()]);
    Motion {
        velocity,
        spin: ball.spin,
    }
}
