//! How do fixed-point numbers read a table? Implements [`Real`] for them; reads floats as bits, writes fixed-point numbers.

use super::integer;
use super::number::{I16F16, I32F32};
use crate::read::real::Real;

macro_rules! real {
    ($name:ident, $precise:ident, $to_precise:expr, $from_precise:expr, $from_steps:expr) => {
        impl Real for $name {
            type Precise = $precise;

            #[inline]
            fn from_f32(value: f32) -> Self {
                Self::from_wide(integer::from_float(
                    value.to_bits() as u64,
                    23,
                    127,
                    Self::FRACTION,
                ))
            }
            #[inline]
            fn from_f64(value: f64) -> Self {
                Self::from_wide(integer::from_float(value.to_bits(), 52, 1023, Self::FRACTION))
            }
            fn to_f64(self) -> f64 {
                if !self.is_number() {
                    return f64::NAN;
                }
                f64::from_bits(integer::to_float(self.0.into(), Self::FRACTION))
            }
            #[inline]
            fn from_quantised(steps: i32) -> Self {
                $from_steps(steps)
            }
            fn sqrt(self) -> Self {
                if self.0 < 0 {
                    return Self::NAN;
                }
                let bits = u128::from(self.0.unsigned_abs()) << Self::FRACTION;
                Self::from_wide(i64::try_from(integer::rounded_sqrt(bits)).ok())
            }
            fn cbrt(self) -> Self {
                if self.0 < 0 {
                    return Self::NAN;
                }
                let bits = u128::from(self.0.unsigned_abs()) << (2 * Self::FRACTION);
                Self::from_wide(Some(integer::rounded_cbrt(bits)))
            }
            fn ln_1p(self) -> Self {
                if self.0 < 0 {
                    return Self::NAN;
                }
                Self::from_wide(Some(integer::ln_1p(self.0.into(), Self::FRACTION)))
            }
            /// The square of a large tangent does not fit; this order does.
            fn kappa(tangent: Self, eta: Self) -> Self {
                tangent * (tangent * eta)
            }
            #[inline]
            fn to_precise(self) -> $precise {
                $to_precise(self)
            }
            #[inline]
            fn from_precise(precise: $precise) -> Self {
                $from_precise(precise)
            }
        }
    };
}

real!(I32F32, I32F32, |x| x, |x| x, |q| I32F32(i64::from(q) << 4));
real!(
    I16F16,
    I32F32,
    |x: I16F16| if x.is_number() { I32F32(i64::from(x.0) << 16) } else { I32F32::NAN },
    narrowed,
    |q: i32| I16F16(q.saturating_add(1 << 11) >> 12)
);

/// The nearest `I16F16`, halves away from zero.
fn narrowed(x: I32F32) -> I16F16 {
    let half = (1 << 15) + (x.0 >> 63);
    I16F16::from_wide(x.0.checked_add(half).filter(|_| x.is_number()).map(|bits| bits >> 16))
}
