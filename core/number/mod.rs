//! What is a value? The operations the engine uses on numbers; reads nothing, writes nothing.
//!
//! Everything above this room is written against [`Scalar`]: `f32`, `f64` and, with the feature `fixed`,
//! `I32F32` and `I16F16`. All transcendental functions come from software, so a target
//! with a floating-point unit gives the same bits as one without; fixed point uses no float at all.
//!
//! Squares and other products have a type of their own, [`Product`]: the sums, differences, roots and
//! quotients in which a fixed-point number would overflow or lose its last places are taken from it.

mod angle;
#[cfg(feature = "fixed")]
mod fixed;
mod float;
mod instant;
mod lanes;
#[cfg(feature = "micromath")]
pub mod quick;

#[cfg(feature = "fixed")]
pub use carom_tables::fixed_point::{I16F16, I32F32};
pub use carom_tables::read::Real;
pub use instant::Instant;
pub use lanes::{LANES, Lanes};

use core::fmt::{Debug, Display};
use core::ops::{AddAssign, MulAssign, SubAssign};

/// A vector of `D` components of `S`.
pub type Vector<S, const D: usize> = nalgebra::SVector<S, D>;

/// A product of two numbers or a sum of such, before it is rounded.
///
/// For a float it is that float. For a fixed-point number it has twice as many bits and is exact.
pub trait Product<S>:
    Copy
    + PartialOrd
    + core::ops::Add<Output = Self>
    + core::ops::Sub<Output = Self>
    + core::ops::Neg<Output = Self>
{
    /// The nearest number.
    fn rounded(self) -> S;
    /// The square root.
    fn root(self) -> S;
    /// Divided by a number.
    fn over(self, divisor: S) -> S;
}

