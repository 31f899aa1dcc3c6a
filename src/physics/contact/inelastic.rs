//! Impact of smooth balls with restitution: momentum is kept, the relative normal velocity is reversed and reduced.

use super::elastic;
use crate::math::Real;
use crate::physics::{Body, Motion};
use nalgebra::Vector3;

/// Motion of both balls after an impact along `n` (unit, from the first ball to the second) with restitution `e`, 0 to 1.
///
/// Normal impulse `J = (1 + e) v_n m1 m2 / (m1 + m2)`, `v_n = (v1 - v2) . n` (Newton). It takes the energy
/// `(1 - e^2) m1 m2 v_n^2 / (2 (m1 + m2))`. With `e = 1` it is the elastic law to the bit.
pub fn impact<T: Real>(
    e: T,
    first: &Body<T>,
    second: &Body<T>,
    n: &Vector3<T>,
) -> (Motion<T>, Motion<T>) {
    let approach = (first.velocity - second.velocity).dot(n);
    elastic::exchange(approach * ((T::one() + e) / T::lift(2.0)), first, second, n)
}
