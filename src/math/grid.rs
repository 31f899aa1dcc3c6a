//! Points in the plane sorted into squares, so that what is near is found without looking at everything.
//!
//! The squares cover where most of the points are; the outermost reach to infinity, so that every point of the plane has one
//! and a few far away points do not make the squares coarse. A ring of empty squares around them spares the question whether
//! a square has a neighbour.

/// Part of the points, on either side of each axis, that the extent of the squares ignores.
const OUTLIERS: usize = 64;

/// Squares over the plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    low: [f64; 2],
    size: f64,
    count: [u32; 2],
}

impl Grid {
    /// A grid over `points` with about `most` squares or fewer, whose sides are at least `least`, > 0.
    pub fn over(points: &[[f64; 2]], least: f64, most: usize) -> Self {
        let extent = [0, 1].map(|axis| {
            let mut along: Vec<f64> = points.iter().map(|point| point[axis]).collect();
            extent(&mut along)
        });
        let [width, length] = extent.map(|(low, high)| high - low);
        let most = (most.max(1) as f64).min(f64::from(u32::MAX / 4));
        let size = least
            .max((width * length / most).sqrt())
            .max(width.max(length) / most);
        let count = [width, length].map(|span| ((span / size) as u32).max(1));
        Grid {
            low: extent.map(|(low, _)| low),
            size,
            count,
        }
    }

    /// Side of a square, length.
    pub fn size(&self) -> f64 {
        self.size
    }

    /// Number of squares, those of the ring included: the squares are numbered below it.
    pub fn squares(&self) -> usize {
        (self.count[0] as usize + 2) * (self.count[1] as usize + 2)
    }

    /// Column and row of a point, from 1 to the number of columns and rows.
    pub fn place(&self, point: [f64; 2]) -> [u32; 2] {
        [0, 1].map(|axis| {
            let steps = (point[axis] - self.low[axis]) / self.size;
            // what is below saturates at 0, and so does a NaN
            (steps as u32).min(self.count[axis] - 1) + 1
        })
    }

    /// Number of the square in a column and row.
    pub fn square(&self, [column, row]: [u32; 2]) -> usize {
        row as usize * (self.count[0] as usize + 2) + column as usize
    }

    /// The squares that may hold points within `size` of the square in a column and row: three ranges of numbers.
    pub fn around(&self, place: [u32; 2]) -> [std::ops::Range<usize>; 3] {
        let stride = self.count[0] as usize + 2;
        let middle = self.square(place);
        [middle - stride, middle, middle + stride].map(|square| square - 1..square + 2)
    }

    /// The limits of the squares of a column (`axis` 0) or row (1); infinite, `None`, for the outermost.
    pub fn edges(&self, axis: usize, index: u32) -> [Option<f64>; 2] {
        let edge = |steps: u32| self.low[axis] + f64::from(steps) * self.size;
        [
            (index > 1).then(|| edge(index - 1)),
            (index < self.count[axis]).then(|| edge(index)),
        ]
    }
}

/// Where all but the outliers are; all of them if the outliers are not far off.
fn extent(along: &mut [f64]) -> (f64, f64) {
    let last = match along.len() {
        0 => return (0.0, 0.0),
        n => n - 1,
    };
    let (low, high) = along
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
            (low.min(*x), high.max(*x))
        });
    let few = last / OUTLIERS;
    let mut rank = |k: usize| *along.select_nth_unstable_by(k, f64::total_cmp).1;
    let (inner_low, inner_high) = (rank(few), rank(last - few));
    let beyond = 8.0 * (inner_high - inner_low) / OUTLIERS as f64;
    (low.max(inner_low - beyond), high.min(inner_high + beyond))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::random::Draws;

    fn scattered(n: usize, width: f64, length: f64) -> Vec<[f64; 2]> {
        let point = |i: usize| {
            let mut draws = Draws::new(3, i as u64);
            [draws.between(0.0, width), draws.between(-length, 0.0)]
        };
        (0..n).map(point).collect()
    }

    #[test]
    fn points_closer_than_a_side_are_in_neighbouring_squares() {
        for (n, width, length, least) in [
            (300, 1.0, 1.0, 0.05),
            (300, 1e3, 1e-3, 1.0),
            (300, 5.0, 1e-9, 1e-6),
            (2, 1.0, 1.0, 0.7),
            (1, 0.0, 0.0, 1.0),
        ] {
            let mut points = scattered(n, width, length);
            // far away, and not a number
            points.push([1e12 * width, -1e12 * length]);
            let grid = Grid::over(&points, least, n);
            assert!(grid.size() >= least);
            points.extend(
                points
                    .clone()
                    .iter()
                    .map(|p| [p[0] + 0.7 * least, p[1] - 0.7 * least]),
            );
            let mut pairs = 0;
            for a in &points {
                for b in &points {
                    if (a[0] - b[0]).hypot(a[1] - b[1]) < grid.size() {
                        let square = grid.square(grid.place(*b));
                        let around = grid.around(grid.place(*a));
                        assert!(
                            around.iter().any(|row| row.contains(&square)),
                            "{a:?} {b:?}"
                        );
                        assert!(around[2].end <= grid.squares());
                        pairs += 1;
                    }
                }
            }
            assert!(pairs >= 2 * n);
        }
    }

    #[test]
    fn squares_are_about_as_many_as_asked_for_however_the_points_lie() {
        for (width, length) in [(1.0, 1.0), (1e6, 1.0), (1.0, 1e-6), (1.0, 0.0), (0.0, 0.0)] {
            let mut points = scattered(1000, width, length);
            points.extend([[1e30, 1e30], [-1e30, 0.0]]);
            let grid = Grid::over(&points, 1e-300, 1000);
            // 1000, one more column and row where a side is a fraction, and the ring
            assert!(grid.squares() <= 3 * 1001 + 6, "{grid:?}");
            // outliers do not make it coarse
            assert!(
                grid.size()
                    <= 1.5
                        * (width * length / 1000.0)
                            .sqrt()
                            .max(width.max(length) / 1000.0)
                        + 1e-299
            );
        }
    }

    #[test]
    fn a_point_lies_within_the_edges_of_its_square() {
        let points = scattered(500, 3.0, 2.0);
        let grid = Grid::over(&points, 0.1, 500);
        let mut bounded = 0;
        for point in points.iter().chain(&[[-50.0, 7.0], [50.0, -70.0]]) {
            let place = grid.place(*point);
            for axis in 0..2 {
                let [low, high] = grid.edges(axis, place[axis]);
                // edges and places are rounded apart
                let rounding = 4.0 * f64::EPSILON * 5.0;
                assert!(
                    low.is_none_or(|low| low <= point[axis] + rounding),
                    "{point:?}"
                );
                assert!(
                    high.is_none_or(|high| high >= point[axis] - rounding),
                    "{point:?}"
                );
                bounded += usize::from(low.is_some() && high.is_some());
            }
        }
        assert!(bounded > 500);
        assert_eq!(grid.place([f64::NAN, f64::NAN]), [1, 1]);
    }
}
