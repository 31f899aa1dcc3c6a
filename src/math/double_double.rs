//! Double-double: a number as the unevaluated sum of two f64, 106 bits.
//!
//! Built on error-free transformations: the rounding error of an f64 sum (Knuth) or product (Dekker, Veltkamp's split) is
//! itself an f64 and is computed exactly. The algorithms and their error bounds are those of Joldes, Muller and Popescu
//! 2017, "Tight and rigorous error bounds for basic building blocks of double-word arithmetic" (ACM TOMS 44, 15), with
//! u = 2^-53: sum 3 u^2, product 7 u^2, quotient 15 u^2, root 4 u^2. No fused multiply-add is used: without hardware for it,
//! which a portable build cannot assume, it costs more than ten times Dekker's product.

use super::Real;
use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// A number of 106 bits: `high + low` with `|low| <= ulp(high) / 2`. Its range is that of f64, short of overflow by 2^28.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct DoubleDouble {
    high: f64,
    low: f64,
}

/// 2^27 + 1: splits 53 bits into 26 and 26.
const SPLITTER: f64 = 134_217_729.0;

/// `a + b` rounded, and its error.
#[inline(always)]
fn sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let t = s - a;
    (s, (a - (s - t)) + (b - t))
}

/// `a + b` rounded, and its error, for `|a| >= |b|`.
#[inline(always)]
fn ordered_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    (s, b - (s - a))
}

#[inline(always)]
fn split(a: f64) -> (f64, f64) {
    let c = SPLITTER * a;
    let high = c - (c - a);
    (high, a - high)
}

/// `a b` rounded, and its error.
#[inline(always)]
fn product(a: f64, b: f64) -> (f64, f64) {
    let p = a * b;
    let ((ah, al), (bh, bl)) = (split(a), split(b));
    (p, ((ah * bh - p) + ah * bl + al * bh) + al * bl)
}

impl DoubleDouble {
    /// `high + low`, exactly where both fit 106 bits.
    pub fn new(high: f64, low: f64) -> Self {
        Self::tidy(sum(high, low))
    }

    /// The leading f64.
    pub fn high(self) -> f64 {
        self.high
    }

    /// What the leading f64 leaves over.
    pub fn low(self) -> f64 {
        self.low
    }

    /// An infinite or undefined number has no second part.
    #[inline(always)]
    fn tidy((high, low): (f64, f64)) -> Self {
        // NaN also where the error of an infinite sum was computed
        if high.is_finite() {
            DoubleDouble { high, low }
        } else {
            DoubleDouble { high, low: 0.0 }
        }
    }
}

impl Add for DoubleDouble {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        let (s, e) = sum(self.high, other.high);
        let (t, f) = sum(self.low, other.low);
        let (high, low) = ordered_sum(s, e + t);
        if high.is_finite() {
            Self::tidy(ordered_sum(high, f + low))
        } else {
            DoubleDouble { high: s, low: 0.0 }
        }
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        DoubleDouble {
            high: -self.high,
            low: -self.low,
        }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let (p, e) = product(self.high, other.high);
        let cross = self.high * other.low + self.low * other.high;
        if p.is_finite() {
            Self::tidy(ordered_sum(p, e + cross))
        } else {
            DoubleDouble { high: p, low: 0.0 }
        }
    }
}

impl Div for DoubleDouble {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let quotient = self.high / other.high;
        if !quotient.is_finite() || other.high.is_infinite() {
            return DoubleDouble {
                high: quotient,
                low: 0.0,
            };
        }
        let rest = self - other * DoubleDouble::lift(quotient);
        Self::tidy(ordered_sum(quotient, rest.high / other.high))
    }
}

macro_rules! assign {
    ($trait:ident, $method:ident, $operation:tt) => {
        impl $trait for DoubleDouble {
            #[inline]
            fn $method(&mut self, other: Self) {
                *self = *self $operation other;
            }
        }
    };
}

assign!(AddAssign, add_assign, +);
assign!(SubAssign, sub_assign, -);
assign!(MulAssign, mul_assign, *);
assign!(DivAssign, div_assign, /);

impl Zero for DoubleDouble {
    fn zero() -> Self {
        Self::lift(0.0)
    }
    fn is_zero(&self) -> bool {
        self.high == 0.0
    }
}

impl One for DoubleDouble {
    fn one() -> Self {
        Self::lift(1.0)
    }
}

