//! Impact of smooth balls that keeps momentum and kinetic energy.

use crate::math::Real;
use crate::physics::{Body, Motion};
use nalgebra::Vector3;

/// Motion of both balls after an elastic impact along `n` (unit, from the first ball to the second).
///
/// Normal impulse `J = 2 v_n m1 m2 / (m1 + m2)`, `v_n = (v1 - v2) . n`. Equal masses exchange their normal components.
pub fn impact<T: Real>(
    first: &Body<T>,
    second: &Body<T>,
    n: &Vector3<T>,
) -> (Motion<T>, Motion<T>) {
    exchange((first.velocity - second.velocity).dot(n), first, second, n)
}

/// The motions that a normal impulse `2 v_n m1 m2 / (m1 + m2)` leaves; `speed`: its `v_n`, length/s.
pub(super) fn exchange<T: Real>(
    speed: T,
    first: &Body<T>,
    second: &Body<T>,
    n: &Vector3<T>,
) -> (Motion<T>, Motion<T>) {
    // with equal masses each factor is exactly 1: the quotient must not round the exchange
    let (f1, f2) = if first.mass == second.mass {
        (T::one(), T::one())
    } else {
        let half_total = (first.mass + second.mass) / T::lift(2.0);
        (second.mass / half_total, first.mass / half_total)
    };
    (
        Motion {
            velocity: first.velocity - n * (f1 * speed),
            spin: first.spin,
        },
        Motion {
            velocity: second.velocity + n * (f2 * speed),
            spin: second.spin,
        },
    )
}
