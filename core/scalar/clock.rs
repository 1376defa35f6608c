//! When is now? The present as a small scalar after an exact epoch; reads and writes nothing else.

use super::instant::Instant;
use super::traits::Scalar;

/// The present: an exact instant from which clocks count, and a small time after it.
///
/// The small part is set back to almost zero again and again, so that its last place stays fine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Clock<S> {
    /// The present, after the epoch.
    pub now: S,
    /// When time was last seen to have moved on visibly, after the epoch; negative if that was before it.
    pub last_visible: S,
    /// The instant from which the clocks of the bodies count.
    pub epoch: Instant,
}

impl<S: Scalar> Clock<S> {
    /// The start.
    pub fn start() -> Self {
        Self { now: S::zero(), last_visible: S::zero(), epoch: Instant::START }
    }

    /// The instant that a time after the epoch is.
    #[inline(never)]
    pub fn instant_of(&self, time: S) -> Instant {
        self.epoch + Instant::from(time)
    }

    /// The instant that the present is.
    pub fn instant(&self) -> Instant {
        self.instant_of(self.now)
    }

    /// From now on clocks count from an epoch that is later by `back`.
    pub fn set_back(&mut self, back: S) {
        self.epoch = self.instant_of(back);
        self.now -= back;
        let last = self.last_visible - back;
        self.last_visible = if last.is_finite() { last } else { -S::NEVER };
    }

    /// Time goes on to this time after the epoch; it never goes back.
    pub fn move_to(&mut self, time: S) {
        self.now = self.now.max(time);
    }
}
