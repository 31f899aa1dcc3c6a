//! The mirror: the velocity component into the cushion is reversed, everything else stays.

use crate::math::Real;
use crate::physics::{Body, Motion, Side};

/// Motion of a ball after it meets the cushion `side`.
pub fn impact<T: Real>(ball: &Body<T>, side: Side) -> Motion<T> {
    let mut velocity = ball.velocity;
    velocity[side.axis()] = -velocity[side.axis()];
    Motion {
        velocity,
        spin: ball.spin,
    }
}
