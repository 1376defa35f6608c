//! What is a product of fixed-point numbers before it is rounded? Twice as many bits; reads and writes bits.

use core::cmp::Ordering;
use core::ops::{Add, Neg, Sub};

use super::{I16F16, I32F32, integer};

/// An exact product of two fixed-point numbers, or a sum of such: twice as many bits, and not-a-number.
#[derive(Clone, Copy, Default)]
pub struct Product<W>(pub(super) W);

macro_rules! product {
    ($name:ident, $word:ident, $wide:ident, $fraction:literal) => {
        impl Product<$wide> {
            /// Not a number.
            pub const NAN: Self = Self($wide::MIN);

            /// Whether it is a number.
            #[must_use]
            pub const fn is_number(self) -> bool {
                self.0 != $wide::MIN
            }

            /// How many steps of 2^−2 FRACTION it is; none for not-a-number.
            #[must_use]
            pub fn bits(self) -> Option<i128> {
                self.is_number().then(|| self.0.into())
            }

            /// The nearest single number.
            #[inline]
            #[must_use]
            pub fn rounded(self) -> $name {
                if !self.is_number() {
                    return $name::NAN;
                }
                // Halves away from zero: negation and rounding can be swapped.
                let half = (1 << ($fraction - 1)) + (self.0 >> ($wide::BITS - 1));
                $name::or_nan(
                    self.0.checked_add(half).and_then(|p| $word::try_from(p >> $fraction).ok()),
                )
            }

            /// The nearest number to the square root.
            #[must_use]
            pub fn root(self) -> $name {
                let Ok(bits) = u128::try_from(self.0) else { return $name::NAN };
                $name::from_wide(i64::try_from(integer::root(bits)).ok())
            }

            /// Divided by a number, rounded once; what is not zero does not become zero: who approaches,
            /// however slowly, approaches at some speed.
            #[must_use]
            pub fn over(self, divisor: $name) -> $name {
                if !(self.is_number() && divisor.is_number()) {
                    return $name::NAN;
                }
                let (n, d) = (i128::from(self.0).unsigned_abs(), divisor.0.unsigned_abs());
                let q = integer::quotient(n, d.into(), 0).map(|q| q.max(i64::from(n != 0)));
                $name::from_wide(if (self.0 < 0) == (divisor.0 < 0) { q } else { q.map(|q| -q) })
            }
        }

        impl Add for Product<$wide> {
            type Output = Self;
            #[inline]
            fn add(self, other: Self) -> Self {
                if !(self.is_number() && other.is_number()) {
                    return Self::NAN;
                }
                self.0.checked_add(other.0).map_or(Self::NAN, Self)
            }
        }

        impl Neg for Product<$wide> {
            type Output = Self;
            #[inline]
            fn neg(self) -> Self {
                // The only one that negation leaves as it is is not a number.
                Self(self.0.wrapping_neg())
            }
        }

        impl Sub for Product<$wide> {
            type Output = Self;
            #[inline]
            fn sub(self, other: Self) -> Self {
                self + -other
            }
        }

        impl PartialEq for Product<$wide> {
            #[inline]
            fn eq(&self, other: &Self) -> bool {
                self.0 == other.0 && self.is_number()
            }
        }

        impl PartialOrd for Product<$wide> {
            #[inline]
            fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
                (self.is_number() && other.is_number()).then(|| self.0.cmp(&other.0))
            }
        }
    };
}

product!(I32F32, i64, i128, 32);
product!(I16F16, i32, i64, 16);
