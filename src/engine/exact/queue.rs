//! Which ball has the next event: a winner tree over one candidate a ball.
//!
//! Every ball holds the earliest event that it knows of; an event of a pair is held by at least one of the two. The tree
//! finds the earliest of all in O(1) and takes a changed candidate in O(log N), with memory linear in N.

use crate::math::Real;
use crate::physics::Side;
use std::cmp::Ordering;

/// What a ball's next event is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum What {
    /// It meets another ball: (smaller, larger) index.
    Pair(u32, u32),
    /// It meets a cushion.
    Cushion(u32, Side),
    /// Its phase ends.
    End(u32),
    /// It is not clear from then on whether it meets another ball: (smaller, larger) index.
    UnclearPair(u32, u32),
    /// It is not clear from then on whether it meets a cushion.
    UnclearCushion(u32, Side),
    /// It has none.
    Nothing,
}

impl What {
    /// The balls that take part.
    pub fn balls(self) -> Vec<usize> {
        match self {
            What::Pair(a, b) | What::UnclearPair(a, b) => vec![a as usize, b as usize],
            What::Cushion(a, _) | What::UnclearCushion(a, _) | What::End(a) => vec![a as usize],
            What::Nothing => Vec::new(),
        }
    }
}

/// The next event of one ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate<T> {
    /// When, s; infinite for none.
    pub time: T,
    /// What.
    pub what: What,
    /// The partner's count of changes when this was computed: another one now makes the candidate stale.
    pub stamp: u32,
}

impl<T: Real> Candidate<T> {
    /// No event.
    pub fn none() -> Self {
        Candidate {
            time: T::lift(f64::INFINITY),
            what: What::Nothing,
            stamp: 0,
        }
    }

    /// Earlier, or at the same time earlier in scene order.
    fn precedes(&self, other: &Self) -> bool {
        match self.time.partial_cmp(&other.time) {
            Some(Ordering::Less) => true,
            Some(Ordering::Equal) => self.what < other.what,
            _ => false,
        }
    }
}

/// The candidates of all balls, with the earliest at hand.
#[derive(Clone, Debug)]
pub struct Queue<T> {
    candidates: Vec<Candidate<T>>,
    /// Node 1 is the root; node `leaves + i` is ball i. Each holds the winning ball of its subtree.
    tree: Vec<u32>,
    leaves: usize,
}

impl<T: Real> Queue<T> {
    /// A queue for `n` balls without events.
    pub fn new(n: usize) -> Self {
        let leaves = n.next_power_of_two().max(1);
        let last = n.saturating_sub(1);
        let mut tree: Vec<u32> = (0..2 * leaves)
            .map(|node| node.saturating_sub(leaves).min(last) as u32)
            .collect();
        for node in (1..leaves).rev() {
            tree[node] = tree[2 * node];
        }
        Queue {
            candidates: vec![Candidate::none(); n],
            tree,
            leaves,
        }
    }

    /// Replaces the candidate of a ball.
    pub fn set(&mut self, ball: usize, candidate: Candidate<T>) {
        self.candidates[ball] = candidate;
        let mut node = (self.leaves + ball) / 2;
        while node > 0 {
            let (left, right) = (self.tree[2 * node], self.tree[2 * node + 1]);
            let right_wins =
                self.candidates[right as usize].precedes(&self.candidates[left as usize]);
            self.tree[node] = if right_wins { right } else { left };
            node /= 2;
        }
    }

    /// The ball with the earliest candidate, and that candidate.
    pub fn first(&self) -> (usize, Candidate<T>) {
        // a tree of one leaf has no inner node
        let ball = if self.leaves == 1 {
            0
        } else {
            self.tree[1] as usize
        };
        (ball, self.candidates[ball])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_earliest_candidate_wins_for_any_number_of_balls() {
        for n in 1..40_usize {
            let mut queue = Queue::<f64>::new(n);
            let mut times = vec![f64::INFINITY; n];
            let mut seed = n as u64;
            for _ in 0..200 {
                seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                let ball = (seed >> 33) as usize % n;
                times[ball] = ((seed >> 20) & 0xff) as f64;
                queue.set(
                    ball,
                    Candidate {
                        time: times[ball],
                        what: What::End(ball as u32),
                        stamp: 0,
                    },
                );
                let earliest = times.iter().copied().fold(f64::INFINITY, f64::min);
                let expected = times.iter().position(|t| *t == earliest);
                let (ball, candidate) = queue.first();
                assert_eq!(candidate.time, earliest, "{n} balls");
                assert_eq!(Some(ball), expected, "{n} balls: ties go to scene order");
            }
        }
    }
}
