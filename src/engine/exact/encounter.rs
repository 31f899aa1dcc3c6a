//! Who meets whom.

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
