//! When is now? A point in time that does not lose precision as it grows; reads and writes nothing.

use core::fmt;

/// A number that measures how long it is between two instants.
pub trait TimeSpan: Copy {
    /// The value as an instant after zero, in steps of 2^−64; saturates.
    fn to_ticks(self) -> i128;
    /// The value nearest to a number of steps of 2^−64.
    fn from_ticks(ticks: i128) -> Self;
    /// A value just below this one.
    #[must_use]
    fn next_below(self) -> Self;
}

/// A point in time since the start, in steps of 2⁻⁶⁴ of the time unit.
///
/// It reaches ±2⁶³ units. Sums and differences are exact, so an `f32` world after 10⁶ s tells two
/// instants apart as finely as at its start. Only spans (differences) are of the world's scalar.
///
/// # Units
/// The time unit of the simulation; seconds if everything is in SI. Choose units in which a contact
/// lasts longer than about 10⁻¹⁵, so that 2⁻⁶⁴ stays far below anything that matters.
///
/// ```
/// use carom::Instant;
/// let late = Instant::from(1.0e6_f64) + Instant::from(1.0e-9_f32);
/// assert!((late.since::<f32>(Instant::from(1.0e6_f64)) - 1.0e-9).abs() < 1e-16);
/// ```
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Instant {
    whole: i64,
    part: u64,
}

impl Instant {
    /// The start.
    pub const START: Self = Self { whole: 0, part: 0 };

    /// How long after `earlier` this is, rounded to the nearest `S`; negative if it is before.
    #[must_use]
    pub fn since<S: TimeSpan>(self, earlier: Self) -> S {
        S::from_ticks(self.ticks().saturating_sub(earlier.ticks()))
    }

    /// How long after `earlier` this is, rounded down: `earlier` plus the span is not after this instant.
    #[must_use]
    pub(crate) fn span_since<S: TimeSpan>(self, earlier: Self) -> S {
        let span: S = self.since(earlier);
        if earlier + Self::from(span) > self { span.next_below() } else { span }
    }

    /// This instant as a number of time units; rounded.
    #[must_use]
    pub fn as_f64(self) -> f64 {
        f64::from_ticks(self.ticks())
    }

    /// How many periods of the frequency `mantissa` · 2^`exponent` have passed, without the whole ones,
    /// in steps of 2^−64, rounded down: exact but for frequencies far below one.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "whole turns are cut off"
    )]
    pub(super) fn turns(self, mantissa: i128, exponent: i32) -> u64 {
        // Of a product of 128 bits the lower half is a fraction once it is shifted down by 64 at most.
        let slow = exponent.saturating_add(64).min(0).unsigned_abs().min(127);
        let product = (self.ticks() >> slow).wrapping_mul(mantissa);
        let shift = exponent.unsigned_abs() - slow;
        if exponent < 0 {
            (product >> shift.min(127)) as u64
        } else {
            product.checked_shl(shift).unwrap_or(0) as u64
        }
    }

    /// How often a timer with this many counts in a time unit has counted since the start, rounded down:
    /// until when firmware can sleep. Before the start it is zero.
    ///
    /// ```
    /// use carom::Instant;
    /// assert_eq!(Instant::from(1.5_f32).counts(32_768), 49_152); // seconds, a watch crystal
    /// ```
    #[must_use]
    #[expect(clippy::cast_sign_loss, reason = "checked")]
    pub fn counts(self, per_unit: u32) -> u64 {
        if self.whole < 0 {
            return 0;
        }
        let part = (u128::from(self.part) * u128::from(per_unit)) >> 64;
        (self.whole as u64).saturating_mul(u64::from(per_unit)).saturating_add(part as u64)
    }

    /// Whether this is visibly after another instant: by more than 2^−48 of its own age.
    pub(crate) fn is_visibly_after(self, other: Self) -> bool {
        self.ticks().saturating_sub(other.ticks()) > self.ticks() >> 48
    }

    /// Its two words, for a digest.
    #[expect(clippy::cast_sign_loss, reason = "the bits are meant")]
    pub(crate) fn words(self) -> (u64, u64) {
        (self.whole as u64, self.part)
    }

    pub(super) fn ticks(self) -> i128 {
        (i128::from(self.whole) << 64) | i128::from(self.part)
    }

    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the two halves of a split"
    )]
    fn from_ticks(ticks: i128) -> Self {
        Self { whole: (ticks >> 64) as i64, part: ticks as u64 }
    }
}

impl<S: TimeSpan> From<S> for Instant {
    /// The instant this long after the start; a NaN is the start.
    fn from(span: S) -> Self {
        Self::from_ticks(span.to_ticks())
    }
}

impl core::ops::Add for Instant {
    type Output = Self;
    fn add(self, span: Self) -> Self {
        Self::from_ticks(self.ticks().saturating_add(span.ticks()))
    }
}

impl fmt::Debug for Instant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.as_f64())
    }
}

impl fmt::Display for Instant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.as_f64().fmt(f)
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Instant {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "{=f64}", self.as_f64());
    }
}
