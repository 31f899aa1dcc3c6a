//! Systems of linear equations in any scalar.

use super::Real;

/// A square matrix as triangular factors, with the rows that were exchanged for the largest pivots.
#[derive(Clone, Debug)]
pub struct Factors<T> {
    rows: Vec<Vec<T>>,
    pivots: Vec<usize>,
}

impl<T: Real> Factors<T> {
    /// The factors of a matrix by rows; `None` if a pivot is no larger than `none`, or no number.
    pub fn of(mut rows: Vec<Vec<T>>, none: T) -> Option<Self> {
        let n = rows.len();
        let mut pivots = Vec::with_capacity(n);
        for k in 0..n {
            let mut pivot = k;
            for i in k + 1..n {
                if rows[i][k].abs() > rows[pivot][k].abs() {
                    pivot = i;
                }
            }
            rows.swap(k, pivot);
            pivots.push(pivot);
            let (above, below) = rows.split_at_mut(k + 1);
            let top = &above[k];
            if top[k].abs() <= none || !top[k].is_finite() {
                return None;
            }
            for row in below {
                let factor = row[k] / top[k];
                row[k] = factor;
                if !factor.is_nothing() {
                    for (entry, of_top) in row[k + 1..].iter_mut().zip(&top[k + 1..]) {
                        *entry -= factor * *of_top;
                    }
                }
            }
        }
        Some(Factors { rows, pivots })
    }

    /// The solution of the system, in place of its right side.
    pub fn solve(&self, right: &mut [T]) {
        let n = right.len();
        for (k, pivot) in self.pivots.iter().enumerate() {
            right.swap(k, *pivot);
        }
        for i in 0..n {
            for k in 0..i {
                let known = self.rows[i][k] * right[k];
                right[i] -= known;
            }
        }
        for i in (0..n).rev() {
            for k in i + 1..n {
                let known = self.rows[i][k] * right[k];
                right[i] -= known;
            }
            right[i] /= self.rows[i][i];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Factors;

    #[test]
    fn a_system_that_needs_its_rows_exchanged_is_solved_and_one_without_an_answer_is_not() {
        let rows = vec![
            vec![0.0, 2.0, 1.0],
            vec![1.0, 1.0, 0.0],
            vec![3.0, 0.0, -1.0],
        ];
        let Some(factors) = Factors::of(rows, 0.0_f64) else {
            panic!("it is regular");
        };
        // of (1, 2, 3)
        let mut right = [7.0_f64, 3.0, 0.0];
        factors.solve(&mut right);
        for (got, want) in right.into_iter().zip([1.0, 2.0, 3.0]) {
            assert!((got - want).abs() < 1e-14, "{got} {want}");
        }
        let rows = vec![vec![1.0, 2.0], vec![2.0, 4.0]];
        assert!(Factors::of(rows, 1e-15).is_none());
    }
}
