//! Impulses of ball-cushion impacts. One file per law.

pub mod elastic;
pub mod han_2005;
pub mod mathavan_2010;
pub mod restitution;

use super::{Body, Cushion, Motion, Side};
use crate::math::Real;
use nalgebra::Vector3;

/// What a cushion leaves of a ball's motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rebound<T: Real = f64> {
    /// Velocity and spin after the impact.
    pub motion: Motion<T>,
    /// What the velocity, length/s, and `R` times the spin may be off by beyond rounding: 0 for laws in closed form.
    pub error: f64,
}

/// Motion of a ball after it meets the cushion `side`, moving outward: the door of all laws of this room.
///
/// The velocity is three-dimensional: a nose above the centre presses the ball down. What a cloth does about that is
/// [`Motion::on_cloth`].
pub fn impact<T: Real>(law: Cushion<T>, ball: &Body<T>, side: Side) -> Rebound<T> {
    match law {
        Cushion::Elastic {} => Rebound {
            motion: elastic::impact(ball, side),
            error: 0.0,
        },
        _ => richer(law, ball, side),
    }
}

/// Every law but the simplest, kept out of the code of those who need only that.
#[inline(never)]
fn richer<T: Real>(law: Cushion<T>, ball: &Body<T>, side: Side) -> Rebound<T> {
    let closed = |motion| Rebound { motion, error: 0.0 };
    match law {
        Cushion::Elastic {} => closed(elastic::impact(ball, side)),
        Cushion::Restitution { e } => closed(restitution::impact(e, ball, side)),
        Cushion::Han2005 { e, mu, height } => closed(han_2005::impact([e, mu, height], ball, side)),
        Cushion::Mathavan2010 {
            e,
            mu,
            mu_cloth,
            height,
        } => mathavan_2010::impact([e, mu, mu_cloth, height], ball, side),
    }
}

/// Coordinates in which a cushion is met: x into it, y along it, z up. A quarter turn of the scene, so nothing is rounded.
fn facing<T: Real>(side: Side, v: &Vector3<T>) -> Vector3<T> {
    match side {
        Side::X1 => *v,
        Side::X0 => Vector3::new(-v.x, -v.y, v.z),
        Side::Y1 => Vector3::new(v.y, -v.x, v.z),
        Side::Y0 => Vector3::new(-v.y, v.x, v.z),
    }
}

/// Back from the coordinates of [`facing`] to those of the scene.
fn turned_back<T: Real>(side: Side, v: &Vector3<T>) -> Vector3<T> {
    match side {
        Side::X1 => *v,
        Side::X0 => Vector3::new(-v.x, -v.y, v.z),
        Side::Y1 => Vector3::new(-v.y, v.x, v.z),
        Side::Y0 => Vector3::new(v.y, -v.x, v.z),
    }
}

/// Sine and cosine of the angle by which the nose stands above the centre: `sin th = height - 1`, `height` in radii.
fn nose<T: Real>(height: T) -> (T, T) {
    let sin = height - T::one();
    (sin, (T::one() - sin * sin).sqrt())
}
