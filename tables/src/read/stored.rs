//! In which numbers are the coefficients of a table stored? Reads one stored number; writes its value in the reader's number type.

use super::real::Real;

/// A number as a table stores it: `f32`, `f64` or [`Quantised`].
pub trait StoredNumber: Copy + 'static {
    /// Whether a wide table can be stored so. Where not, its cube roots and logarithms are not linked.
    const WIDE: bool = true;
    /// The stored value in the number type of the reader.
    fn get<S: Real>(self) -> S;
}

impl StoredNumber for f32 {
    fn get<S: Real>(self) -> S {
        S::from_f32(self)
    }
}

impl StoredNumber for f64 {
    fn get<S: Real>(self) -> S {
        S::from_f64(self)
    }
}

/// A number stored as a count of steps of 2^−28, from −8 to 8.
///
/// Near one it is as good as an `f32`, and it is read without float arithmetic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quantised(
    /// The number of steps.
    pub i32,
);

impl StoredNumber for Quantised {
    const WIDE: bool = false;
    #[inline]
    fn get<S: Real>(self) -> S {
        S::from_quantised(self.0)
    }
}
