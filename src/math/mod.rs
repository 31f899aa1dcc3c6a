//! Numbers without physics: scalars, vectors, the first root of a contact quartic, points sorted into squares and close pairs of them,
//! linear systems, power series of differential equations, statistics, seeded random numbers.

pub mod angle;
pub mod double_double;
pub mod dual;
pub mod extrapolation;
pub mod first_root;
pub mod grid;
pub mod implicit;
pub mod linear;
mod machine;
pub mod near;
mod octuple;
pub mod random;
pub mod real;
pub mod series;
pub mod statistics;

pub use double_double::DoubleDouble;
pub use dual::Dual;
pub use octuple::Octuple;
pub use real::Real;

/// A vector of the scene's three-dimensional frame, f64.
pub type Vec3 = nalgebra::Vector3<f64>;

/// The larger of two numbers, NaN if either is: a measure of error that a NaN cannot slip past.
pub fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || a >= b { a } else { b }
}

/// True if a measure of error is a number within its bound: an infinite one is within nothing, and no bound that overflowed holds one.
///
/// `a <= b` alone lets infinity pass wherever the bound is computed from what became infinite.
pub fn within(error: f64, bound: f64) -> bool {
    error.is_finite() && bound.is_finite() && error <= bound
}

#[cfg(test)]
mod tests {
    use super::{within, worse};

    #[test]
    fn what_is_no_number_is_within_nothing_and_nothing_is_within_it() {
        let none = [f64::INFINITY, f64::NEG_INFINITY, f64::NAN];
        for bad in none {
            for other in none.into_iter().chain([0.0, -1e308, 1e308]) {
                assert!(!within(bad, other), "{bad} within {other}");
                assert!(!within(other, bad), "{other} within {bad}");
            }
        }
        assert!(within(1.0, 1.0) && !within(1.0, 0.5));
    }

    #[test]
    fn a_nan_is_the_worst_of_all_on_either_side() {
        assert!(worse(f64::NAN, f64::INFINITY).is_nan());
        assert!(worse(f64::INFINITY, f64::NAN).is_nan());
        assert_eq!(worse(2.0, 1.0), 2.0);
    }
}
