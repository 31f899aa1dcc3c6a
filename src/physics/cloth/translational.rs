//! Coulomb friction on the centre of a ball that does not rotate: the law of the report.

use crate::math::Real;

/// Deceleration along the direction of motion, length/s^2: `mu g`, whatever the speed and the mass.
///
/// `mu`: coefficient of friction, >= 0. `gravity`: length/s^2, >= 0. It acts until the speed is zero and not beyond.
pub fn deceleration<T: Real>(mu: T, gravity: T) -> T {
    mu * gravity
}

/// Time until a ball of speed `v` stops, s: `v / (mu g)`; infinite without friction.
pub fn stop_time(v: f64, mu: f64, gravity: f64) -> f64 {
    v / (mu * gravity)
}

/// Distance until a ball of speed `v` stops, length: `v^2 / (2 mu g)`; infinite without friction.
pub fn stop_distance(v: f64, mu: f64, gravity: f64) -> f64 {
    v * v / (2.0 * mu * gravity)
}
