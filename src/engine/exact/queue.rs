//! Which ball has the next event: a winner tree over one candidate a ball.
//!
//! Every ball holds the earliest event that it knows of; an event of a pair is held by at least one of the two. The tree
//! finds the earliest of all in O(1) and takes a changed candidate in O(log N), with memory linear in N.

use crate::math::Real;
use crate::physics::Side;

/// What a ball's next event is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum What {
    /// It meets another ball: (smaller, larger) index.
    Pair(u32, u32),
    /// It meets a cushion.
    Cushion(u32, Side),
    /// It enters a pocket: ball, pocket.
    Pocket(u32, u32),
    /// Its phase ends.
    End(u32),
    /// It is not clear from then on whether it meets another ball: (smaller, larger) index.
    UnclearPair(u32, u32),
    /// It is not clear from then on whether it meets a cushion.
    UnclearCushion(u32, Side),
    /// It is not clear from then on whether it enters a pocket: ball, pocket.
    UnclearPocket(u32, u32),
    /// It leaves its square of the cells: nothing of the trace.
    Leaving(u32, Side),
    /// It has none.
    Nothing,
}

impl What {
    /// The balls that take part.
    pub fn balls(self) -> Vec<usize> {
        match self {
            What::Pair(a, b) | What::UnclearPair(a, b) => vec![a as usize, b as usize],
            What::Cushion(a, _)
            | What::UnclearCushion(a, _)
            | What::Pocket(a, _)
            | What::UnclearPocket(a, _)
            | What::End(a)
            | What::Leaving(a, _) => vec![a as usize],
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
    #[inline]
    pub fn precedes(&self, other: &Self) -> bool {
        self.time < other.time || (self.time == other.time && self.what < other.what)
    }
}

/// The winner of a subtree.
#[derive(Clone, Copy, Debug)]
struct Node<T> {
    /// Time of its candidate: most comparisons need no more, and find it here instead of far away in memory.
    time: T,
    ball: u32,
}

/// The candidates of all balls, with the earliest at hand.
#[derive(Clone, Debug)]
pub struct Queue<T> {
    candidates: Vec<Candidate<T>>,
    /// Inner nodes; 1 is the root. The children of the lowest ones are pairs of balls.
    tree: Vec<Node<T>>,
    leaves: usize,
}

impl<T: Real> Queue<T> {
    /// A queue for `n` balls without events.
    pub fn new(n: usize) -> Self {
        let leaves = n.next_power_of_two().max(2);
        let nothing = Candidate::<T>::none();
        // the winner where nothing is to be won is the leftmost ball
        let leftmost = |node: usize| (node << (leaves.ilog2() - node.ilog2())) - leaves;
        let tree = (0..leaves).map(|node| Node {
            time: nothing.time,
            ball: leftmost(node.max(1)) as u32,
        });
        Queue {
            candidates: vec![nothing; n],
            tree: tree.collect(),
            leaves,
        }
    }

    /// Replaces the candidate of a ball.
    #[inline]
    pub fn set(&mut self, ball: usize, candidate: Candidate<T>) {
        self.candidates[ball] = candidate;
        let mut winner = Node {
            time: candidate.time,
            ball: ball as u32,
        };
        let neighbour = ball ^ 1;
        let time = self.candidates.get(neighbour).map(|rival| rival.time);
        let mut rival = Node {
            time: time.unwrap_or_else(|| T::lift(f64::INFINITY)),
            ball: neighbour as u32,
        };
        let mut node = self.leaves + ball;
        loop {
            // ties go to the left
            let beaten = if node.is_multiple_of(2) {
                self.beats(rival, winner)
            } else {
                !self.beats(winner, rival)
            };
            if beaten {
                winner = rival;
            }
            node /= 2;
            let holder = &mut self.tree[node];
            if holder.ball == winner.ball && winner.ball != ball as u32 {
                // it has won here before, so nothing changes above
                return;
            }
            *holder = winner;
            if node == 1 {
                return;
            }
            rival = self.tree[node ^ 1];
        }
    }

    #[inline]
    fn beats(&self, one: Node<T>, other: Node<T>) -> bool {
        if one.time < other.time {
            return true;
        }
        one.time == other.time && self.comes_first(one.ball as usize, other.ball as usize)
    }

    #[cold]
    fn comes_first(&self, one: usize, other: usize) -> bool {
        match (self.candidates.get(one), self.candidates.get(other)) {
            (Some(one), Some(other)) => one.what < other.what,
            (one, _) => one.is_some(),
        }
    }

    /// The candidate of every ball.
    pub fn all(&self) -> &[Candidate<T>] {
        &self.candidates
    }

    /// The ball with the earliest candidate, and that candidate.
    #[inline]
    pub fn first(&self) -> (usize, Candidate<T>) {
        let ball = self.tree[1].ball as usize;
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
