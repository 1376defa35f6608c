//! What must a number be able to do? The engine's operations, in small traits; reads and writes nothing.
//!
//! Squares and other products have a type of their own, [`WideProduct`]: the sums, differences, roots and
//! quotients in which a fixed-point number would overflow or lose its last places are taken from it.

use super::instant::{Instant, TimeSpan};
use super::lanes::Lanes;
use carom_tables::read::Real;
use core::fmt::{Debug, Display};
use core::ops::{Add, AddAssign, MulAssign, Neg, Sub, SubAssign};

/// A vector of `D` components of `S`.
pub type Vector<S, const D: usize> = nalgebra::SVector<S, D>;

/// Only the crate's own numbers are scalars: their bits are what the digests promise.
pub(super) mod sealed {
    /// Implemented for the crate's own numbers.
    pub trait Sealed {}
}

/// A product of two numbers or a sum of such, before it is rounded.
///
/// For a float it is that float. For a fixed-point number it has twice as many bits and is exact.
pub trait WideProduct<S>:
    Copy + PartialOrd + Add<Output = Self> + Sub<Output = Self> + Neg<Output = Self>
{
    /// The nearest number.
    fn rounded(self) -> S;
    /// The square root.
    fn sqrt(self) -> S;
    /// Divided by a number.
    fn divided_by(self, divisor: S) -> S;
}

/// The largest, the smallest and the distance from zero.
pub trait Comparison: PartialOrd + Neg<Output = Self> + num_traits::Zero {
    /// The larger of two numbers; the first if either is not a number.
    #[must_use]
    fn max(self, other: Self) -> Self {
        if other > self { other } else { self }
    }
    /// The smaller of two numbers; the first if either is not a number.
    #[must_use]
    fn min(self, other: Self) -> Self {
        if other < self { other } else { self }
    }
    /// The distance from zero.
    #[must_use]
    fn abs(self) -> Self {
        if self < Self::zero() { -self } else { self }
    }
}

/// How large a number can become before it can no longer be computed with.
pub trait Range: Copy {
    /// The largest position and velocity, if a number can leave the range without being infinite.
    const RANGE: Option<Self> = None;

    /// Whether this can be computed with: neither NaN nor infinite, nor what overflow gave.
    fn is_finite(self) -> bool;
    /// Whether a position or velocity is within the range in which everything can be computed.
    fn in_range(self) -> bool {
        self.is_finite()
    }
    /// Whether the square of this, and what rounding leaves of it, are numbers again.
    fn has_square(self) -> bool {
        true
    }
    /// After which time a body of this speed and acceleration may have left the range; none if it cannot.
    #[must_use]
    fn time_in_range(_speed: Self, _acceleration: Self) -> Option<Self> {
        None
    }
}

/// How fine a number is.
pub trait Rounding: Real + num_traits::Zero + Comparison {
    /// The distance of neighbouring values near one.
    const RESOLUTION: Self;

    /// The distance to the neighbouring values, about.
    #[must_use]
    fn rounding(self) -> Self {
        self * Self::RESOLUTION
    }
    /// The number cut to its leading twelve binary digits: subtracting it is exact for everything up
    /// to 2¹² times as large.
    #[must_use]
    fn leading_digits(self) -> Self;
    /// The number that, added and taken away again, rounds to a lattice of four units in the last place
    /// of `size`; zero for numbers that are on one anyway. Sums and differences of such positions are
    /// exact, so a periodic box looks the same from each of its images.
    #[must_use]
    fn lattice(size: Self) -> Self;
    /// The smallest step of a search: an acceleration `bound` changes a distance of this size by less
    /// than its rounding meanwhile.
    #[must_use]
    fn min_step(size: Self, bound: Self) -> Self {
        (Self::RESOLUTION * Self::from_f32(0.5) * (size / bound)).sqrt()
    }
    /// An acceleration too weak to matter to something of this size.
    #[must_use]
    fn negligible_acceleration(size: Self) -> Self {
        Self::RESOLUTION * Self::RESOLUTION * size
    }
}

/// Which times can be told apart, and when clocks are set back.
pub trait Timekeeping: TimeSpan {
    /// A time that no event reaches.
    const NEVER: Self;
    /// No event is predicted for later than this.
    const LAST: Self;
    /// When it is later than this the clock is set back in any case.
    const LATE: Self = Self::NEVER;
    /// After how many events per grain the clock is set back, see [`crate::world::World`].
    const EVENTS_PER_EPOCH: u32;

