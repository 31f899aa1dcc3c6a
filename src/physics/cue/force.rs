//! The report's shot: a constant force that acts for a time on a ball at rest.

/// Speed given by a force that acts for a time, length/s: `v = F t / m`, the report's launch from rest.
///
/// `force` in mass * length/s^2, `contact_time` in s, `mass` > 0.
pub fn speed_from_force(force: f64, contact_time: f64, mass: f64) -> f64 {
    force * contact_time / mass
}
