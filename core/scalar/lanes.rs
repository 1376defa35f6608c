//! How are several numbers computed with side by side? In one register where that helps; reads and writes nothing.
//!
//! Only what never decides an event by itself is computed so.

use carom_tables::read::Real;
use core::ops::{Add, Mul, Sub};
use num_traits::{One, Zero};
#[cfg(target_arch = "x86_64")]
use wide::{CmpGe, CmpGt};

/// How many numbers are side by side: two where a register of every machine holds two `f64`.
pub const LANES: usize = if cfg!(target_arch = "x86_64") { 2 } else { 1 };

/// A few numbers of one type.
pub trait Lanes<S: Copy>:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self>
{
    /// These numbers.
    fn of(x: [S; LANES]) -> Self;
    /// A value where these are larger than a limit, else zero.
    #[must_use]
    fn where_above(self, limit: Self, value: Self) -> Self;
    /// A bit for each lane, the lowest for the first: whether it is at least the other.
    fn at_least(self, other: Self) -> u32;
    /// The same number everywhere.
    #[inline(always)]
    fn all(x: S) -> Self {
        Self::of([x; LANES])
    }
}

/// Numbers one by one.
#[derive(Clone, Copy, Debug)]
pub struct Each<S>([S; LANES]);

impl<S: Real> Each<S> {
    #[inline(always)]
    fn zip(mut self, other: Self, f: impl Fn(S, S) -> S) -> Self {
        self.0.iter_mut().zip(&other.0).for_each(|(x, y)| *x = f(*x, *y));
        self
    }
}

impl<S: Real> Add for Each<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, |x, y| x + y)
    }
}

impl<S: Real> Sub for Each<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |x, y| x - y)
    }
}

impl<S: Real> Mul for Each<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.zip(other, |x, y| x * y)
    }
}

impl<S: Real + Zero + One> Lanes<S> for Each<S> {
    #[inline(always)]
    fn of(x: [S; LANES]) -> Self {
        Self(x)
    }
    #[inline(always)]
    fn where_above(self, limit: Self, value: Self) -> Self {
        let above = self.zip(limit, |x, limit| if x > limit { S::one() } else { S::zero() });
        above * value
    }
    #[inline(always)]
    fn at_least(self, other: Self) -> u32 {
        // Not from the last to the first: that is unreadable to compilers for small machines.
        let pairs = self.0.iter().zip(&other.0).enumerate();
        pairs.fold(0, |bits, (lane, (x, y))| bits | u32::from(x >= y) << lane)
    }
}

#[cfg(target_arch = "x86_64")]
impl Lanes<f64> for wide::f64x2 {
    #[inline(always)]
    fn of(x: [f64; LANES]) -> Self {
        Self::new(x)
    }
    #[inline(always)]
    fn where_above(self, limit: Self, value: Self) -> Self {
        self.cmp_gt(limit) & value
    }
    #[inline(always)]
    fn at_least(self, other: Self) -> u32 {
        self.cmp_ge(other).move_mask().unsigned_abs()
    }
}
