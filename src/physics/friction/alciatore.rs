//! Friction between balls that falls with the slip speed: Alciatore's fit to Marlow's measurements.
//!
//! Source: D. Alciatore, "The amount of throw", technical proofs TP A.14 and A.28, on the data of W. Marlow, "The Physics of
//! Pocket Billiards" (1995).

use crate::math::Real;

/// The published constants `[a, b, c]`: `a` and `b` without unit, `c` in s/m.
pub const PUBLISHED: [f64; 3] = [9.951e-3, 0.108, 1.088];

/// Coefficient of friction `mu(u) = a + b exp(-c u)`. `u`: slip speed, m/s, >= 0.
pub fn coefficient<T: Real>([a, b, c]: [T; 3], u: T) -> T {
    a + b * (-(c * u)).exp()
}
