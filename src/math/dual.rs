//! Dual numbers: a value with its derivatives by `N` inputs at once, carried exactly through every operation.
//!
//! Order and equality are those of the values, so that a computation in dual numbers takes the same branches as one without.

use super::Real;
use super::real::COMMON;
use num_traits::{One, Zero};
use std::cmp::Ordering;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// A value and its partial derivatives by `N` inputs.
#[derive(Clone, Copy, Debug)]
pub struct Dual<T, const N: usize> {
    /// The value.
    pub value: T,
    /// Derivative by each input: a few digits of it are enough, however many the value has.
    pub partials: [f64; N],
}

impl<T: Real, const N: usize> Dual<T, N> {
    /// A value that depends on no input.
    pub fn constant(value: T) -> Self {
        Dual {
            value,
            partials: [0.0; N],
        }
    }

    /// Input number `input` itself, at `value`.
    pub fn input(value: T, input: usize) -> Self {
        let mut seeded = Self::constant(value);
        if let Some(partial) = seeded.partials.get_mut(input) {
            *partial = 1.0;
        }
        seeded
    }

    /// `value`, where a small step of `self` moves it `slope` as much.
    #[inline]
    fn chain(&self, value: T, slope: T) -> Self {
        let slope = slope.to_f64();
        Dual {
            value,
            partials: self.partials.map(|d| d * slope),
        }
    }

    /// `value`, where small steps of both inputs move it by `by_self` and `by_other`.
    #[inline]
    fn chain2(&self, other: &Self, value: T, by_self: T, by_other: T) -> Self {
        let (by_self, by_other) = (by_self.to_f64(), by_other.to_f64());
        Dual {
            value,
            partials: std::array::from_fn(|i| {
                self.partials[i] * by_self + other.partials[i] * by_other
            }),
        }
    }
}

impl<T: PartialEq, const N: usize> PartialEq for Dual<T, N> {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<T: PartialOrd, const N: usize> PartialOrd for Dual<T, N> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl<T: Real, const N: usize> Add for Dual<T, N> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Dual {
            value: self.value + other.value,
            partials: std::array::from_fn(|i| self.partials[i] + other.partials[i]),
        }
    }
}

impl<T: Real, const N: usize> Sub for Dual<T, N> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Dual {
            value: self.value - other.value,
            partials: std::array::from_fn(|i| self.partials[i] - other.partials[i]),
        }
    }
}

impl<T: Real, const N: usize> Neg for Dual<T, N> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.chain(-self.value, -T::one())
    }
}

impl<T: Real, const N: usize> Mul for Dual<T, N> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        self.chain2(&other, self.value * other.value, other.value, self.value)
    }
}

impl<T: Real, const N: usize> Div for Dual<T, N> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        if !other.value.is_finite() {
            // what is divided by an infinite constant does not move
            return Self::constant(value);
        }
        let inverse = T::one() / other.value;
        self.chain2(&other, value, inverse, -(value * inverse))
    }
}

