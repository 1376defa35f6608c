//! How do f32 and f64 count? The engine's operations on the two floating-point types.

use super::instant::{Instant, TimeSpan};
use super::lanes::Each;
use super::traits::{
    Comparison, Elementary, Power, Products, Range, Rounding, Scalar, Timekeeping, Vector,
    WideProduct, sealed::Sealed,
};
use super::trigonometry;
use carom_tables::read::Real;

/// Directions are taken of this part of r. Positions lie on a lattice, so r·r often lies halfway between two
/// numbers, and beside a power of two the rule for such ties (to the even one) rounds one way. That of 0.83 r does
/// not: 0.83 has no short binary pattern, as 0.7 or 0.9 have, with which products are rounded one way again (0.07
/// units in the last place were measured).
const PART: f64 = 0.83;

const TICKS_PER_UNIT: f64 = 18_446_744_073_709_551_616.0;

/// One step towards x^(−1/5), of third order: y ← y (1 + r/5 + 3 r²/25) with r = 1 − x y⁵.
///
/// Only + − · are used, so every target gives the same bits.
fn refine<S: Scalar>(x: S, y: S) -> S {
    let y2 = y * y;
    let r = S::one() - x * (y2 * y2 * y);
    y + y * (r * (S::from_f64(0.2) + S::from_f64(0.12) * r))
}

/// A first guess of x^(−1/5) for x in [1/2, 16), good to a few per cent: two chords.
fn guess<S: Scalar>(x: S) -> S {
    if x < S::from_f32(3.0) {
        S::from_f32(1.2) - S::from_f32(0.14) * x
    } else {
        S::from_f32(0.83) - S::from_f32(0.018) * x
    }
}

/// A float above zero as a whole number and the power of two that it counts.
macro_rules! parts {
    ($x:expr, $bits:ty, $mantissa:expr, $t:ty) => {{
        let bits = $x.to_bits();
        let exponent = (bits >> $mantissa) & (<$bits>::MAX >> ($mantissa + 1));
        let mantissa = bits & ((1 << $mantissa) - 1) | (1 << $mantissa);
        (mantissa, exponent as i32 - (<$t>::MAX_EXP - 1) - $mantissa)
    }};
}

/// x/|u|: by the rounded length, and by u·u over it; what rounding made one too large it made the other too small.
/// What the length is wrong by enters squared.
macro_rules! over_length {
    ($x:expr, $u:expr, $length:expr) => {{
        let (u, length) = ($u, $length);
        ($x / length + $x * length / u.dot(&u)) * 0.5
    }};
}

