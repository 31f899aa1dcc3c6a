//! Who meets whom, and how fast their gap changes.

use super::spin::Moving;
use crate::math::Real;
use crate::physics::Side;
use crate::trace::Partner;

/// Who meets whom.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Encounter {
    /// Two balls.
    Pair(usize, usize),
    /// A ball and a cushion.
    Cushion(usize, Side),
}

impl Encounter {
    /// The balls that take part: one or two.
    pub fn balls(self) -> impl Iterator<Item = usize> {
        let (a, b) = match self {
            Encounter::Pair(a, b) => (a, Some(b)),
            Encounter::Cushion(a, _) => (a, None),
        };
        std::iter::once(a).chain(b)
    }

    /// Whether a ball takes part.
    pub fn involves(self, ball: usize) -> bool {
        self.balls().any(|party| party == ball)
    }

    /// As a trace has it: the first ball, and its partner.
    pub fn parties(self) -> (usize, Partner) {
        match self {
            Encounter::Pair(a, b) => (a.min(b), Partner::Ball(a.max(b) as u32)),
            Encounter::Cushion(a, side) => (a, Partner::Cushion(side)),
        }
    }
}

/// Rate of the gap of two balls, length/s.
pub fn rate_between<T: Real>(one: &Moving<T>, other: &Moving<T>) -> T {
    let p = [0, 1].map(|i| other.position[i] - one.position[i]);
    let v = [0, 1].map(|i| other.velocity[i] - one.velocity[i]);
    (p[0] * v[0] + p[1] * v[1]) / (p[0] * p[0] + p[1] * p[1]).sqrt()
}

/// Rate of the gap of a ball to a cushion, length/s.
pub fn rate_to<T: Real>(moving: &Moving<T>, side: Side) -> T {
    let v = moving.velocity[side.axis()];
    if side.sign() < 0 { v } else { -v }
}
