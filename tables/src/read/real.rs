//! What must a number be able to do to read a table? Reads one value; writes one value.

use super::square_root;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// The operations that reading a table uses, and no more.
///
/// Implemented for `f32` and `f64`, which both go through `libm`, so every target gets the same bits,
/// and with the feature `fixed` for `I32F32` and `I16F16`, whose operations use no float at all.
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
    /// A number of steps of 2^−28, as quantised tables store them.
    fn from_quantised(steps: i32) -> Self;
    /// `kappa = tan²(alpha) eta`, the strength of the centrifugal force.
    fn kappa(tangent: Self, eta: Self) -> Self {
        tangent * tangent * eta
    }

    /// The number type in which a table is read: this one, unless it is too coarse for that.
    type Precise: Real;
    /// The same value in that type.
    fn to_precise(self) -> Self::Precise;
    /// The nearest value of this type.
    fn from_precise(precise: Self::Precise) -> Self;
}

/// The step of the numbers in a quantised table, 2^−28.
pub(crate) const QUANTISATION_STEP: f64 = 1.0 / 268_435_456.0;

/// By Halley's rule from a first guess in the bits; `libm`'s takes an `f64`, which a unit for `f32` has not.
fn cube_root(x: f32) -> f32 {
    if !(x > 0.0 && x.is_finite()) {
        return if x == 0.0 { 0.0 } else { f32::NAN };
    }
    let guess = f32::from_bits(x.to_bits() / 3 + 0x2A51_19F2);
    (0..2).fold(guess, |y, _| {
        let q = y * y * y / x;
        y + y * ((1.0 - q) / (1.0 + (q + q)))
    })
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
    #[inline]
    fn sqrt(self) -> Self {
        square_root::sqrtf(self)
    }
    fn cbrt(self) -> Self {
        cube_root(self)
    }
    fn ln_1p(self) -> Self {
        libm::log1pf(self)
    }
    fn from_quantised(steps: i32) -> Self {
        steps as f32 * QUANTISATION_STEP as f32
    }
    type Precise = Self;
    #[inline]
    fn to_precise(self) -> Self {
        self
    }
    #[inline]
    fn from_precise(precise: Self) -> Self {
        precise
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
    #[inline]
    fn sqrt(self) -> Self {
        square_root::sqrt(self)
    }
    fn cbrt(self) -> Self {
        libm::cbrt(self)
    }
    fn ln_1p(self) -> Self {
        libm::log1p(self)
    }
    fn from_quantised(steps: i32) -> Self {
        f64::from(steps) * QUANTISATION_STEP
    }
    type Precise = Self;
    #[inline]
    fn to_precise(self) -> Self {
        self
    }
    #[inline]
    fn from_precise(precise: Self) -> Self {
        precise
    }
}

#[cfg(test)]
mod tests {
    use crate::read::real::Real;

    #[test]
    fn cube_roots_are_within_one_unit_in_the_last_place() {
        for k in 0..200_000 {
            let x = libm::exp2(-125.0 + 252.0 / 200_000.0 * f64::from(k)) as f32;
            let (root, exact) = (f64::from(Real::cbrt(x)), libm::cbrt(f64::from(x)));
            assert!((root / exact - 1.0).abs() < 1.2e-7, "{x}: {root}");
        }
        assert_eq!(
            (Real::cbrt(0.0_f32), Real::cbrt(1.0_f32), Real::cbrt(27.0_f32)),
            (0.0, 1.0, 3.0)
        );
    }
}
