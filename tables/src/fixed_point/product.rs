//! What is a product of fixed-point numbers before it is rounded? Reads and writes integers of twice as many bits.

use core::cmp::Ordering;
use core::ops::{Add, Neg, Sub};

/// An exact product of two fixed-point numbers, or a sum of such products.
///
/// `W` is the integer with twice as many bits: `i128` for `I32F32`, `i64` for `I16F16`. Its least
/// value is not-a-number.
#[derive(Clone, Copy, Default)]
pub struct Product<W>(pub(super) W);

macro_rules! product {
    ($wide:ident) => {
        impl Product<$wide> {
            /// Not a number.
            pub(super) const NAN: Self = Self($wide::MIN);

            /// Whether it is a number.
            pub(super) const fn is_number(self) -> bool {
                self.0 != $wide::MIN
            }

            /// The number of steps of 2^(−2 FRACTION); `None` for not-a-number.
            #[must_use]
            pub fn bits(self) -> Option<i128> {
                self.is_number().then(|| self.0.into())
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

product!(i128);
product!(i64);
