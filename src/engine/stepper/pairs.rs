//! Which pairs overlap: a look at every pair where there are few balls, at those nearby where there are many.
//!
//! The answer is the same to the bit and in the same order.

use super::Partners;
use super::contact::{Sizes, squared};
use crate::math::near::Near;
use std::ops::Range;

/// Balls from which on a list is worth its trouble. Calm ones gain by it from fewer on, but those so fast that it is made anew in
/// every step lose.
const ENOUGH_BALLS: usize = 20;

/// Listed pairs that are tested together.
const BLOCK: usize = 32;

/// Pairs that are tested together where all are.
const LANES: usize = 8;

/// Finds overlapping pairs.
#[derive(Clone, Debug)]
pub enum Pairs {
    /// Among all pairs.
    All(Doubled),
    /// Among listed ones.
    Near(Box<Near>),
}

impl Pairs {
    /// The search for `n` balls.
    pub fn new(partners: Partners, sizes: &Sizes, n: usize) -> Self {
        let near = match partners {
            Partners::Auto => n >= ENOUGH_BALLS,
            Partners::All => false,
            Partners::Near => true,
        };
        match Near::new(sizes.largest_distance(), n) {
            Some(list) if near => Pairs::Near(Box::new(list)),
            _ => Pairs::All(Doubled::new(n)),
        }
    }

    /// Collects every overlapping pair (i < j), ordered by i and then j.
    ///
    /// Positions do not change while a step exchanges velocities, so all pairs can be found before the first exchange
    /// without changing any result.
    pub fn overlapping(
        &mut self,
        sizes: &Sizes,
        x: &[f64],
        y: &[f64],
        pairs: &mut Vec<(usize, usize)>,
    ) {
        pairs.clear();
        match self {
            Pairs::All(doubled) => doubled.overlapping(sizes, x, y, pairs),
            Pairs::Near(near) => among_listed(near, sizes, x, y, pairs),
        }
    }

    /// Forgets what is known of the balls: some left play.
    pub fn forget(&mut self) {
        match self {
            Pairs::All(_) => {}
            Pairs::Near(near) => near.forget(),
        }
    }
}

/// Coordinates twice over, so that the partners k places on of all balls are one row without an end. What follows is not a number.
#[derive(Clone, Debug)]
pub struct Doubled {
    x: Vec<f64>,
    y: Vec<f64>,
}

impl Doubled {
    fn new(n: usize) -> Self {
        Doubled {
            x: Vec::with_capacity(2 * n + LANES),
            y: Vec::with_capacity(2 * n + LANES),
        }
    }

    fn overlapping(
        &mut self,
        sizes: &Sizes,
        x: &[f64],
        y: &[f64],
        pairs: &mut Vec<(usize, usize)>,
    ) {
        let n = x.len();
        double(&mut self.x, x);
        double(&mut self.y, y);
        let largest = sizes.largest_bound();
        for k in 1..=n / 2 {
            // halfway round, every pair has been met
            let rows = if 2 * k == n { k } else { n };
            let end = rows.next_multiple_of(LANES);
            let here = lanes(&self.x[..end]).iter().zip(lanes(&self.y[..end]));
            let there = lanes(&self.x[k..k + end])
                .iter()
                .zip(lanes(&self.y[k..k + end]));
            for (block, ((x1, y1), (x2, y2))) in here.zip(there).enumerate() {
                let mut any = false;
                // no branch inside: the compiler turns the block into wide lanes
                for lane in 0..LANES {
                    any |= squared(x1[lane] - x2[lane], y1[lane] - y2[lane]) < largest;
                }
                if any {
                    let first = block * LANES;
                    self.collect(first..rows.min(first + LANES), k, n, sizes, pairs);
                }
            }
        }
        if pairs.len() > 1 {
            pairs.sort_unstable();
        }
    }

    /// Adds the overlapping pairs of these balls and those `k` places on, of `n`.
    #[cold]
    #[inline(never)]
    fn collect(
        &self,
        balls: Range<usize>,
        k: usize,
        n: usize,
        sizes: &Sizes,
        pairs: &mut Vec<(usize, usize)>,
    ) {
        let largest = sizes.largest_bound();
        for i in balls {
            let j = i + k;
            let d2 = squared(self.x[i] - self.x[j], self.y[i] - self.y[j]);
            if d2 < largest {
                let j = if j < n { j } else { j - n };
                if sizes.overlap(i, j, d2) {
                    pairs.push((i.min(j), i.max(j)));
                }
            }
        }
    }
}

fn lanes(column: &[f64]) -> &[[f64; LANES]] {
    column.as_chunks().0
}

fn double(twice: &mut Vec<f64>, once: &[f64]) {
    let n = once.len();
    twice.resize(2 * n + LANES, f64::NAN);
    let (first, rest) = twice.split_at_mut(n);
    let (second, beyond) = rest.split_at_mut(n);
    for ((first, second), value) in first.iter_mut().zip(second).zip(once) {
        (*first, *second) = (*value, *value);
    }
    beyond.fill(f64::NAN);
}

/// Adds the overlapping pairs among those listed.
fn among_listed(
    near: &mut Near,
    sizes: &Sizes,
    x: &[f64],
    y: &[f64],
    pairs: &mut Vec<(usize, usize)>,
) {
    let positions = x.iter().zip(y).map(|(&x, &y)| [x, y]);
    near.place(positions, |i, j| sizes.distance(i, j));
    let now = near.now();
    let largest = sizes.largest_bound();
    for block in near.pairs().chunks(BLOCK) {
        let mut any = false;
        for &[i, j] in block {
            any |= apart(now[i as usize], now[j as usize]) < largest;
        }
        if any {
            collect_listed(block, now, sizes, pairs);
        }
    }
}

#[cold]
#[inline(never)]
fn collect_listed(
    block: &[[u32; 2]],
    now: &[[f64; 2]],
    sizes: &Sizes,
    pairs: &mut Vec<(usize, usize)>,
) {
    for pair in block {
        let [i, j] = pair.map(|ball| ball as usize);
        if sizes.overlap(i, j, apart(now[i], now[j])) {
            pairs.push((i, j));
        }
    }
}

fn apart([x1, y1]: [f64; 2], [x2, y2]: [f64; 2]) -> f64 {
    squared(x1 - x2, y1 - y2)
}
