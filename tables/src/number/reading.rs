//! How do fixed-point numbers read a table? The operations of [`Real`]; floats are taken apart as bits.

use super::{I16F16, I32F32, Real, integer};

macro_rules! real {
    ($name:ident, $precise:ident, $precise_of:expr, $rounded:expr, $quanta:expr) => {
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
            fn from_quanta(quanta: i32) -> Self {
                $quanta(quanta)
            }
            fn sqrt(self) -> Self {
                if self.0 < 0 {
                    return Self::NAN;
                }
                let bits = u128::from(self.0.unsigned_abs()) << Self::FRACTION;
                Self::from_wide(i64::try_from(integer::root(bits)).ok())
            }
            fn cbrt(self) -> Self {
                if self.0 < 0 {
                    return Self::NAN;
                }
                let bits = u128::from(self.0.unsigned_abs()) << (2 * Self::FRACTION);
                Self::from_wide(Some(integer::cube_root(bits)))
            }
            fn ln_1p(self) -> Self {
                if self.0 < 0 {
                    return Self::NAN;
                }
                Self::from_wide(Some(integer::logarithm(self.0.into(), Self::FRACTION)))
            }
            /// The square of a large tangent does not fit; this order does.
            fn push(tangent: Self, eta: Self) -> Self {
                tangent * (tangent * eta)
            }
            #[inline]
            fn precise(self) -> $precise {
                $precise_of(self)
            }
            #[inline]
            fn rounded(precise: $precise) -> Self {
                $rounded(precise)
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
