//! How a ball comes to a cushion, in components of the cushion.

use crate::math::Vec3;

/// A motion as a cushion meets it: x into the cushion, y along it to the left, z up.
#[derive(Clone, Copy, Debug)]
pub(super) struct Facing {
    pub(super) velocity: Vec3,
    /// Spin times radius.
    pub(super) surface: Vec3,
}

/// Sine and cosine of the height of the nose above the centre, seen from the centre; `height` in radii.
pub(super) fn nose(height: f64) -> (f64, f64) {
    (height - 1.0, (height * (2.0 - height)).sqrt())
}