/// A number the engine can count, measure and compare with.
///
/// Implemented for `f32`, `f64` and the fixed-point numbers. Each method is exactly one operation the engine needs.
pub trait Scalar:
    Real
    + nalgebra::Scalar
    + nalgebra::ClosedAddAssign
    + nalgebra::ClosedSubAssign
    + nalgebra::ClosedMulAssign
    + nalgebra::ClosedDivAssign
    + num_traits::Zero
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
    /// A time that no event reaches.
    const NEVER: Self;
    /// No event is predicted for later than this.
    const LAST: Self;
    /// When it is later than this the clock is set back in any case.
    const LATE: Self = Self::NEVER;
    /// The distance of neighbouring values near one.
    const RESOLUTION: Self;
    /// After how many events per grain the clock is set back, see [`crate::world::World`].
    const EVENTS_PER_EPOCH: u32;
    /// The largest position and velocity, if a number can leave the range without being infinite.
    const RANGE: Option<Self> = None;

    /// The type of products.
    type Product: Product<Self>;
    /// Several of these numbers side by side.
    type Lanes: Lanes<Self>;
    /// The product, not yet rounded.
    fn times(self, other: Self) -> Self::Product;
    /// The scalar product, not yet rounded.
    fn dot<const D: usize>(a: &Vector<Self, D>, b: &Vector<Self, D>) -> Self::Product;

    /// Whether this is a number that can be computed with: neither NaN nor infinite.
    fn is_number(self) -> bool;
    /// Sine and cosine of an angle in radians; of an `f32` beyond ±6400, which is a thousand turns, NaN.
    fn sine_cosine(self) -> (Self, Self);
    /// The largest whole number not above this one.
    fn round_down(self) -> Self;
    /// The number cut to its leading twelve binary digits: subtracting it is exact for everything up
    /// to 2¹² times as large.
    fn leading_digits(self) -> Self;
    /// The number that, added and taken away again, rounds to a lattice of four units in the last place
    /// of `size`; zero for numbers that are on one anyway. Sums and differences of such positions are
    /// exact, so a periodic box looks the same from each of its images.
    fn lattice(size: Self) -> Self;
    /// x^(−1/5) for x > 0, the power in MP13's Eq. (53).
    fn inverse_fifth_root(self) -> Self;
    /// The bits of the value, for a digest.
    fn bits(self) -> u64;
    /// The value as an instant after zero, in steps of 2^−64; saturates.
    fn to_ticks(self) -> i128;
    /// The value nearest to a number of steps of 2^−64.
    fn from_ticks(ticks: i128) -> Self;

    /// Whether a position or velocity is within the range in which everything can be computed.
    fn in_range(self) -> bool {
        self.is_number()
    }
    /// The distance to the neighbouring values, about.
    fn rounding(self) -> Self {
        self * Self::RESOLUTION
    }
    /// A value just below this one.
    fn below(self) -> Self {
        self - self.magnitude() * Self::RESOLUTION
    }
    /// A whole number.
    #[must_use]
    fn from_count(count: u32) -> Self {
        Self::from_f64(f64::from(count))
    }
    /// The whole part; 0 for what is below zero and for what is not a number.
    fn to_count(self) -> u32 {
        // A cast from float saturates, and NaN gives 0.
        self.to_f64() as u32
    }
    /// √(self/other).
    fn root_of_ratio(self, other: Self) -> Self {
        (self / other).sqrt()
    }
    /// k^(−2/5) v^(−1/5): MP13's Eq. (53).
    fn contact_time(k: Self, v: Self) -> Self {
        k.inverse_fifth_root() * (k * v).inverse_fifth_root()
    }
    /// The phase in turns, without the whole ones, a span after it was `turn`.
    fn phase(turn: Self, frequency: Self, span: Self) -> Self {
        let turns = turn + frequency * span;
        turns - turns.round_down()
    }
    /// The phase in turns, without the whole ones, at an instant.
    fn phase_at(start: Self, frequency: Self, at: Instant) -> Self;
    /// The smallest step of a search: an acceleration `bound` changes a distance of this size by less
    /// than its rounding meanwhile.
    fn least_step(size: Self, bound: Self) -> Self {
        (Self::RESOLUTION * Self::half() * (size / bound)).sqrt()
    }
    /// An acceleration above zero too weak to matter to something of this size before the limit.
    fn weak(size: Self, limit: Self) -> Self {
        let span = limit.smaller(Self::from_f32(1e9)).larger(Self::RESOLUTION);
        Self::RESOLUTION * (size / span) / span + Self::RESOLUTION * Self::RESOLUTION * size
    }
    /// Whether a part of a vector is below a hundredth of it.
    fn negligible<const D: usize>(part: &Vector<Self, D>, of: &Vector<Self, D>) -> bool {
        part.dot(part) <= of.dot(of) * Self::from_f32(1e-4)
    }
    /// When two spheres touch, if this type finds it in a way of its own, see [`crate::event::root::spheres`].
    #[must_use]
    fn meeting<const D: usize>(
        _: &Vector<Self, D>,
        _: &Vector<Self, D>,
        _: Self,
    ) -> Option<Option<Self>> {
        None
    }
    /// After which span a body of this speed and acceleration may have left the range; none if it cannot.
    fn horizon(_speed: Self, _acceleration: Self) -> Option<Self> {
        None
    }

    /// The larger of two numbers.
    fn larger(self, other: Self) -> Self {
        if other > self { other } else { self }
    }
    /// The smaller of two numbers.
    fn smaller(self, other: Self) -> Self {
        if other < self { other } else { self }
    }
    /// The distance from zero.
    fn magnitude(self) -> Self {
        if self < Self::zero() { -self } else { self }
    }
    /// One half.
    #[must_use]
    fn half() -> Self {
        Self::from_f32(0.5)
    }
}

/// Whether every component can be computed with.
pub fn all_numbers<S: Scalar, const D: usize>(v: &Vector<S, D>) -> bool {
    v.iter().all(|x| x.is_number())
}

/// A component of a vector.
#[inline(always)]
pub fn part<S: Scalar, const D: usize>(v: &Vector<S, D>, axis: usize) -> S {
    let [column] = &v.data.0;
    column.get(axis).copied().unwrap_or(S::zero())
}

/// The scalar product.
#[inline]
pub fn dot<S: Scalar, const D: usize>(a: &Vector<S, D>, b: &Vector<S, D>) -> S {
    S::dot(a, b).rounded()
}

/// The length of a vector.
#[inline]
pub fn norm<S: Scalar, const D: usize>(v: &Vector<S, D>) -> S {
    S::dot(v, v).root()
}

/// The magnitude of the largest component.
pub fn largest<S: Scalar, const D: usize>(v: &Vector<S, D>) -> S {
    v.iter().fold(S::zero(), |most, x| most.larger(x.magnitude()))
}
