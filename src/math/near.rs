//! Pairs of moving points that are, or may soon be, close to each other: a list with some distance to spare.
//!
//! The list is good until a point has moved by half of what there is to spare. How far the points are from where they were listed
//! is asked of the points themselves whenever they are placed, so no point is too fast. What is not a number is always far, so that
//! its list is made anew each time.

use super::grid::Grid;

/// How much farther apart than asked for listed pairs may be, in the largest distance asked for. Less is used up sooner, more
/// lists more pairs.
const SPARE: f64 = 0.5;

/// The part of half the spare distance that points may use up; the rest covers the rounding of distances and squares.
const USABLE: f64 = 1.0 - 1e-6;

/// Squares for each point, at most.
const SQUARES: usize = 2;

/// Points looked at for each point that are not too many for the squares to stay as they are.
const FEW: usize = 24;

/// The list.
#[derive(Clone, Debug)]
pub struct Near {
    /// Listed pairs (i < j), ordered by i and then j.
    pairs: Vec<[u32; 2]>,
    /// Where every point was when the pairs were listed.
    listed: Vec<[f64; 2]>,
    /// Where every point is.
    now: Vec<[f64; 2]>,
    /// How much farther apart than asked for listed pairs may be, length.
    spare: f64,
    /// Square of how far a point may be from where it was listed, length^2.
    reach: f64,
    squares: Squares,
}

impl Near {
    /// An empty list for `n` points. `largest`: the largest distance at which a pair is close, length. `None` where distances are
    /// too small or too large to be squared.
    pub fn new(largest: f64, n: usize) -> Option<Self> {
        let spare = SPARE * largest;
        let reach = (0.5 * spare * USABLE).powi(2);
        reach.is_normal().then(|| Near {
            pairs: Vec::with_capacity(4 * n),
            listed: Vec::with_capacity(n),
            now: Vec::with_capacity(n),
            spare,
            reach,
            squares: Squares::new(largest + spare),
        })
    }

    /// Moves the points to where they are. `close`: distance at which the pair (i < j) is close, at most the largest; the same for
    /// a pair every time.
    pub fn place(
        &mut self,
        points: impl Iterator<Item = [f64; 2]>,
        close: impl Fn(usize, usize) -> f64,
    ) {
        self.now.clear();
        self.now.extend(points);
        if self.is_worn_out() {
            self.renew(close);
        }
    }

    /// Pairs (i < j), ordered by i and then j, among which all close ones are.
    pub fn pairs(&self) -> &[[u32; 2]] {
        &self.pairs
    }

    /// The points.
    pub fn now(&self) -> &[[f64; 2]] {
        &self.now
    }

    /// Has the list made anew next time: the points are no longer the same.
    pub fn forget(&mut self) {
        self.listed.clear();
    }

    /// True when a point is farther from where it was listed than may be.
    fn is_worn_out(&self) -> bool {
        if self.listed.len() != self.now.len() {
            return true;
        }
        let mut within = true;
        for (now, listed) in self.now.iter().zip(&self.listed) {
            // a NaN is not within
            within &= apart(*now, *listed) <= self.reach;
        }
        !within
    }

    #[cold]
    #[inline(never)]
    fn renew(&mut self, close: impl Fn(usize, usize) -> f64) {
        self.listed.clone_from(&self.now);
        self.squares.sort(&self.now);
        self.pairs.clear();
        let mut looked_at = 0;
        for (i, here) in self.now.iter().enumerate() {
            let first = self.pairs.len();
            for near in self.squares.around(i) {
                looked_at += near.len();
                for &j in near {
                    let other = j as usize;
                    if other <= i {
                        continue;
                    }
                    let far = close(i, other) + self.spare;
                    if apart(*here, self.now[other]) <= far * far {
                        self.pairs.push([i as u32, j]);
                    }
                }
            }
            self.pairs[first..].sort_unstable();
        }
        self.squares.judge(looked_at);
    }
}

