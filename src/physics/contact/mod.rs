//! Impulses of ball-ball impacts. One file per law; friction between the balls is a choice of its own, see
//! [`friction`].

pub mod elastic;
pub mod inelastic;

use super::{Body, Contact, Friction, Motion, friction};
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

/// Motion of both balls after an impact: the door of all laws of this room.
///
/// `n`: unit vector from ball 1 to ball 2, in the plan of the table; between unequal balls the impulse acts along this
/// projection, and the tilt sets the contact distance only. The balls must approach: `(v1 - v2) . n > 0`. Velocities are
/// three-dimensional: friction lifts one ball and presses the other down. What a cloth does about that is
/// [`Motion::on_cloth`].
pub fn impact<T: Real>(
    law: Contact<T>,
    friction: Option<Friction<T>>,
    first: &Body<T>,
    second: &Body<T>,
    n: &Vector3<T>,
) -> (Motion<T>, Motion<T>) {
    match (law, friction) {
        (Contact::Elastic {}, None) => elastic::impact(first, second, n),
        _ => richer(law, friction, first, second, n),
    }
}

/// Every law but the simplest, kept out of the code of those who need only that.
#[inline(never)]
fn richer<T: Real>(
    law: Contact<T>,
    friction: Option<Friction<T>>,
    first: &Body<T>,
    second: &Body<T>,
    n: &Vector3<T>,
) -> (Motion<T>, Motion<T>) {
    let smooth = match law {
        Contact::Elastic {} => elastic::impact(first, second, n),
        Contact::Inelastic { e } => inelastic::impact(e, first, second, n),
    };
    match friction {
        None => smooth,
        Some(law) => friction::rub(law, first, second, n, smooth),
    }
}
