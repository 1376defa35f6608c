//! When are clocks set back, and what changes with gravity? Reads and writes the whole state between events.

use super::state::World;
use crate::detect::EventKind;
use crate::error::{Error, Subject};
use crate::law::Rule;
use crate::resolve::{Context, Effects, continue_contact_under, min_hop_time};
use crate::scalar::{Scalar, Vector, all_finite};
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
        self.set_clocks_back(self.clock.now.leading_digits());
        self.predict_all();
    }

    /// Every grain flies to the present; the epoch moves on by `back`. All events must be predicted anew.
    pub(super) fn set_clocks_back(&mut self, back: S) {
        (self.progress.since_epoch, self.progress.bookkeeping) = (0, 0);
        self.statistics.epochs += 1;
        let (present, now) = (self.clock.now, self.clock.now - back);
        for body in self.particles.bodies.iter_mut() {
            flight::advance(body, &self.domain, present);
            body.clock = now;
            if body.contact_end < S::NEVER {
                body.contact_end -= back;
            }
            if body.reference_time > -S::NEVER {
                let time = body.reference_time - back;
                body.reference_time = if time.is_finite() { time } else { -S::NEVER };
            }
        }
        self.clock.now = now;
        self.clock.epoch = self.clock.instant_of(back);
        self.domain.boundary.set_epoch(self.clock.epoch);
    }

    /// Changes gravity now: between events, in the middle of contacts too. All events are predicted anew.
    ///
    /// # Errors
    /// [`Error::Input`] if a component is not finite.
    pub fn set_gravity(&mut self, gravity: [S; D]) -> Result<(), Error> {
        let gravity = Vector::from(gravity);
        if let Some(most) = S::RANGE.filter(|_| !gravity.iter().all(|x| x.in_range())) {
            return Err(Error::overflow(Subject::World, "gravity", most.to_f64()));
        }
        if !all_finite(&gravity) {
            let value = gravity.iter().find(|x| !x.is_finite()).map_or(0.0, |x| x.to_f64());
            return Err(Error::input(Subject::World, "gravity", value, "a finite number"));
        }
        self.set_clocks_back(self.clock.now);
        self.progress.at_once = 0;
        let before = *self.domain.gravity();
        self.domain.set_gravity(gravity);
        self.parameters.min_hop_time = min_hop_time(&gravity, self.particles.largest_radius);
        self.wake_all();
        self.continue_contacts(&before);
        self.predict_all();
        Ok(())
    }

    /// Nothing supports any grain any longer.
    fn wake_all(&mut self) {
        for body in self.particles.bodies.iter_mut() {
            *body = body.awake();
        }
        self.particles.supported = 0;
    }

    /// Contacts under way go on after a change of gravity.
    fn continue_contacts(&mut self, before: &Vector<S, D>) {
        let mut effects = Effects::default();
        let mut context = Context {
            particles: &mut self.particles,
            domain: &self.domain,
            clock: &self.clock,
            parameters: &self.parameters,
            effects: &mut effects,
        };
        for i in 0..context.particles.bodies.len() {
            continue_contact_under(&mut context, i, before);
        }
    }
}
