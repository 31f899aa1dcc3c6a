//! Impulses of ball-ball impacts. One file per law.

pub mod elastic;

use super::{Body, Contact, Motion};
use crate::math::Real;
use nalgebra::Vector3;

/// Distance in the plan view at which two balls on a table touch, length: `2 sqrt(R1 R2)`.
///
/// Both centres are at the height of their own radius, so unequal balls touch with a tilted normal. Equal radii give
/// exactly `R1 + R2`.
pub fn plan_distance<T: Real>(r1: T, r2: T) -> T {
    if r1 == r2 {
        r1 + r2
    } else {
        (r1 * r2).sqrt() * T::lift(2.0)
    }
}

/// Motion of both balls after an impact.
///
/// `n`: unit vector from ball 1 to ball 2, in the plan of the table. The balls must approach: `(v1 - v2) . n > 0`.
pub fn impact<T: Real>(
    law: Contact,
    first: &Body<T>,
    second: &Body<T>,
    n: &Vector3<T>,
) -> (Motion<T>, Motion<T>) {
    match law {
        Contact::Elastic {} => elastic::impact(first, second, n),
    }
}