macro_rules! assign {
    ($trait:ident, $method:ident, $operation:tt) => {
        impl<T: Real, const N: usize> $trait for Dual<T, N> {
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

impl<T: Real, const N: usize> Zero for Dual<T, N> {
    fn zero() -> Self {
        Self::constant(T::zero())
    }
    fn is_zero(&self) -> bool {
        self.value.is_zero()
    }
}

impl<T: Real, const N: usize> One for Dual<T, N> {
    fn one() -> Self {
        Self::constant(T::one())
    }
}

impl<T: Real, const N: usize> Real for Dual<T, N> {
    type Finer = Dual<T::Finer, N>;
    const ULP: f64 = T::ULP;
    const BITS: u32 = T::BITS;
    const ROUNDING: f64 = T::ROUNDING;
    const DIFFERENTIATES: bool = true;
    const INPUTS: usize = N;

    fn detached(self) -> Self {
        Self::constant(self.value)
    }

    fn following(self, other: Self) -> Self {
        Dual {
            value: self.value,
            partials: other.partials,
        }
    }

    fn partial(self, input: usize) -> f64 {
        self.partials.get(input).copied().unwrap_or(0.0)
    }

    fn nudged(mut self, input: usize, by: f64) -> Self {
        if let Some(partial) = self.partials.get_mut(input) {
            *partial += by;
        }
        self
    }

    fn common(mut self, other: Self) -> Self {
        let sizes = self.partials.iter().chain(&other.partials);
        let most = sizes.fold(0.0_f64, |most, partial| most.max(partial.abs()));
        for (own, other) in self.partials.iter_mut().zip(other.partials) {
            // false where one of them is no number
            let same = (*own - other).abs() <= COMMON * most;
            if !same {
                *own = f64::NAN;
            }
        }
        self
    }

    fn is_nothing(self) -> bool {
        self.value.is_zero() && self.partials.iter().all(|partial| *partial == 0.0)
    }

    fn widen<W: Real>(self) -> W {
        let partials = self.partials.iter().enumerate();
        partials.fold(self.value.widen(), |wide: W, (input, partial)| {
            wide.nudged(input, *partial)
        })
    }

    fn lift(x: f64) -> Self {
        Self::constant(T::lift(x))
    }

    fn to_f64(self) -> f64 {
        self.value.to_f64()
    }

    /// The derivative at 0 is taken as 0: a length that vanishes has no direction in which it grows.
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        if root == T::zero() {
            return Self::constant(root);
        }
        self.chain(root, T::one() / (root + root))
    }

    fn exp(self) -> Self {
        let power = self.value.exp();
        self.chain(power, power)
    }

    fn is_finite(self) -> bool {
        self.value.is_finite()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::DoubleDouble;
    use crate::math::random::Draws;

    /// Something with every operation, of two inputs.
    fn sample<T: Real>(x: T, y: T) -> T {
        let mut z = (x * y + T::one()) / (y - x * T::lift(3.0));
        z -= x;
        z *= y;
        z += (x * x + y * y).sqrt() - (-x).abs();
        z / (x + T::lift(2.0))
    }

    #[test]
    fn what_two_numbers_have_in_common_is_none_where_either_has_none() {
        let with = |partials: [f64; 3]| Dual::<f64, 3> {
            value: 1.0,
            partials,
        };
        let known = with([1.0, 2.0, 3.0]);
        for (one, other) in [
            (known, with([1.0, 2.5, f64::NAN])),
            (with([1.0, 2.5, f64::NAN]), known),
        ] {
            let common = one.common(other).partials;
            assert_eq!(common[0], 1.0);
            assert!(common[1].is_nan() && common[2].is_nan(), "{common:?}");
        }
    }

    #[test]
    fn derivatives_are_those_of_difference_quotients() {
        let mut draws = Draws::new(3, 0);
        let h = DoubleDouble::lift(1e-10);
        for _ in 0..500 {
            let (x, y) = (draws.between(0.5, 2.0), draws.between(7.0, 9.0));
            let z = sample(Dual::<f64, 2>::input(x, 0), Dual::input(y, 1));
            let (dx, dy) = (DoubleDouble::lift(x), DoubleDouble::lift(y));
            assert!((z.value - sample(x, y)).abs() <= 1e-14 * z.value.abs().max(1.0));
            let by_x = (sample(dx + h, dy) - sample(dx - h, dy)) / (h + h);
            let by_y = (sample(dx, dy + h) - sample(dx, dy - h)) / (h + h);
            for (got, want) in z.partials.iter().zip([by_x, by_y]) {
                // central differences leave h^2 = 1e-20 and 1e-32/h; the rest is rounding of the dual numbers
                let error = (got - want.to_f64()).abs();
                assert!(error <= 1e-12, "{got} instead of {}", want.to_f64());
            }
        }
    }

    #[test]
    fn branches_are_those_of_the_values() {
        let (a, b) = (Dual::<f64, 1>::input(1.0, 0), Dual::constant(1.0));
        assert_eq!(a, b);
        assert!(a < Dual::constant(1.5) && a.detached().partials == [0.0]);
        assert_eq!(Dual::<f64, 1>::input(0.0, 0).sqrt().partials, [0.0]);
        let infinite = Dual::<f64, 1>::lift(f64::INFINITY);
        assert_eq!((a / infinite).partials, [0.0]);
        assert_eq!(a.at_most(infinite).partials, [1.0]);
    }
}
