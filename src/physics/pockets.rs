//! Pockets: where a ball leaves play. Geometry only.
//!
//! A pocket is a vertical cylinder. A ball leaves play at the moment its centre enters one; what the rim and the jaws of a
//! real pocket do to a ball is not simulated.

use super::Pockets;
use crate::math::Real;
use nalgebra::Vector3;

/// How far inside a circle `[x, y, r]` the point is, as `r^2 - distance^2` in plan, length^2: positive inside.
///
/// The square keeps it a polynomial of the position, so that the time of entry is the root of a quartic like a contact's.
pub fn depth<T: Real>([x, y, r]: &[T; 3], position: &Vector3<T>) -> T {
    let (dx, dy) = (position.x - *x, position.y - *y);
    *r * *r - (dx * dx + dy * dy)
}

/// Index of the first pocket that holds a centre at `position`, its rim included; `None` in the open.
pub fn holding<T: Real>(pockets: &Pockets<T>, position: &Vector3<T>) -> Option<usize> {
    let inside = |circle: &[T; 3]| depth(circle, position) >= T::zero();
    pockets.circles.iter().position(inside)
}
