//! One step of a stiff ordinary differential equation by the extrapolated linearly implicit rule of Euler.
//!
//! A solution is stiff where neighbours run into it much faster than it changes itself; an explicit rule then has to follow how they
//! would. This one solves a linear system with the matrix of derivatives in every substep, `(1 - h J) (y' - y) = h f(y)`. Its error goes in
//! powers of `h`, whatever the matrix, so that one taken from differences will do. Source: Hairer, Wanner, "Solving Ordinary
//! Differential Equations II", IV.9 (SEULEX; Deuflhard 1985).

use super::Real;
use super::extrapolation::{Step, extrapolate};
use super::linear::Factors;

/// The solution of `dy/dx = rate(y)` from `start` over `length`; `None` if its error stays above `tolerance`, absolute, within `rows` rows.
///
/// `sizes`: of which size each component is where the rate changes by a part of itself; 0 for one on which it does not depend.
pub fn step<T: Real>(
    rows: usize,
    rate: impl Fn(&[T]) -> Vec<T>,
    start: &[T],
    sizes: &[T],
    length: T,
    tolerance: f64,
) -> Option<Step<Vec<T>>> {
    let matrix = derivatives(&rate, start, sizes);
    let weight =
        |row: usize, column: usize| T::lift((row - column) as f64) / T::lift((column + 1) as f64);
    let plain = |row: usize| substeps(&rate, start, &matrix, length, row + 1);
    extrapolate(rows, tolerance, plain, weight)
}

/// Columns of the matrix of derivatives, by differences; none for a component without a size.
fn derivatives<T: Real>(
    rate: &impl Fn(&[T]) -> Vec<T>,
    start: &[T],
    sizes: &[T],
) -> Vec<Option<Vec<T>>> {
    let here = rate(start);
    let part = T::lift(T::ULP.sqrt());
    let column = |(i, size): (usize, &T)| {
        if size.is_zero() {
            return None;
        }
        let mut aside = start.to_vec();
        aside[i] += *size * part;
        let by = aside[i] - start[i];
        let there = rate(&aside);
        Some(
            there
                .iter()
                .zip(&here)
                .map(|(a, b)| (*a - *b) / by)
                .collect(),
        )
    };
    sizes.iter().enumerate().map(column).collect()
}

/// So many substeps of equal length.
fn substeps<T: Real>(
    rate: &impl Fn(&[T]) -> Vec<T>,
    start: &[T],
    matrix: &[Option<Vec<T>>],
    length: T,
    substeps: usize,
) -> Option<Vec<T>> {
    let h = length / T::lift(substeps as f64);
    let n = start.len();
    // rows of 1 - h J
    let mut system = vec![vec![T::zero(); n]; n];
    for (i, row) in system.iter_mut().enumerate() {
        row[i] = T::one();
        for (entry, column) in row.iter_mut().zip(matrix) {
            if let Some(column) = column {
                *entry -= h * column[i];
            }
        }
    }
    let factors = Factors::of(system, T::zero())?;
    // the sum of the changes apart from the start, which has fewer digits left for them
    let mut changed = vec![T::zero(); n];
    for _ in 0..substeps {
        let now: Vec<T> = start.iter().zip(&changed).map(|(x, dx)| *x + *dx).collect();
        let mut change: Vec<T> = rate(&now).into_iter().map(|rate| rate * h).collect();
        factors.solve(&mut change);
        for (sum, change) in changed.iter_mut().zip(change) {
            *sum += change;
        }
    }
    Some(start.iter().zip(&changed).map(|(x, dx)| *x + *dx).collect())
}

#[cfg(test)]
mod tests {
    use super::step;
    use crate::math::{DoubleDouble, Real};

    /// `y` runs into cos x at a rate of 10^6, the other component is x.
    fn chased<T: Real>([y, x]: [T; 2]) -> Vec<T> {
        // cosine and its derivative by their series: x is small
        let (mut cos, mut sin, mut term) = (T::zero(), T::zero(), T::one());
        for k in 0..24_u32 {
            let sign = if k % 4 < 2 { T::one() } else { -T::one() };
            if k % 2 == 0 {
                cos += sign * term;
            } else {
                sin += sign * term;
            }
            term *= x / T::lift(f64::from(k + 1));
        }
        vec![(cos - y) * T::lift(1e6) - sin, T::one()]
    }

    #[test]
    fn a_stiff_solution_is_followed_in_steps_of_its_own_size() {
        let rate = |y: &[f64]| chased([y[0], y[1]]);
        let taken = step(10, rate, &[1.0, 0.0], &[1.0, 1.0], 0.1, 1e-12);
        let end = taken.map_or(vec![f64::NAN; 2], |taken| taken.end);
        // weights of ten rows add up to 1e4 roundings
        assert!((end[0] - 0.1_f64.cos()).abs() <= 2e-12, "{end:?}");
        assert!((end[1] - 0.1).abs() <= 2e-12, "{end:?}");
        // an explicit rule would need a hundred thousand
        let rate = |y: &[DoubleDouble]| chased([y[0], y[1]]);
        let start = [DoubleDouble::lift(1.0), DoubleDouble::lift(0.0)];
        let length = DoubleDouble::lift(0.125);
        let taken = step(20, rate, &start, &[start[0]; 2], length, 1e-19);
        // cos(1/8) to 32 digits, as the sum of its nearest f64 and the rest
        let known = DoubleDouble::new(0.992197667229329, 4.754870575189364e-17);
        let off = taken.map_or(f64::NAN, |taken| (taken.end[0] - known).abs().to_f64());
        assert!(off <= 1e-18, "{off:e}");
    }

    #[test]
    fn a_step_that_is_too_long_is_refused() {
        let rate = |y: &[f64]| vec![y[0] * y[0]];
        assert_eq!(step(8, rate, &[1.0], &[1.0], 3.0, 1e-12), None);
        assert_eq!(step(8, rate, &[f64::NAN], &[1.0], 0.1, 1e-12), None);
    }
}