/// Points sorted by the square in which they are.
#[derive(Clone, Debug)]
struct Squares {
    grid: Option<Grid>,
    least: f64,
    /// Column and row of every point.
    place: Vec<[u32; 2]>,
    /// Where the points of each square begin in `points`; one more at the end.
    first: Vec<u32>,
    /// Points by square, and by number within a square.
    points: Vec<u32>,
    /// Points looked at in one listing that are too many.
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
            points: Vec::new(),
            too_many: 0,
        }
    }

    /// Sorts the points into their squares.
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
        self.points.resize(n, 0);
        // each square is filled from its end, and its end moves to its beginning
        for (point, place) in self.place.iter().enumerate().rev() {
            let end = &mut self.first[grid.square(*place)];
            *end -= 1;
            self.points[*end as usize] = point as u32;
        }
    }

    /// The points in and around the square of `point`, itself included.
    fn around(&self, point: usize) -> impl Iterator<Item = &[u32]> {
        let rows = self.grid.iter().flat_map(move |grid| {
            let place = self.place[point];
            grid.around(place)
        });
        rows.map(|row| {
            let (from, to) = (self.first[row.start], self.first[row.end]);
            &self.points[from as usize..to as usize]
        })
    }

    /// Has the squares laid out anew next time, if that may spare some of the `looked_at` points of a listing: when points gather
    /// in few squares, but not again and again where squares are crowded by nature.
    fn judge(&mut self, looked_at: usize) {
        let few = FEW * self.points.len();
        if looked_at > self.too_many.max(few) {
            self.grid = None;
            self.too_many = 2 * looked_at;
        }
    }
}

fn apart([x1, y1]: [f64; 2], [x2, y2]: [f64; 2]) -> f64 {
    (x1 - x2) * (x1 - x2) + (y1 - y2) * (y1 - y2)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::random::Draws;

    #[test]
    fn every_close_pair_is_listed_in_order_wherever_the_points_go() {
        let (n, rounds) = (120, 60);
        // from hardly moving to leaving every square in one round; points that gather in a corner, and one that is nowhere
        for stride in [1e-3, 0.05, 0.4, 30.0] {
            let size = |i: usize| [0.1, 0.25, 0.3][i % 3];
            let close = |i: usize, j: usize| size(i) + size(j);
            let mut near = Near::new(0.6, n).unwrap_or_else(|| panic!("a distance like any"));
            let mut points: Vec<[f64; 2]> = (0..n)
                .map(|i| {
                    let mut draws = Draws::new(1, i as u64);
                    [draws.between(0.0, 5.0), draws.between(-5.0, 0.0)]
                })
                .collect();
            points[7] = [f64::NAN, 1.0];
            points[8] = [f64::INFINITY, 1.0];
            points[9] = [1e200, -1e200];
            let mut found = 0;
            for round in 0..rounds {
                near.place(points.iter().copied(), close);
                let listed = near.pairs();
                assert!(listed.is_sorted(), "stride {stride}");
                for i in 0..n {
                    for j in i + 1..n {
                        if apart(points[i], points[j]) < close(i, j).powi(2) {
                            let pair = [i as u32, j as u32];
                            assert!(listed.contains(&pair), "stride {stride}: {pair:?}");
                            found += 1;
                        }
                    }
                }
                for (i, point) in points.iter_mut().enumerate() {
                    let mut draws = Draws::new(2 + round, i as u64);
                    let (x, y) = draws.in_disc(stride);
                    let gathered = if round > rounds / 2 { 0.9 } else { 1.0 };
                    *point = [gathered * point[0] + x, gathered * point[1] + y];
                }
            }
            assert!(found > 10, "stride {stride}: {found} pairs");
        }
    }

    #[test]
    fn distances_that_cannot_be_squared_are_not_listed() {
        for largest in [0.0, 1e-200, 1e200, f64::NAN, f64::INFINITY] {
            assert!(Near::new(largest, 10).is_none(), "{largest}");
        }
    }
}
