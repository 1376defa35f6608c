//! What is a value? The operations the engine uses on numbers, for f32 and f64; reads nothing, writes nothing.
//!
//! Everything above this room is written against [`Scalar`], so a fixed-point type fits in by
//! implementing one trait. All transcendental functions come from software (`libm`), so a target
//! with a floating-point unit gives the same bits as one without.

mod float;
mod instant;

pub use carom_tables::Real;
pub use instant::Instant;

use core::fmt::{Debug, Display};
use core::ops::{AddAssign, MulAssign, SubAssign};

/// A vector of `D` components of `S`.
pub type Vector<S, const D: usize> = nalgebra::SVector<S, D>;

/// A number the engine can count, measure and compare with.
///
/// Implemented for `f32` and `f64`. Each method is exactly one operation the engine needs.
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
    /// The relative distance of neighbouring values near one.
    const RESOLUTION: Self;
    /// After how many events per grain the clock is set back, see [`crate::world::World`].
    const EVENTS_PER_EPOCH: u32;

    /// Whether this is a number that can be computed with: neither NaN nor infinite.
    fn is_number(self) -> bool;
    /// Sine and cosine of an angle in radians.
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