impl Real for DoubleDouble {
    type Finer = super::Octuple;
    // 2^-104: four times u^2, above the error of a sum and of a root
    const ULP: f64 = f64::EPSILON * f64::EPSILON;
    const BITS: u32 = 106;
    // of a product; the quotients of a root finder are steps, and small
    const ROUNDING: f64 = 7.0 / 4.0 * Self::ULP;

    #[inline]
    fn lift(x: f64) -> Self {
        DoubleDouble { high: x, low: 0.0 }
    }

    #[inline]
    fn to_f64(self) -> f64 {
        self.high
    }

    #[inline]
    fn sqrt(self) -> Self {
        let root = self.high.sqrt();
        if self.high == 0.0 || !root.is_finite() {
            return DoubleDouble {
                high: root,
                low: 0.0,
            };
        }
        let (square, error) = product(root, root);
        let rest = self
            - DoubleDouble {
                high: square,
                low: error,
            };
        Self::tidy(ordered_sum(root, rest.high / (2.0 * root)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Octuple;
    use crate::math::random::Draws;

    /// u^2, u = 2^-53.
    const U2: f64 = f64::EPSILON * f64::EPSILON / 4.0;

    fn wide(x: DoubleDouble) -> Octuple {
        Octuple::lift(x.high) + Octuple::lift(x.low)
    }

    fn draw(draws: &mut Draws) -> DoubleDouble {
        let size = 2_f64.powf(draws.between(-40.0, 40.0));
        let high = draws.between(-1.0, 1.0) * size;
        DoubleDouble::new(high, high * draws.between(-1.0, 1.0) * f64::EPSILON / 2.0)
    }

    #[test]
    fn every_operation_keeps_its_published_error_bound() {
        let mut draws = Draws::new(2, 0);
        let mut worst = [0.0_f64; 4];
        for _ in 0..20_000 {
            let (a, b) = (draw(&mut draws), draw(&mut draws));
            let (x, y) = (wide(a), wide(b));
            let magnitude = Real::abs(x);
            let root = if a.high < 0.0 { -a } else { a }.sqrt();
            let checks = [
                (a + b, x + y),
                (a * b, x * y),
                (a / b, x / y),
                (root, Real::sqrt(magnitude)),
            ];
            for (worst, (got, want)) in worst.iter_mut().zip(checks) {
                let error = Real::abs((wide(got) - want) / want).to_f64();
                *worst = worst.max(error / U2);
                // the two parts do not overlap
                assert_eq!(got.high + got.low, got.high);
            }
        }
        for (what, worst, bound) in [
            ("sum", worst[0], 3.01),
            ("product", worst[1], 7.0),
            ("quotient", worst[2], 15.0),
            ("root", worst[3], 4.0),
        ] {
            assert!(worst <= bound, "{what}: {worst} u^2, allowed {bound}");
            assert!(worst > 0.1, "{what}: {worst} u^2 is too good to be true");
        }
    }

    #[test]
    fn cancellation_loses_nothing_of_a_sum() {
        let (big, tiny) = (DoubleDouble::lift(1.0), DoubleDouble::lift(1e-30));
        assert_eq!(((big + tiny) - big).to_f64(), 1e-30);
        let third = DoubleDouble::lift(1.0) / DoubleDouble::lift(3.0);
        let error = third * DoubleDouble::lift(3.0) - DoubleDouble::one();
        assert!(error.to_f64().abs() <= 8.0 * U2);
    }

    #[test]
    fn the_root_of_two_has_its_known_digits() {
        // OEIS A002193
        let known = "1.41421356237309504880168872420969807856967187537694";
        let known: Octuple = known.parse().unwrap_or(Octuple::ZERO);
        let error = (wide(DoubleDouble::lift(2.0).sqrt()) - known).to_f64();
        assert!(error.abs() <= 6.0 * U2, "{error:e}");
    }

    #[test]
    fn infinity_and_nan_are_as_in_f64() {
        let (one, inf) = (DoubleDouble::one(), DoubleDouble::lift(f64::INFINITY));
        let nan = inf - inf;
        assert!(nan.to_f64().is_nan() && !nan.is_finite());
        assert_eq!(one / inf, DoubleDouble::zero());
        assert_eq!((one + inf, inf - one, inf * inf), (inf, inf, inf));
        assert_eq!(one / DoubleDouble::zero(), inf);
        assert_eq!(DoubleDouble::zero().sqrt(), DoubleDouble::zero());
        assert_eq!(inf.sqrt(), inf);
        assert!((-one).sqrt().to_f64().is_nan());
        assert!(one < inf && -inf < one);
    }
}
