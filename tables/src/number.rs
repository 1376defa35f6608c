//! What must a number be able to do to read a table? Reads one value; writes one value.

use core::ops::{Add, Div, Mul, Neg, Sub};

/// The operations that reading a table uses, and no more.
///
/// Implemented for `f32` and `f64`. Both go through `libm`, so every target gets the same bits.
/// A fixed-point type can implement it too.
pub trait Real:
    Copy
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The nearest value of this type.
    fn from_f32(value: f32) -> Self;
    /// The nearest value of this type.
    fn from_f64(value: f64) -> Self;
    /// The value as `f64`.
    fn to_f64(self) -> f64;
    /// The square root of a value that is not negative.
    fn sqrt(self) -> Self;
    /// The cube root of a value that is not negative.
    fn cbrt(self) -> Self;
    /// `ln(1 + self)` of a value that is not negative.
    fn ln_1p(self) -> Self;
}

impl Real for f32 {
    fn from_f32(value: f32) -> Self {
        value
    }
    fn from_f64(value: f64) -> Self {
        value as f32
    }
    fn to_f64(self) -> f64 {
        f64::from(self)
    }
    fn sqrt(self) -> Self {
        libm::sqrtf(self)
    }
    fn cbrt(self) -> Self {
        libm::cbrtf(self)
    }
    fn ln_1p(self) -> Self {
        libm::log1pf(self)
    }
}

impl Real for f64 {
    fn from_f32(value: f32) -> Self {
        f64::from(value)
    }
    fn from_f64(value: f64) -> Self {
        value
    }
    fn to_f64(self) -> f64 {
        self
    }
    fn sqrt(self) -> Self {
        libm::sqrt(self)
    }
    fn cbrt(self) -> Self {
        libm::cbrt(self)
    }
    fn ln_1p(self) -> Self {
        libm::log1p(self)
    }
}
