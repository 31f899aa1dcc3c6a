//! The scalar that the exact engine and the impact laws are generic over.
//!
//! It asks for field arithmetic, order and a square root and builds the rest on them, so that a number with more digits or one that
//! carries a derivative can be written in one file. Inputs are the f64 numbers of a scene, lifted exactly.

use nalgebra::{ClosedAddAssign, ClosedDivAssign, ClosedMulAssign, ClosedSubAssign, Scalar};
use num_traits::{One, Zero};
use std::ops::Neg;

/// Derivatives that differ by less than this part of their sizes, or of the largest of all, are the same: they come from series and roots of f64 whose
/// conditions are no worse than 1e6.
pub(super) const COMMON: f64 = 1e-6;

/// A real number: what a law of motion may do with one.
pub trait Real:
    Scalar
    + Copy
    + PartialOrd
    + Zero
    + One
    + ClosedAddAssign
    + ClosedSubAssign
    + ClosedMulAssign
    + ClosedDivAssign
    + Neg<Output = Self>
    + Send
    + Sync
{
    /// The next scalar with more digits; this one where there is none.
    type Finer: Real;

    /// Spacing of the numbers just above 1 (the unit in the last place), as f64.
    const ULP: f64;

    /// Bits of the significand.
    const BITS: u32;

    /// Largest relative error of one operation; half an ulp where operations round to nearest.
    const ROUNDING: f64 = Self::ULP / 2.0;

    /// Whether the last step of an iteration must be taken from a detached start, so that derivatives come out exact.
    const DIFFERENTIATES: bool = false;

    /// Inputs by which it has derivatives.
    const INPUTS: usize = 0;

    /// The same number without its derivatives.
    fn detached(self) -> Self {
        self
    }

    /// This number with the derivatives of another; itself where there are none.
    #[inline]
    fn following(self, _other: Self) -> Self {
        self
    }

    /// Its derivative by an input; 0 where there are none.
    fn partial(self, _input: usize) -> f64 {
        0.0
    }

    /// The same number with a derivative by an input that is larger by so much; itself where there are none.
    fn nudged(self, _input: usize, _by: f64) -> Self {
        self
    }

    /// This number, whose derivatives are those of another as well: none (NaN) where the two differ by more than a millionth of the largest.
    fn common(self, _other: Self) -> Self {
        self
    }

    /// Zero, and without derivatives.
    #[inline]
    fn is_nothing(self) -> bool {
        self.is_zero()
    }

    /// The f64 number `x`; exact for every scalar at least as wide as f64.
    fn lift(x: f64) -> Self;

    /// The nearest f64.
    fn to_f64(self) -> f64;

    /// Square root; NaN below zero.
    fn sqrt(self) -> Self;

    /// `e` to the power of this number, to a few ulp times `1 + |x|`.
    fn exp(self) -> Self {
        exponential(self)
    }

    /// Absolute value.
    fn abs(self) -> Self {
        if self < Self::zero() { -self } else { self }
    }

    /// The same number in another scalar: exactly in one that is at least as wide, rounded in others.
    fn widen<W: Real>(self) -> W {
        let leading = self.to_f64();
        let mut sum = W::lift(leading);
        if !leading.is_finite() {
            return sum;
        }
        let mut rest = self - Self::lift(leading);
        while !rest.is_zero() {
            let next = rest.to_f64();
            if next == 0.0 {
                break;
            }
            sum += W::lift(next);
            rest -= Self::lift(next);
        }
        sum
    }

    /// True unless the number is NaN or infinite.
    fn is_finite(self) -> bool {
        self.to_f64().is_finite()
    }

    /// The larger of two numbers; the first if the second is NaN.
    fn at_least(self, other: Self) -> Self {
        if other > self { other } else { self }
    }

    /// The smaller of two numbers; the first if the second is NaN.
    fn at_most(self, other: Self) -> Self {
        if other < self { other } else { self }
    }
}

// The exponential function from field arithmetic: `x = k ln 2 + r` with `|r| <= ln 2 / 2`, then `r / 2^HALVINGS`, then the Taylor series of
// `exp - 1`, whose doublings `e -> 2 e + e^2` bring the halvings back without the cancellation that squaring near 1 would suffer.

