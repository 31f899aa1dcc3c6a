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

/// Width of a pool table's corner mouth between its tips, radii: 4.5625 in for a ball of 1.125 in.
const CORNER_MOUTH: f64 = 4.5625 / 1.125;

/// Width of its side mouth, radii: 5.0625 in.
const SIDE_MOUTH: f64 = 5.0625 / 1.125;

/// The six pockets of a pool table between the corners `min` and `max`, for balls of this radius, as circles `[x, y, r]`.
///
/// Corners: their tips are c = mouth / sqrt(2) from the corner. The circle about the corner passes through the two points at which a
/// centre that follows a cushion crosses the line of the tips: r^2 = R^2 + (c - R)^2. Sides, in the middle of the long edges: the circle
/// about the middle of the mouth holds, of the line on which centres meet the cushion, all from which a ball clears both tips:
/// r^2 = R^2 + (mouth / 2 - R)^2.
pub fn six_pockets(min: [f64; 2], max: [f64; 2], radius: f64) -> [[f64; 3]; 6] {
    let corner = radius * (CORNER_MOUTH * std::f64::consts::FRAC_1_SQRT_2 - 1.0).hypot(1.0);
    let side = radius * (SIDE_MOUTH / 2.0 - 1.0).hypot(1.0);
    let middle = |axis: usize| min[axis] + (max[axis] - min[axis]) / 2.0;
    let sides = match max[1] - min[1] >= max[0] - min[0] {
        true => [[min[0], middle(1)], [max[0], middle(1)]],
        false => [[middle(0), min[1]], [middle(0), max[1]]],
    };
    [
        [min[0], min[1], corner],
        [max[0], min[1], corner],
        [sides[0][0], sides[0][1], side],
        [sides[1][0], sides[1][1], side],
        [min[0], max[1], corner],
        [max[0], max[1], corner],
    ]
}

/// Index of the first pocket that holds a centre at `position`, its rim included; `None` in the open.
pub fn holding<T: Real>(pockets: &Pockets<T>, position: &Vector3<T>) -> Option<usize> {
    let inside = |circle: &[T; 3]| depth(circle, position) >= T::zero();
    pockets.circles.iter().position(inside)
}
