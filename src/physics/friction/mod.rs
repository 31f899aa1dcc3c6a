//! Friction between two balls that meet: the tangential impulse that throws the object ball and turns both.
//!
//! One file per law of the coefficient; what all of them share, Coulomb's impulse with its limit at rolling, is here.

pub mod alciatore;
pub mod constant;

use super::{Body, Friction, Motion};
use crate::math::Real;
use nalgebra::Vector3;

/// Coefficient of friction of a law at the slip speed `slip`, length/s, >= 0.
pub fn coefficient<T: Real>(law: Friction<T>, slip: T) -> T {
    match law {
        Friction::Constant { mu } => constant::coefficient(mu),
        Friction::Alciatore {
            a,
            b,
            c,
            length_in_metres,
        } => alciatore::coefficient([a, b, c], slip * T::lift(length_in_metres)),
    }
}

/// Slip velocity of the first ball's surface over the second's where they touch, length/s.
///
/// `u = (v1 - v2)` minus its part along `n`, plus `(R1 w1 + R2 w2) x n`. `n`: unit, from the first ball to the second.
pub fn slip_velocity<T: Real>(first: &Body<T>, second: &Body<T>, n: &Vector3<T>) -> Vector3<T> {
    let relative = first.velocity - second.velocity;
    let turning = first.spin * first.radius + second.spin * second.radius;
    relative - n * relative.dot(n) + turning.cross(n)
}

/// The motions `smooth` that a law without friction gives, with the tangential impulse added.
///
/// The first ball receives `-J_t u / |u|`, the second the opposite, with `J_t = min(mu J_n, 2/7 m1 m2 / (m1 + m2) |u|)`: the
/// first is Coulomb's limit, the second the impulse that ends the slip of two solid spheres. Both spins change by
/// `5 / (2 m R) n x J`. `J_n` is the normal impulse of `smooth`. `mu` is taken at the slip speed before the impact.
pub fn rub<T: Real>(
    law: Friction<T>,
    first: &Body<T>,
    second: &Body<T>,
    n: &Vector3<T>,
    (one, two): (Motion<T>, Motion<T>),
) -> (Motion<T>, Motion<T>) {
    let slip = slip_velocity(first, second, n);
    let speed = slip.dot(&slip).sqrt();
    if speed == T::zero() {
        return (one, two);
    }
    // told by the lighter ball: what a heavy one loses drowns in the rounding of its speed
    let normal = if second.mass < first.mass {
        (two.velocity - second.velocity).dot(n) * second.mass
    } else {
        (first.velocity - one.velocity).dot(n) * first.mass
    };
    let reduced = first.mass * second.mass / (first.mass + second.mass);
    let sticking = reduced * T::lift(2.0) / T::lift(7.0);
    let limit = coefficient(law, speed) * normal;
    // the sticking branch does not divide by the slip speed, so it is smooth where that vanishes
    let impulse = if limit < sticking * speed {
        slip * (-(limit / speed))
    } else {
        slip * -sticking
    };
    let turn = n.cross(&impulse) * (T::lift(5.0) / T::lift(2.0));
    let moved = |motion: &Motion<T>, ball: &Body<T>, sign: T| Motion {
        velocity: motion.velocity + impulse * (sign / ball.mass),
        spin: motion.spin + turn * (T::one() / (ball.mass * ball.radius)),
    };
    (moved(&one, first, T::one()), moved(&two, second, -T::one()))
}