/// ln 2 as an unevaluated sum of f64 numbers: 318 bits, more than the widest scalar has.
const LN_2: [f64; 6] = [
    std::f64::consts::LN_2,
    2.319_046_813_846_299_6e-17,
    5.707_708_438_416_212e-34,
    -3.582_432_210_601_811_4e-50,
    -1.352_169_675_798_863e-66,
    6.080_638_740_240_814e-83,
];

/// Halvings of the reduced argument: it is then below 2^-9.
const HALVINGS: u32 = 8;

/// Beyond these the result is infinite or zero, in f64 and by [`Real::is_finite`] everywhere.
const RANGE: (f64, f64) = (-745.2, 709.8);

/// `exp(x)`, to a few ulp of the scalar times `1 + |x|`: the conditioning of the function itself.
fn exponential<T: Real>(x: T) -> T {
    let size = x.to_f64();
    if size.is_nan() {
        return x;
    }
    if size < RANGE.0 {
        return T::zero();
    }
    if size > RANGE.1 {
        return T::lift(f64::INFINITY);
    }
    let turns = (size / LN_2[0]).round();
    let mut rest = x;
    for part in LN_2 {
        rest -= T::lift(part) * T::lift(turns);
    }
    rest /= T::lift(f64::from(1_u32 << HALVINGS));
    let mut term = rest;
    let mut sum = rest;
    let mut n = 1.0;
    while term.abs().to_f64() > sum.abs().to_f64() * T::ULP * 0.125 {
        n += 1.0;
        term *= rest / T::lift(n);
        sum += term;
    }
    for _ in 0..HALVINGS {
        sum = sum + sum + sum * sum;
    }
    let half = (turns / 2.0).trunc();
    let power = |k: f64| T::lift(2.0_f64.powi(k as i32));
    (sum + T::one()) * power(half) * power(turns - half)
}

#[cfg(test)]
mod tests {
    use super::exponential;
    use crate::math::random::Draws;
    use crate::math::{DoubleDouble, Dual, Octuple, Real};

    /// e to 80 digits (OEIS A001113).
    const E: &str =
        "2.7182818284590452353602874713526624977572470936999595749669676277240766303535475945";

    #[test]
    fn e_has_its_known_digits_in_every_scalar() {
        let known: Octuple = E.parse().unwrap_or(Octuple::ZERO);
        let off = |got: Octuple, ulp: f64| {
            let error = ((got - known) / known).to_f64().abs();
            assert!(error <= 8.0 * ulp, "{error:e}, ulp {ulp:e}");
        };
        off(exponential(Octuple::lift(1.0)), Octuple::ULP);
        off(
            exponential(DoubleDouble::lift(1.0)).widen(),
            DoubleDouble::ULP,
        );
        off(exponential(1.0_f64).widen(), f64::EPSILON);
        off(exponential(1.0_f32).widen(), f64::from(f32::EPSILON));
    }

    #[test]
    fn the_product_of_two_powers_is_the_power_of_the_sum() {
        let mut draws = Draws::new(17, 0);
        for _ in 0..500 {
            let (x, y) = (draws.between(-300.0, 300.0), draws.between(-300.0, 300.0));
            let (a, b) = (Octuple::lift(x), Octuple::lift(y));
            let (got, want) = (exponential(a) * exponential(b), exponential(a + b));
            let error = ((got - want) / want).to_f64().abs();
            // each of the three is good to a few ulp times 1 + |x|
            let allowed = 8.0 * Octuple::ULP * (3.0 + x.abs() + y.abs() + (x + y).abs());
            assert!(error <= allowed, "{x} {y}: {error:e}");
            let library = (x.exp() - exponential(x)).abs() / x.exp();
            assert!(
                library <= 4.0 * f64::EPSILON * (1.0 + x.abs()),
                "{x}: {library:e}"
            );
        }
    }

    #[test]
    fn it_is_its_own_derivative_and_ends_where_numbers_end() {
        let y = Dual::<f64, 1>::input(-1.3, 0).exp();
        assert_eq!(y.value, y.partials[0]);
        assert_eq!(exponential(DoubleDouble::lift(-1e9)).to_f64(), 0.0);
        assert_eq!(exponential(Octuple::lift(-1e9)).to_f64(), 0.0);
        assert_eq!(exponential(Octuple::lift(1e9)).to_f64(), f64::INFINITY);
        assert!(exponential(f64::NAN).is_nan());
        assert_eq!(exponential(Octuple::lift(0.0)).to_f64(), 1.0);
    }
}
