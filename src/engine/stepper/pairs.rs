//! Which pairs overlap: a look at every pair where there are few balls, at those nearby where there are many.
//!
//! The answer is the same to the bit and in the same order. Among many balls the pairs that could come to overlap are listed, with
//! some distance to spare, and the list is good until a ball has moved by half of that. How far the balls are from where they were
//! listed is asked in every step, before any distance is, so no ball is too fast. What is not a number is always far, so that its
//! list is made anew in each step.

use super::Partners;
use super::contact::{Sizes, squared};
use crate::math::grid::Grid;
use std::ops::Range;

/// Balls from which on a list is worth its trouble: below, looking at every pair is as quick.
const ENOUGH_BALLS: usize = 32;

/// How much farther apart than at contact listed pairs may be, in largest contact distances. Less is used up sooner, more lists
/// more pairs.
const SPARE: f64 = 0.5;

/// The part of half the spare distance that balls may use up; the rest covers the rounding of distances.
const USABLE: f64 = 1.0 - 1e-6;

/// Squares for each ball, at most.
const SQUARES: usize = 2;

/// Balls looked at for each ball that are not too many for the squares to be laid out anew.
const FEW: usize = 24;

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
    Near(Box<List>),
}

impl Pairs {
    /// The search for `n` balls.
    pub fn new(partners: Partners, sizes: &Sizes, n: usize) -> Self {
        let near = match partners {
            Partners::Auto => n >= ENOUGH_BALLS,
            Partners::All => false,
            Partners::Near => true,
        };
        match List::new(sizes, n) {
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
            Pairs::Near(list) => list.overlapping(sizes, x, y, pairs),
        }
    }

