//! The scalar that the exact engine and the impact laws are generic over.
//!
//! It asks for field arithmetic, order and a square root and builds the rest on them, so that a number with more digits or one that
//! carries a derivative can be written in one file. Inputs are the f64 numbers of a scene, lifted exactly.

use super::exponential::exponential;
use nalgebra::{ClosedAddAssign, ClosedDivAssign, ClosedMulAssign, ClosedSubAssign, Scalar};
use num_traits::{One, Zero};
use std::ops::Neg;

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
    /// Spacing of the numbers just above 1 (the unit in the last place), as f64.
    const ULP: f64;

    /// Bits of the significand.
    const BITS: u32;

    /// Largest relative error of one operation; half an ulp where operations round to nearest.
    const ROUNDING: f64 = Self::ULP / 2.0;

    /// Whether the last step of an iteration must be taken from a detached start, so that derivatives come out exact.
    const DIFFERENTIATES: bool = false;

    /// The same number without its derivatives.
    fn detached(self) -> Self {
        self
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

    /// The same number in a scalar that is at least as wide, exactly.
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

impl Real for f64 {
    const ULP: f64 = f64::EPSILON;
    const BITS: u32 = f64::MANTISSA_DIGITS;
    fn lift(x: f64) -> Self {
        x
    }
    fn to_f64(self) -> f64 {
        self
    }
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    fn exp(self) -> Self {
        f64::exp(self)
    }
    fn abs(self) -> Self {
        f64::abs(self)
    }
}

impl Real for f32 {
    const ULP: f64 = f32::EPSILON as f64;
    const BITS: u32 = f32::MANTISSA_DIGITS;
    fn lift(x: f64) -> Self {
        x as f32
    }
    fn to_f64(self) -> f64 {
        f64::from(self)
    }
    fn sqrt(self) -> Self {
        f32::sqrt(self)
    }
    fn exp(self) -> Self {
        f32::exp(self)
    }
    fn abs(self) -> Self {
        f32::abs(self)
    }
}
