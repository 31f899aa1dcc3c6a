//! 237 bits: the crate `f256` (octuple precision of IEEE 754, pure Rust) as a scalar of the exact engine.

use super::Real;

/// A number of 237 bits, about 71 decimal digits.
pub type Octuple = f256::f256;

/// Bits of the fraction in the upper of the two words.
const UPPER: u32 = 108;
/// What is added to the exponent in the encoding.
const BIAS: i32 = 262_143;

impl Real for Octuple {
    type Finer = Self;
    // 2^-236
    const ULP: f64 = f64::from_bits((1023 - 236) << 52);
    const BITS: u32 = 237;

    fn lift(x: f64) -> Self {
        Octuple::from(x)
    }

    fn to_f64(self) -> f64 {
        if !Octuple::is_finite(self) {
            return if Octuple::is_nan(self) {
                f64::NAN
            } else if self < Octuple::ZERO {
                f64::NEG_INFINITY
            } else {
                f64::INFINITY
            };
        }
        let (upper, lower) = self.to_bits();
        let exponent = ((upper >> UPPER) & 0x7_ffff) as i32;
        if exponent == 0 {
            // far below the smallest f64
            return 0.0;
        }
        let fraction = upper & ((1 << UPPER) - 1);
        // what lies below decides ties only, and one bit is enough for that
        let significand = (1 << UPPER) | fraction | u128::from(lower != 0);
        let scale = exponent - BIAS - UPPER as i32;
        let half = scale / 2;
        let size = significand as f64 * 2_f64.powi(half) * 2_f64.powi(scale - half);
        if self < Octuple::ZERO { -size } else { size }
    }

    fn sqrt(self) -> Self {
        Octuple::sqrt(self)
    }

    fn abs(self) -> Self {
        Octuple::abs(&self)
    }

    fn is_finite(self) -> bool {
        // as the others mean it: what leaves the range of f64 cannot be written down
        self.to_f64().is_finite()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::random::Draws;

    #[test]
    fn every_f64_survives_the_way_there_and_back() {
        let mut draws = Draws::new(1, 0);
        let special = [
            0.0,
            -0.0,
            1.0,
            -1.5,
            f64::MAX,
            f64::MIN_POSITIVE,
            5e-324,
            f64::INFINITY,
        ];
        for x in special {
            assert_eq!(Octuple::lift(x).to_f64(), x);
        }
        assert!(Octuple::lift(f64::NAN).to_f64().is_nan());
        for _ in 0..10_000 {
            let x = f64::from_bits(draws.bits());
            if x.is_normal() {
                assert_eq!(Octuple::lift(x).to_f64(), x);
            }
        }
    }

    #[test]
    fn rounding_to_f64_is_to_nearest_even() {
        let (one, ulp) = (Octuple::lift(1.0), Octuple::lift(f64::EPSILON));
        let half = ulp / Octuple::lift(2.0);
        let tiny = Octuple::lift(1e-60);
        for (x, wanted) in [
            (one + half, 1.0),
            (one + half + tiny, 1.0 + f64::EPSILON),
            (one + half - tiny, 1.0),
            (one + ulp + half, 1.0 + 2.0 * f64::EPSILON),
            (-(one + half + tiny), -1.0 - f64::EPSILON),
        ] {
            assert_eq!(x.to_f64(), wanted);
        }
    }

    #[test]
    fn the_root_of_two_has_its_known_digits() {
        // OEIS A002193, more digits than there is room for
        let digits =
            "1.41421356237309504880168872420969807856967187537694807317667973799073247846210703885";
        let known: Octuple = digits.parse().unwrap_or(Octuple::ZERO);
        let error = (Real::sqrt(Octuple::lift(2.0)) - known).to_f64();
        // both the root and the reading of the digits are rounded to nearest
        assert!(error.abs() <= Octuple::ULP, "{error:e}");
    }
}