    /// Forgets what is known of the balls: some left play.
    pub fn forget(&mut self) {
        match self {
            Pairs::All(_) => {}
            Pairs::Near(list) => list.listed.clear(),
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

/// The pairs that could come to overlap.
#[derive(Clone, Debug)]
pub struct List {
    /// Listed pairs (i < j), ordered by i and then j.
    pairs: Vec<[u32; 2]>,
    /// Where every ball was when the pairs were listed.
    listed: Vec<[f64; 2]>,
    /// Where every ball is.
    now: Vec<[f64; 2]>,
    /// How much farther apart than at contact listed pairs may be, length.
    spare: f64,
    /// Square of how far a ball may be from where it was listed, length^2.
    reach: f64,
    squares: Squares,
}

impl List {
    /// An empty list for `n` balls; `None` where distances are too small or too large to be squared.
    fn new(sizes: &Sizes, n: usize) -> Option<Self> {
        let spare = SPARE * sizes.largest_distance();
        let reach = (0.5 * spare * USABLE).powi(2);
        reach.is_normal().then(|| List {
            pairs: Vec::with_capacity(4 * n),
            listed: Vec::with_capacity(n),
            now: Vec::with_capacity(n),
            spare,
            reach,
            squares: Squares::new(sizes.largest_distance() + spare),
        })
    }

    fn overlapping(
        &mut self,
        sizes: &Sizes,
        x: &[f64],
        y: &[f64],
        pairs: &mut Vec<(usize, usize)>,
    ) {
        self.now.clear();
        self.now.extend(x.iter().zip(y).map(|(&x, &y)| [x, y]));
        if self.is_worn_out() {
            self.renew(sizes);
        }
        let largest = sizes.largest_bound();
        for block in self.pairs.chunks(BLOCK) {
            let mut any = false;
            for &[i, j] in block {
                any |= apart(self.now[i as usize], self.now[j as usize]) < largest;
            }
            if any {
                self.collect(block, sizes, pairs);
            }
        }
    }

    /// True when a ball is farther from where it was listed than may be.
    fn is_worn_out(&self) -> bool {
        if self.listed.len() != self.now.len() {
            return true;
        }
        let mut far = false;
        for (now, listed) in self.now.iter().zip(&self.listed) {
            // a NaN is far
            far |= !(apart(*now, *listed) <= self.reach);
        }
        far
    }

    #[cold]
    #[inline(never)]
    fn renew(&mut self, sizes: &Sizes) {
        self.listed.clone_from(&self.now);
        self.squares.sort(&self.now);
        self.pairs.clear();
        let mut looked_at = 0;
        for (i, here) in self.now.iter().enumerate() {
            let first = self.pairs.len();
            for near in self.squares.around(i) {
                looked_at += near.len();
                for &j in near {
                    let far = sizes.distance(i, j as usize) + self.spare;
                    if j as usize > i && apart(*here, self.now[j as usize]) <= far * far {
                        self.pairs.push([i as u32, j]);
                    }
                }
            }
            self.pairs[first..].sort_unstable();
        }
        self.squares.judge(looked_at);
    }

    #[cold]
    #[inline(never)]
    fn collect(&self, block: &[[u32; 2]], sizes: &Sizes, pairs: &mut Vec<(usize, usize)>) {
        for pair in block {
            let [i, j] = pair.map(|ball| ball as usize);
            if sizes.overlap(i, j, apart(self.now[i], self.now[j])) {
                pairs.push((i, j));
            }
        }
    }
}

/// Balls sorted by the square in which they are.
#[derive(Clone, Debug)]
struct Squares {
    grid: Option<Grid>,
    least: f64,
    /// Column and row of every ball.
    place: Vec<[u32; 2]>,
    /// Where the balls of each square begin in `balls`; one more at the end.
    first: Vec<u32>,
    /// Balls by square, and by number within a square.
    balls: Vec<u32>,
    /// Balls looked at in one listing that are too many.
    too_many: usize,
}

impl Squares {
    /// Squares with sides of at least `least`, length.
    fn new(least: f64) -> Self {
        Squares {
            grid: None,
            least,
            place: Vec::new(),
            first: Vec::new(),
            balls: Vec::new(),
            too_many: 0,
        }
    }

    /// Sorts the balls into their squares.
    fn sort(&mut self, positions: &[[f64; 2]]) {
        let n = positions.len();
        let lay_out = || Grid::over(positions, self.least, SQUARES * n);
        let grid = self.grid.get_or_insert_with(lay_out);
        self.place.clear();
        self.place
            .extend(positions.iter().map(|here| grid.place(*here)));
        self.first.clear();
        self.first.resize(grid.squares() + 1, 0);
        for place in &self.place {
            self.first[grid.square(*place)] += 1;
        }
        let mut before = 0;
        for first in &mut self.first {
            before += *first;
            *first = before;
        }
        self.balls.resize(n, 0);
        // each square is filled from its end, and its end moves to its beginning
        for (ball, place) in self.place.iter().enumerate().rev() {
            let end = &mut self.first[grid.square(*place)];
            *end -= 1;
            self.balls[*end as usize] = ball as u32;
        }
    }

    /// The balls in and around the square of `ball`, itself included.
    fn around(&self, ball: usize) -> impl Iterator<Item = &[u32]> {
        let rows = self.grid.iter().flat_map(move |grid| {
            let place = self.place[ball];
            grid.around(place)
        });
        rows.map(|row| {
            let (from, to) = (self.first[row.start], self.first[row.end]);
            &self.balls[from as usize..to as usize]
        })
    }

    /// Has the squares laid out anew next time, if that may spare some of the `looked_at` balls of a listing: when balls gather
    /// in few squares, but not again and again where squares are crowded by nature.
    fn judge(&mut self, looked_at: usize) {
        let few = FEW * self.balls.len();
        if looked_at > self.too_many.max(few) {
            self.grid = None;
            self.too_many = 2 * looked_at;
        }
    }
}

fn apart([x1, y1]: [f64; 2], [x2, y2]: [f64; 2]) -> f64 {
    squared(x1 - x2, y1 - y2)
}
