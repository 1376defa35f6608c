//! Which instant is meant? Reads a time of any number type, or an instant; writes an instant, refuses what is none.

use super::instant::Instant;
use super::traits::Scalar;

/// A point in time that a world can be asked for: an [`Instant`], or a number of time units since the start.
pub trait IntoInstant {
    /// The instant; the number itself if it is infinite or none.
    ///
    /// # Errors
    /// The number, if it is not finite.
    fn into_instant(self) -> Result<Instant, f64>;
}

impl IntoInstant for Instant {
    fn into_instant(self) -> Result<Instant, f64> {
        Ok(self)
    }
}

impl<S: Scalar> IntoInstant for S {
    fn into_instant(self) -> Result<Instant, f64> {
        if self.is_finite() { Ok(Instant::from(self)) } else { Err(self.to_f64()) }
    }
}
