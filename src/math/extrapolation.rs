//! One step of an ordinary differential equation by the extrapolated midpoint rule (Gragg, Bulirsch, Stoer).
//!
//! The modified midpoint rule with n substeps has an error in even powers of 1/n, so the results of n = 2, 4, 6, ... are
//! extrapolated to n = infinity. It needs no table of coefficients, works in any scalar, and the difference of the last two
//! entries says how well it did. Source: Hairer, Norsett, Wanner, "Solving Ordinary Differential Equations I", II.9.

use super::Real;

/// Rows of the extrapolation that are tried before a step counts as too long; the last has order 16.
const ROWS: usize = 8;

/// A step that met its tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step<S> {
    /// The solution at the end of the step.
    pub end: S,
    /// Largest difference of a component from that of the extrapolation of one order less.
    pub error: f64,
    /// Rows that were needed, 2 to the most that were allowed: few for a step that could have been longer.
    pub rows: usize,
}

/// The solution of `dy/dx = rate(y)` from `start` over `length`; `None` if its error stays above `tolerance`, absolute.
///
/// `S`: the components, an array or a `Vec`. Eight rows at most, of order 16.
pub fn step<T: Real, S: Clone + AsRef<[T]> + AsMut<[T]>>(
    rate: impl Fn(&S) -> S,
    start: &S,
    length: T,
    tolerance: f64,
) -> Option<Step<S>> {
    step_within(ROWS, rate, start, length, tolerance)
}

/// The same with at most so many `rows`, of order `2 rows`: more digits are cheaper with more of them.
pub fn step_within<T: Real, S: Clone + AsRef<[T]> + AsMut<[T]>>(
    rows: usize,
    rate: impl Fn(&S) -> S,
    start: &S,
    length: T,
    tolerance: f64,
) -> Option<Step<S>> {
    let first = rate(start);
    let weight = |row: usize, column: usize| {
        let (fine, coarse) = ((row + 1).pow(2) as f64, (row - column).pow(2) as f64);
        T::lift(coarse) / T::lift(fine - coarse)
    };
    let plain = |row: usize| Some(midpoint(&rate, start, &first, length, 2 * (row + 1)));
    extrapolate(rows, tolerance, plain, weight)
}

/// Rows of an extrapolation until its last entries differ by no more than `tolerance`; `None` if none of so many `rows` does.
///
/// `plain`: the first entry of a row; `weight` of a row and a column: the part of the difference of two entries that leads to the next.
pub(super) fn extrapolate<T: Real, S: Clone + AsRef<[T]> + AsMut<[T]>>(
    rows: usize,
    tolerance: f64,
    plain: impl Fn(usize) -> Option<S>,
    weight: impl Fn(usize, usize) -> T,
) -> Option<Step<S>> {
    let mut table: Vec<S> = Vec::with_capacity(rows);
    for row in 0..rows {
        let (end, error) = extrapolated(&mut table, plain(row)?, |column| weight(row, column));
        if error <= tolerance {
            return Some(Step {
                end,
                error,
                rows: row + 1,
            });
        }
    }
    None
}

/// The next row: `table` holds the row above, and then this one. Answers the last entry and how far it is from the one before.
fn extrapolated<T: Real, S: Clone + AsRef<[T]> + AsMut<[T]>>(
    table: &mut Vec<S>,
    plain: S,
    weight: impl Fn(usize) -> T,
) -> (S, f64) {
    let (mut entry, mut error) = (plain, f64::INFINITY);
    // each entry from its left and upper left neighbours
    for (column, above) in table.iter_mut().enumerate() {
        let weight = weight(column);
        error = 0.0;
        // the better entry takes the place of the plain one, which moves up
        for (entry, above) in entry.as_mut().iter_mut().zip(above.as_mut()) {
            let better = *entry + (*entry - *above) * weight;
            error = super::worse(error, (better - *entry).abs().to_f64());
            *above = *entry;
            *entry = better;
        }
    }
    table.push(entry.clone());
    (entry, error)
}

/// The modified midpoint rule with an even number of substeps.
fn midpoint<T: Real, S: Clone + AsRef<[T]> + AsMut<[T]>>(
    rate: &impl Fn(&S) -> S,
    start: &S,
    first: &S,
    length: T,
    substeps: usize,
) -> S {
    let h = length / T::lift(substeps as f64);
    let twice = h + h;
    let mut before = start.clone();
    let mut now = start.clone();
    for (now, slope) in now.as_mut().iter_mut().zip(first.as_ref()) {
        *now += *slope * h;
    }
    for _ in 1..substeps {
        let slope = rate(&now);
        for (before, slope) in before.as_mut().iter_mut().zip(slope.as_ref()) {
            *before += *slope * twice;
        }
        std::mem::swap(&mut before, &mut now);
    }
    now
}

#[cfg(test)]
mod tests {
    use super::step;
    use crate::math::{DoubleDouble, Dual, Real};

    /// A pendulum of energy and a clock: y'' = -y, and the time itself.
    fn circle<T: Real>([x, v, _]: &[T; 3]) -> [T; 3] {
        [*v, -*x, T::one()]
    }

    #[test]
    fn a_circle_is_followed_to_the_tolerance_that_is_asked_for() {
        for (length, tolerance) in [(0.5, 1e-14), (1.0, 1e-12), (2.0, 1e-8)] {
            let start = [1.0, 0.0, 0.0];
            let taken = step(circle, &start, length, tolerance);
            let end = taken.map_or([f64::NAN; 3], |taken| taken.end);
            let error = (end[0] - f64::cos(length))
                .abs()
                .max((end[1] + f64::sin(length)).abs());
            // the difference to the order below bounds the error; the sizes of the weights of eight rows add up to 119, and a row sums
            // up to sixteen substeps that are each rounded
            let rounding = 119.0 * 16.0 * f64::EPSILON * length;
            assert!(error <= tolerance + rounding, "{length}: {error:e}");
            assert!((end[2] - length).abs() <= rounding, "{length}: {}", end[2]);
        }
    }

    #[test]
    fn a_step_that_is_too_long_is_refused() {
        assert_eq!(step(circle, &[1.0, 0.0, 0.0], 40.0, 1e-12), None);
        assert_eq!(step(circle, &[f64::NAN, 0.0, 0.0], 0.1, 1e-12), None);
    }

    #[test]
    fn more_digits_and_derivatives_come_from_the_scalar() {
        let one = DoubleDouble::lift(1.0);
        let start = [one, DoubleDouble::lift(0.0), DoubleDouble::lift(0.0)];
        let eighth = DoubleDouble::lift(0.125);
        let end = step(circle, &start, eighth, 1e-22).map(|taken| taken.end);
        // cos(1/8) to 32 digits, as the sum of its nearest f64 and the rest
        let known = DoubleDouble::new(0.992197667229329, 4.754870575189364e-17);
        let error = end.map_or(f64::NAN, |end| (end[0] - known).abs().to_f64());
        assert!(error <= 1e-22, "{error:e}");
        let seeded = [
            Dual::<f64, 1>::input(1.0, 0),
            Dual::constant(0.0),
            Dual::constant(0.0),
        ];
        let end = step(circle, &seeded, Dual::constant(0.125), 1e-14).map(|taken| taken.end);
        // the solution is linear in its start
        assert!(end.is_some_and(|end| (end[0].partials[0] - end[0].value).abs() <= 1e-15));
    }
}
