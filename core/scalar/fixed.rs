//! How do I32F32 and I16F16 count? The engine's operations on fixed-point numbers; no float is used.
//!
//! Positions and velocities may be as large as an eighth of the type's range ([`Range::RANGE`]). Then no
//! sum of products that the engine forms can overflow before a grain is looked at again
//! ([`Range::time_in_range`]), and every overflow is seen: it is not a number, and ends in an error.

use super::instant::{Instant, TimeSpan};
use super::lanes::Each;
use super::traits::{
    Comparison, Elementary, Products, Range, Rounding, Scalar, Timekeeping, Vector, WideProduct,
    sealed::Sealed,
};
use carom_tables::fixed_point::{I16F16, I32F32, Product as Exact, integer};

macro_rules! scalar {
    ($t:ident, $word:ident, $wide:ident) => {
        impl Sealed for $t {}

        impl WideProduct<$t> for Exact<$wide> {
            #[inline]
            fn rounded(self) -> $t {
                self.rounded()
            }
            fn sqrt(self) -> $t {
                self.root()
            }
            fn divided_by(self, divisor: $t) -> $t {
                self.over(divisor)
            }
        }

        impl Comparison for $t {}

        impl Range for $t {
            const RANGE: Option<Self> = Some(Self::from_bits(1 << ($word::BITS - 4)));

            fn is_finite(self) -> bool {
                self.is_number()
            }
            fn in_range(self) -> bool {
                Self::RANGE.is_some_and(|most| Comparison::abs(self) <= most)
            }
            fn time_in_range(speed: Self, acceleration: Self) -> Option<Self> {
                let [v, a] = [speed, acceleration]
                    .map(|x| i64::from($word::BITS - x.to_bits().leading_zeros()));
                if v == 0 && a == 0 {
                    return None;
                }
                // Within 2^far steps each of v t and a t²/2 is at most a sixteenth of the range.
                let (fraction, far) = (i64::from(Self::FRACTION), i64::from($word::BITS - 5));
                let by_speed = if v == 0 { far } else { far + fraction - v };
                let by_fall = if a == 0 { far } else { (far + fraction - a) / 2 + fraction / 2 };
                let bits = by_speed.min(by_fall).clamp(0, i64::from($word::BITS) - 3);
                Some(Self::from_bits(1 << bits))
            }
        }

        impl Rounding for $t {
            const RESOLUTION: Self = Self::DELTA;

            fn rounding(self) -> Self {
                Self::DELTA
            }
            fn leading_digits(self) -> Self {
                self
            }
            fn lattice(_: Self) -> Self {
                Self::default()
            }
            fn min_step(_: Self, bound: Self) -> Self {
                Comparison::max(Self::DELTA.root_of_ratio(bound + bound), Self::DELTA)
            }
            fn negligible_acceleration(_: Self) -> Self {
                Self::DELTA
            }
        }

        impl TimeSpan for $t {
            fn to_ticks(self) -> i128 {
                i128::from(if self.is_number() { self.to_bits() } else { 0 })
                    << (64 - Self::FRACTION)
            }
            fn from_ticks(ticks: i128) -> Self {
                let shift = 64 - Self::FRACTION;
                let most = i128::from($word::MAX);
                let nearest = (ticks.saturating_add(1 << (shift - 1)) >> shift).clamp(-most, most);
                Self::from_wide(i64::try_from(nearest).ok())
            }
            fn next_below(self) -> Self {
                self - Self::DELTA
            }
        }

        impl Timekeeping for $t {
            const NEVER: Self = Self::MAX;
            const LAST: Self = Self::MAX;
            // A quarter of the range: the same again and an eighth fit before NEVER.
            const LATE: Self = Self::from_bits(1 << ($word::BITS - 3));
            // Times are exact however late it is: only the range asks for a new epoch.
            const EVENTS_PER_EPOCH: u32 = u32::MAX;

            fn phase(turn: Self, frequency: Self, span: Self) -> Self {
                let turns = frequency.times(span).bits().map(|bits| bits >> Self::FRACTION);
                Self::fraction(turns, turn)
            }
            fn phase_at(start: Self, frequency: Self, at: Instant) -> Self {
                // Whole turns are lost to the left, and the fraction is exact.
                let turns = at.ticks().wrapping_mul(i128::from(frequency.to_bits())) >> 64;
                Self::fraction(Some(turns), start)
            }
        }

        impl Elementary for $t {
            fn sin_cos(self) -> (Self, Self) {
                self.sin_cos()
            }
            fn floor(self) -> Self {
                self.floor()
            }
            fn inverse_fifth_root(self) -> Self {
                Self::inverse_fifth_root([self])
            }
            fn sqrt_of_ratio(self, other: Self) -> Self {
                self.root_of_ratio(other)
            }
            fn viscoelastic_time(k: Self, v: Self) -> Self {
                Self::inverse_fifth_root([k, k, v])
            }
        }

        impl Products for $t {
            type Product = Exact<$wide>;

            #[inline]
            fn times(self, other: Self) -> Self::Product {
                self.times(other)
            }
            #[inline]
            fn dot<const D: usize>(a: &Vector<Self, D>, b: &Vector<Self, D>) -> Self::Product {
                let products = a.iter().zip(b.iter()).map(|(x, y)| x.times(*y));
                products.reduce(|x, y| x + y).unwrap_or_default()
            }
            // These numbers lie equally dense everywhere: no length is always rounded one way.
            fn component<const D: usize>(
                r: &Vector<Self, D>,
                v: &Vector<Self, D>,
                length: Self,
            ) -> Self {
                <Self as Products>::dot(r, v).divided_by(length)
            }
            fn along<const D: usize>(
                r: &Vector<Self, D>,
                x: Self,
                length: Self,
            ) -> Vector<Self, D> {
                r / length * x
            }
            fn is_negligible<const D: usize>(part: &Vector<Self, D>, of: &Vector<Self, D>) -> bool {
                let square = |v| <Self as Products>::dot(v, v).bits();
                let part = square(part).and_then(|p| p.checked_mul(10_000));
                part.zip(square(of)).is_some_and(|(part, of)| part <= of)
            }
            fn collision_time<const D: usize>(
                r: &Vector<Self, D>,
                v: &Vector<Self, D>,
                sigma: Self,
            ) -> Option<Option<Self>> {
                let squares = [
                    -<Self as Products>::dot(r, v),
                    <Self as Products>::dot(r, r) - sigma.times(sigma),
                    <Self as Products>::dot(v, v),
                ];
                let time = collision_time(squares.map(|p| p.bits()), Self::FRACTION);
                Some(Self::from_wide(time).finite())
            }
        }

        impl Scalar for $t {
            const ZERO: Self = Self::from_bits(0);
            type Lanes = Each<Self>;

            fn bits(self) -> u64 {
                i64::from(self.to_bits()) as u64
            }
            fn from_count(count: u32) -> Self {
                Self::from_whole(count)
            }
            fn to_count(self) -> u32 {
                self.to_whole()
            }
        }

        impl Fraction for $t {
            fn fraction(steps: Option<i128>, start: Self) -> Self {
                let turns = steps.map(|steps| steps + i128::from(start.to_bits()));
                let part = turns.map(|turns| turns & ((1 << Self::FRACTION) - 1));
                Self::from_wide(part.and_then(|part| i64::try_from(part).ok()))
            }
            fn finite(self) -> Option<Self> {
                self.is_number().then_some(self)
            }
        }
    };
}

/// What both types need for phases and events.
trait Fraction: Sized {
    /// What is left of a number of steps, after a start, without whole ones.
    fn fraction(steps: Option<i128>, start: Self) -> Self;
    /// The number, if it is one.
    fn finite(self) -> Option<Self>;
}

scalar!(I32F32, i64, i128);
scalar!(I16F16, i32, i64);

/// BSFP14's rule for two spheres, from −r·v, r² − σ² and v² as they are: the discriminant is exact, so
/// whether they meet is decided without rounding, and when to half a step of time.
fn collision_time([approach, gap, speed2]: [Option<i128>; 3], fraction: u32) -> Option<i64> {
    let (approach, gap) = (u128::try_from(approach?).ok()?, gap?);
    if approach == 0 {
        return None;
    }
    let Ok(gap) = u128::try_from(gap) else { return Some(0) };
    if gap == 0 {
        return Some(0);
    }
    let speed2 = u128::try_from(speed2?).ok()?;
    let root = integer::root_of_difference(approach, speed2, gap)?;
    integer::quotient(gap, approach.checked_add(root)?, fraction)
}
