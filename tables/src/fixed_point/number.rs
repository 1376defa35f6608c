//! How do fixed-point numbers calculate? `I32F32` and `I16F16`, with overflow to not-a-number; reads and writes bits, no float is used.
//!
//! The formats are those of the package `fixed`; what is added is that nothing ever wraps or saturates:
//! one pattern of bits, the least, is *not a number*. Every overflow, division by zero and root of a
//! negative number gives it, every operation on it gives it again, and no comparison with it is true.
//! That is how NaN behaves, so code that is safe with NaN is safe with overflow.
//!
//! Products are exact: [`I32F32::times`] keeps all bits in a [`Product`], which can be summed, compared,
//! divided and rooted before anything is rounded.

use core::cmp::Ordering;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use super::integer;
use super::product::Product;

macro_rules! fixed {
    ($name:ident, $word:ident, $wide:ident, $fraction:literal, $about:literal) => {
        #[doc = $about]
        ///
        /// Sums and differences are exact; products, quotients and square roots are the nearest value
        /// (halves away from zero). The least pattern of bits is not a number.
        #[derive(Clone, Copy, Default)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "serde", serde(transparent))]
        pub struct $name(pub(super) $word);

        impl $name {
            /// Bits after the point.
            pub const FRACTION: u32 = $fraction;
            /// Not-a-number: the result of overflow, of division by zero and of the root of a negative number.
            pub const NAN: Self = Self($word::MIN);
            /// The largest number.
            pub const MAX: Self = Self($word::MAX);
            /// The distance between neighbouring numbers, 2^−FRACTION, as in the package `fixed`.
            pub const DELTA: Self = Self(1);
            /// One.
            pub(super) const ONE: Self = Self(1 << $fraction);

            /// The number with this many steps of 2^−FRACTION.
            #[must_use]
            pub const fn from_bits(bits: $word) -> Self {
                Self(bits)
            }

            /// The number of steps of 2^−FRACTION.
            #[must_use]
            pub const fn to_bits(self) -> $word {
                self.0
            }

            /// Whether it is a number, that is, not [`NAN`](Self::NAN).
            #[must_use]
            pub const fn is_number(self) -> bool {
                self.0 != $word::MIN
            }

            pub(super) const fn or_nan(bits: Option<$word>) -> Self {
                match bits {
                    Some(bits) => Self(bits),
                    None => Self::NAN,
                }
            }

            /// The number with this many steps; not-a-number for `None` or if there are too many.
            #[must_use]
            pub fn from_wide(bits: Option<i64>) -> Self {
                Self::or_nan(bits.and_then(|bits| $word::try_from(bits).ok()))
            }

            /// The exact product, before it is rounded.
            #[inline]
            #[must_use]
            pub fn times(self, other: Self) -> Product<$wide> {
                if self.is_number() && other.is_number() {
                    Product($wide::from(self.0) * $wide::from(other.0))
                } else {
                    Product($wide::MIN)
                }
            }

            /// Sine and cosine of an angle in radians: the nearest values but for ties within 2⁻⁵⁶.
            #[must_use]
            pub fn sin_cos(self) -> (Self, Self) {
                if !self.is_number() {
                    return (Self::NAN, Self::NAN);
                }
                let (sine, cosine) = integer::sin_cos(self.0.into(), $fraction);
                (Self(sine as $word), Self(cosine as $word))
            }

            /// (x₁ x₂ …)^(−1/5) of numbers above zero, whose product may be far out of range.
            #[must_use]
            pub fn inverse_fifth_root<const N: usize>(factors: [Self; N]) -> Self {
                Self::from_wide(integer::inverse_fifth_root(
                    &factors.map(|x| x.0.into()),
                    $fraction,
                ))
            }

            /// √(self/other), rounded once; not-a-number unless self ≥ 0 and other > 0.
            #[must_use]
            pub fn root_of_ratio(self, other: Self) -> Self {
                if !(self.0 >= 0 && other.0 > 0) {
                    return Self::NAN;
                }
                // With 2 FRACTION bits after the point the quotient fits into 4 FRACTION bits.
                let n = u128::from(self.0.unsigned_abs()) << (2 * $fraction);
                let root = integer::rounded_sqrt(n / u128::from(other.0.unsigned_abs()));
                Self::from_wide(i64::try_from(root).ok())
            }

            /// The largest whole number not above this one.
            #[must_use]
            pub fn floor(self) -> Self {
                if self.is_number() { Self(self.0 >> $fraction << $fraction) } else { self }
            }

            /// The whole number `whole`; not-a-number if it is too large.
            #[must_use]
            pub fn from_whole(whole: u32) -> Self {
                Self::from_wide(Some(i64::from(whole) << $fraction))
            }

            /// The whole part of a number, 0 below zero and for not-a-number.
            #[must_use]
            pub fn to_whole(self) -> u32 {
                (self.0.max(0) >> $fraction) as u32
            }
        }

        impl Product<$wide> {
            /// The nearest number; not-a-number if it is too large.
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

            /// The number nearest to the square root; not-a-number below zero.
            #[must_use]
            pub fn root(self) -> $name {
                let Ok(bits) = u128::try_from(self.0) else { return $name::NAN };
                $name::from_wide(i64::try_from(integer::rounded_sqrt(bits)).ok())
            }

            /// Divided by a number, rounded once. What is not zero does not become zero: spheres that
            /// approach, however slowly, approach at some speed.
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

        impl Add for $name {
            type Output = Self;
            #[inline]
            fn add(self, other: Self) -> Self {
                if !(self.is_number() && other.is_number()) {
                    return Self::NAN;
                }
                Self::or_nan(self.0.checked_add(other.0))
            }
        }

        impl Neg for $name {
            type Output = Self;
            #[inline]
            fn neg(self) -> Self {
                // The only one that negation leaves as it is is not a number.
                Self(self.0.wrapping_neg())
            }
        }

        impl Sub for $name {
            type Output = Self;
            #[inline]
            fn sub(self, other: Self) -> Self {
                self + -other
            }
        }

        impl Mul for $name {
            type Output = Self;
            #[inline]
            fn mul(self, other: Self) -> Self {
                self.times(other).rounded()
            }
        }

        impl Div for $name {
            type Output = Self;
            fn div(self, other: Self) -> Self {
                if !(self.is_number() && other.is_number()) {
                    return Self::NAN;
                }
                let (n, d) = (self.0.unsigned_abs(), other.0.unsigned_abs());
                let q = integer::quotient(n.into(), d.into(), $fraction);
                Self::from_wide(if (self.0 < 0) == (other.0 < 0) { q } else { q.map(|q| -q) })
            }
        }

        impl AddAssign for $name {
            #[inline]
            fn add_assign(&mut self, other: Self) {
                *self = *self + other;
            }
        }

        impl SubAssign for $name {
            #[inline]
            fn sub_assign(&mut self, other: Self) {
                *self = *self - other;
            }
        }

        impl MulAssign for $name {
            #[inline]
            fn mul_assign(&mut self, other: Self) {
                *self = *self * other;
            }
        }

        impl DivAssign for $name {
            fn div_assign(&mut self, other: Self) {
                *self = *self / other;
            }
        }

        impl PartialEq for $name {
            #[inline]
            fn eq(&self, other: &Self) -> bool {
                self.0 == other.0 && self.is_number()
            }
        }

        impl PartialOrd for $name {
            #[inline]
            fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
                (self.is_number() && other.is_number()).then(|| self.0.cmp(&other.0))
            }
        }
    };
}

fixed!(
    I32F32,
    i64,
    i128,
    32,
    "A signed fixed-point number with 32 bits before and 32 after the point: ±2.1·10⁹ in steps of 2.3·10⁻¹⁰."
);
fixed!(
    I16F16,
    i32,
    i64,
    16,
    "A signed fixed-point number with 16 bits before and 16 after the point: ±32767 in steps of 1.5·10⁻⁵."
);