    /// The phase in turns, without the whole ones, a time after it was `turn`.
    #[must_use]
    fn phase(turn: Self, frequency: Self, span: Self) -> Self;
    /// The phase in turns, without the whole ones, at an instant.
    #[must_use]
    fn phase_at(start: Self, frequency: Self, at: Instant) -> Self;
}

/// The elementary functions that the engine needs, each the same on every target.
pub trait Elementary: Real {
    /// Sine and cosine of an angle in radians; of an `f32` beyond ±6400, which is a thousand turns, NaN.
    fn sin_cos(self) -> (Self, Self);
    /// The largest whole number not above this one.
    #[must_use]
    fn floor(self) -> Self;
    /// x^(−1/5) for x > 0, the power in MP13's Eq. (53).
    #[must_use]
    fn inverse_fifth_root(self) -> Self;
    /// √(self/other).
    #[must_use]
    fn sqrt_of_ratio(self, other: Self) -> Self {
        (self / other).sqrt()
    }
    /// k^(−2/5) v^(−1/5): MP13's Eq. (53).
    #[must_use]
    fn viscoelastic_time(k: Self, v: Self) -> Self {
        k.inverse_fifth_root() * (k * v).inverse_fifth_root()
    }
}

/// Products that are not rounded, and what is decided by them.
pub trait Products: Real {
    /// The type of products.
    type Product: WideProduct<Self>;

    /// The product, not yet rounded.
    fn times(self, other: Self) -> Self::Product;
    /// The scalar product, not yet rounded.
    fn dot<const D: usize>(a: &Vector<Self, D>, b: &Vector<Self, D>) -> Self::Product;
    /// The component of v along r, (r·v)/|r|, with the sign of r·v; `length` is |r|, rounded.
    ///
    /// Without a trend: beside a power of two a square root is always rounded one way. Unit vectors made by it
    /// are too long on average, and the energy of an elastic gas would rise with every collision.
    fn component<const D: usize>(r: &Vector<Self, D>, v: &Vector<Self, D>, length: Self) -> Self;
    /// The vector of magnitude x along r; `length` is |r|, rounded. Without a trend, too.
    fn along<const D: usize>(r: &Vector<Self, D>, x: Self, length: Self) -> Vector<Self, D>;
    /// Whether a part of a vector is below a hundredth of it.
    fn is_negligible<const D: usize>(part: &Vector<Self, D>, of: &Vector<Self, D>) -> bool;
    /// When two spheres touch, if this type finds it in a way of its own, see `detect::root::spheres`.
    #[must_use]
    fn collision_time<const D: usize>(
        _: &Vector<Self, D>,
        _: &Vector<Self, D>,
        _: Self,
    ) -> Option<Option<Self>> {
        None
    }
}

/// A number the engine can count, measure and compare with: `f32`, `f64`, and the fixed-point numbers.
///
/// Sealed: each of them gives the same bits on every target, which a number from elsewhere cannot promise.
pub trait Scalar:
    sealed::Sealed
    + Comparison
    + Range
    + Rounding
    + Timekeeping
    + Elementary
    + Products
    + nalgebra::Scalar
    + nalgebra::ClosedAddAssign
    + nalgebra::ClosedSubAssign
    + nalgebra::ClosedMulAssign
    + nalgebra::ClosedDivAssign
    + num_traits::One
    + AddAssign
    + SubAssign
    + MulAssign
    + Default
    + Debug
    + Display
    + Send
    + Sync
    + 'static
{
    /// Zero, where `num_traits::Zero` cannot give it: in a constant.
    const ZERO: Self;

    /// Several of these numbers side by side.
    #[doc(hidden)]
    type Lanes: Lanes<Self>;

    /// The bits of the value, for a digest.
    fn bits(self) -> u64;
    /// A whole number.
    #[must_use]
    fn from_count(count: u32) -> Self;
    /// The whole part; 0 for what is below zero and for what is not a number.
    fn to_count(self) -> u32;
    /// One half.
    #[must_use]
    fn half() -> Self {
        Self::from_f32(0.5)
    }
}

/// Numbers that can be raised to any power: `f32` and `f64`, by software, the same bits everywhere.
pub trait Power: Scalar {
    /// The number, at least 0, to this power.
    #[must_use]
    fn power(self, exponent: Self) -> Self;
}
