//! When are clocks set back? Reads and writes the times of all bodies between events.

use super::state::World;
use crate::detect::EventKind;
use crate::law::Rule;
use crate::scalar::Scalar;
#[cfg(not(feature = "alloc"))]
use crate::scalar::max_abs;
use crate::space::flight;

/// So many times as many bookkeeping events as others end an epoch, too.
const BOOKKEEPING: u32 = 64;

impl<S: Scalar, const D: usize, R: Rule<S>> World<'_, S, D, R> {
    /// Sets the clocks back by the leading digits of now once enough events have happened, so that times
    /// stay small and their last place fine, and predicts everything anew from there.
    ///
    /// Bookkeeping events do not count, unless there is little else: when clocks are set back must not
    /// depend on how neighbours are found.
    pub(super) fn keep_time(&mut self, kind: EventKind) {
        let progress = &mut self.progress;
        let count = match kind.is_bookkeeping() {
            true => &mut progress.bookkeeping,
            false => &mut progress.since_epoch,
        };
        *count = count.saturating_add(1);
        let grains = u32::try_from(self.particles.bodies.len()).unwrap_or(u32::MAX);
        let enough = S::EVENTS_PER_EPOCH.saturating_mul(grains).saturating_add(8);
        let due = progress.since_epoch >= enough
            || progress.bookkeeping >= enough.saturating_mul(BOOKKEEPING);
        let late = self.clock.now > S::LATE;
        if !((due || late) && self.clock.now > S::zero()) {
            return;
        }
        if self.has_clusters() && self.clusters.time < self.clock.now {
            // In the middle of a step: after it.
            return;
        }
        self.set_clocks_back(self.clock.now.leading_digits());
        self.predict_all();
    }

    /// Every grain flies to the present; the epoch moves on by `back`. All events must be predicted anew.
    pub(super) fn set_clocks_back(&mut self, back: S) {
        (self.progress.since_epoch, self.progress.bookkeeping) = (0, 0);
        self.statistics.epochs += 1;
        let (present, now) = (self.clock.now, self.clock.now - back);
        #[cfg(not(feature = "alloc"))]
        let mut top_speed = S::zero();
        for body in self.particles.bodies.iter_mut() {
            if !body.is_vacant() {
                flight::advance(body, &self.domain, present);
            }
            #[cfg(not(feature = "alloc"))]
            {
                top_speed = top_speed.max(max_abs(&body.velocity));
            }
            body.clock = now;
            if body.contact_end < S::NEVER {
                body.contact_end -= back;
            }
            if body.reference_time > -S::NEVER {
                let time = body.reference_time - back;
                body.reference_time = if time.is_finite() { time } else { -S::NEVER };
            }
        }
        #[cfg(not(feature = "alloc"))]
        {
            self.particles.top_speed = top_speed;
        }
        self.clusters.time -= back;
        self.clock.set_back(back);
        self.domain.boundary.set_epoch(self.clock.epoch);
    }
}
