//! The numbers of the machine as scalars.

use super::{DoubleDouble, Real};

impl Real for f64 {
    type Finer = DoubleDouble;
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
    type Finer = f64;
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