macro_rules! float {
    ($t:ty, $lanes:ty, $bits:ty, $sincos:path, $floor:path, $frexp:path, $ldexp:path, $mantissa:expr, $per_epoch:expr) => {
        impl Sealed for $t {}

        impl WideProduct<$t> for $t {
            #[inline]
            fn rounded(self) -> $t {
                self
            }
            #[inline]
            fn sqrt(self) -> $t {
                Real::sqrt(self)
            }
            #[inline]
            fn divided_by(self, divisor: $t) -> $t {
                self / divisor
            }
        }

        impl Comparison for $t {}

        impl Range for $t {
            fn is_finite(self) -> bool {
                <$t>::is_finite(self)
            }
            fn has_square(self) -> bool {
                // A factor is left for sums over the axes, and for the least that a difference can be.
                let square = self * self;
                square <= <$t>::MAX / 256.0 && square * <$t>::EPSILON >= <$t>::MIN_POSITIVE
            }
        }

        impl Rounding for $t {
            const RESOLUTION: Self = <$t>::EPSILON;

            fn leading_digits(self) -> Self {
                <$t>::from_bits(self.to_bits() & !(((1 as $bits) << ($mantissa - 11)) - 1))
            }
            fn lattice(size: Self) -> Self {
                // Between 4 p and 8 p, p the leading binary digit, the last place is four of those at p.
                <$t>::from_bits(size.to_bits() & !(((1 as $bits) << $mantissa) - 1)) * 6.0
            }
        }

        impl TimeSpan for $t {
            fn to_ticks(self) -> i128 {
                // As (self · 2⁶⁴) as i128, which without a unit for f64 is much dearer.
                let (mantissa, exponent) = parts!(self, $bits, $mantissa, $t);
                let shift = exponent + 64;
                let size = match shift {
                    0.. if self.is_nan() => 0,
                    0.. if shift + $mantissa >= 127 => i128::MAX,
                    0.. => i128::from(mantissa) << shift,
                    _ => i128::from(mantissa.checked_shr(-shift as u32).unwrap_or(0)),
                };
                if self < 0.0 { -size } else { size }
            }
            fn from_ticks(ticks: i128) -> Self {
                ticks as $t * (1.0 / TICKS_PER_UNIT) as $t
            }
            fn next_below(self) -> Self {
                self - Comparison::abs(self) * Self::RESOLUTION
            }
        }

        impl Timekeeping for $t {
            // Finite, so that it survives every serialisation format.
            const NEVER: Self = <$t>::MAX;
            // 2⁶² units, well before the last instant.
            const LAST: Self = 4_611_686_018_427_387_904.0;
            const EVENTS_PER_EPOCH: u32 = $per_epoch;

            fn phase(turn: Self, frequency: Self, span: Self) -> Self {
                let turns = turn + frequency * span;
                turns - Elementary::floor(turns)
            }
            fn phase_at(start: Self, frequency: Self, at: Instant) -> Self {
                let (mantissa, exponent) = parts!(frequency, $bits, $mantissa, $t);
                let turns = at.turns(i128::from(mantissa), exponent);
                Self::from_ticks(i128::from(turns.wrapping_add(start.to_ticks() as u64)))
            }
        }

        impl Elementary for $t {
            fn sin_cos(self) -> (Self, Self) {
                $sincos(self)
            }
            fn floor(self) -> Self {
                $floor(self)
            }
            fn inverse_fifth_root(self) -> Self {
                if self <= 0.0 || !self.is_finite() {
                    return if self > 0.0 { 0.0 } else { <$t>::INFINITY };
                }
                let (mantissa, exponent) = $frexp(self);
                let rest = $ldexp(mantissa, exponent.rem_euclid(5));
                let root = (0..4).fold(guess(rest), |y, _| refine(rest, y));
                $ldexp(root, -exponent.div_euclid(5))
            }
        }

        impl Products for $t {
            type Product = Self;

            #[inline]
            fn times(self, other: Self) -> Self {
                self * other
            }
            #[inline]
            fn dot<const D: usize>(a: &Vector<Self, D>, b: &Vector<Self, D>) -> Self {
                a.dot(b)
            }
            #[inline]
            fn component<const D: usize>(
                r: &Vector<Self, D>,
                v: &Vector<Self, D>,
                length: Self,
            ) -> Self {
                let part = PART as $t;
                over_length!(r.dot(v) * part, r * part, length * part)
            }
            #[inline]
            fn along<const D: usize>(
                r: &Vector<Self, D>,
                x: Self,
                length: Self,
            ) -> Vector<Self, D> {
                let part = PART as $t;
                let u = r * part;
                u * over_length!(x, u, length * part)
            }
            fn is_negligible<const D: usize>(part: &Vector<Self, D>, of: &Vector<Self, D>) -> bool {
                part.dot(part) <= of.dot(of) * Self::from_f32(1e-4)
            }
        }

        impl Scalar for $t {
            const ZERO: Self = 0.0;
            type Lanes = $lanes;

            fn bits(self) -> u64 {
                u64::from(self.to_bits())
            }
            #[allow(clippy::cast_lossless, reason = "for one of the two it is not")]
            fn from_count(count: u32) -> Self {
                count as Self
            }
            fn to_count(self) -> u32 {
                // A cast from float saturates, and NaN gives 0.
                self as u32
            }
        }
    };
}

float!(f32, Each<f32>, u32, trigonometry::sin_cos, libm::floorf, libm::frexpf, libm::ldexpf, 23, 4);
#[cfg(target_arch = "x86_64")]
type Doubles = wide::f64x2;
#[cfg(not(target_arch = "x86_64"))]
type Doubles = Each<f64>;

float!(f64, Doubles, u64, libm::sincos, libm::floor, libm::frexp, libm::ldexp, 52, 64);

impl Power for f32 {
    fn power(self, exponent: Self) -> Self {
        libm::powf(self.max(0.0), exponent)
    }
}

impl Power for f64 {
    fn power(self, exponent: Self) -> Self {
        libm::pow(self.max(0.0), exponent)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inverse_fifth_root_is_within_two_units_in_the_last_place() {
        for i in 0..20_000 {
            let x = libm::pow(10.0, -300.0 + 0.03 * f64::from(i));
            let y = x.inverse_fifth_root();
            let back = y * y * y * y * y * x;
            assert!((back - 1.0).abs() < 5e-15, "{x}: {back}");
        }
    }

    proptest::proptest! {
        /// The cast is the definition; it, too, cuts off and saturates.
        #[test]
        fn ticks_are_those_of_the_cast(bits: u64) {
            let (x, y) = (f64::from_bits(bits), f32::from_bits(bits as u32));
            let cast = |x: f64| ((x * TICKS_PER_UNIT) as i128).max(-i128::MAX);
            proptest::prop_assert_eq!(x.to_ticks(), cast(x));
            proptest::prop_assert_eq!(y.to_ticks(), cast(f64::from(y)));
        }

        #[test]
        fn ticks_of_plain_spans_are_those_of_the_cast(x in -1e6_f64..1e6) {
            let cast = |x: f64| (x * TICKS_PER_UNIT) as i128;
            proptest::prop_assert_eq!(x.to_ticks(), cast(x));
            proptest::prop_assert_eq!((x as f32).to_ticks(), cast(f64::from(x as f32)));
        }
    }

    #[test]
    fn leading_digits_are_twelve() {
        assert_eq!(4097.0_f32.leading_digits(), 4096.0);
        assert_eq!(4095.5_f64.leading_digits(), 4095.0);
        assert_eq!(0.75_f64.leading_digits(), 0.75);
    }
}
