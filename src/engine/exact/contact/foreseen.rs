//! Where accumulations under way lead.

use crate::engine::exact::encounter::Encounter;
use crate::engine::exact::spin::Moving;
use crate::math::Real;

/// Below this part of the largest speed an impact may be one of an accumulation.
pub const SLOW: f64 = 1e-3;

/// Where an accumulation leads, as found at the first of its impacts that was slow enough to ask.
#[derive(Clone, Debug)]
pub struct Foreseen<T> {
    /// Whose impacts they are.
    pub encounter: Encounter,
    /// When, s.
    pub time: T,
    /// How its parties move then.
    pub states: Vec<Moving<T>>,
}

impl<T: Real> Foreseen<T> {
    /// Whether the velocities at both limits are the same within `speed`, length/s.
    pub fn agrees(&self, other: &Self, speed: T) -> bool {
        let pairs = self.states.iter().zip(&other.states);
        pairs
            .clone()
            .all(|(a, b)| (0..2).all(|i| (a.velocity[i] - b.velocity[i]).abs() <= speed))
    }
}
