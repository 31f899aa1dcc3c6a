//! Numbers without physics: scalars, vectors, the first root of a contact quartic, points sorted into squares and close pairs of them,
//! statistics, seeded random numbers.

pub mod angle;
pub mod double_double;
pub mod dual;
pub mod exponential;
pub mod extrapolation;
pub mod first_root;
pub mod grid;
pub mod near;
mod octuple;
pub mod random;
pub mod real;
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
