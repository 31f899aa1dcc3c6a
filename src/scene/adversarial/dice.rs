//! Draws for scenes that look for trouble: choices, sizes over many decades, gaps and angles with a taste for the special ones.

use crate::math::angle::unit_vector;
use crate::math::random::Draws;

/// One scene's draws.
#[derive(Debug)]
pub(super) struct Dice(Draws);

impl Dice {
    pub(super) fn new(seed: u64, index: u64) -> Self {
        Dice(Draws::new(seed, index))
    }

    /// A whole number from 0 to `n - 1`.
    pub(super) fn below(&mut self, n: usize) -> usize {
        (self.0.uniform() * n as f64) as usize
    }

    /// A whole number from `low` to `high`.
    pub(super) fn count(&mut self, low: usize, high: usize) -> usize {
        low + self.below(high - low + 1)
    }

    /// True in `part` of all cases.
    pub(super) fn chance(&mut self, part: f64) -> bool {
        self.0.uniform() < part
    }

    pub(super) fn pick<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())]
    }

    pub(super) fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0.between(low, high)
    }

    /// A positive number, uniform in its logarithm to base 10.
    pub(super) fn decades(&mut self, low: f64, high: f64) -> f64 {
        10_f64.powf(self.between(low, high))
    }

    /// A power of ten, from 1e-1 down to 1e-16.
    pub(super) fn tiny(&mut self) -> f64 {
        10_f64.powi(-(self.count(1, 16) as i32))
    }

    /// A gap between surfaces, in radii: often none, sometimes less than none within what still counts as touching.
    pub(super) fn gap(&mut self) -> f64 {
        match self.below(10) {
            0..=4 => 0.0,
            5..=7 => self.tiny(),
            8 => self.between(0.0, 0.1),
            _ => -self.decades(-16.0, -13.0),
        }
    }

    /// A direction in the plane, of length 1: often along an axis or a diagonal.
    pub(super) fn direction(&mut self) -> [f64; 2] {
        let degrees = match self.below(6) {
            0..=2 => 90.0 * self.below(4) as f64,
            3 => 45.0 * self.below(8) as f64,
            4 => 30.0 * self.below(12) as f64,
            _ => self.between(0.0, 360.0),
        };
        let (cos, sin) = unit_vector(degrees);
        [cos, sin]
    }
}
