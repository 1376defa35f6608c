//! And then? One event after the other; reads the queue, writes the world.

use super::observe::{Event, Observer};
use super::state::World;
use super::statistics::Statistics;
use super::view::View;
use crate::detect::{EventKind, ScheduledEvent};
use crate::error::{Error, Subject};
use crate::law::Rule;
use crate::particle::{Body, Grain};
use crate::resolve::{self, Context, Effects, EventOutcome};
use crate::scalar::{Instant, Scalar};
use crate::schedule::first_of_instant;

/// Events that the grains concerned can have at one instant, on average, before they are called stuck.
const EVENTS_AT_ONCE: u32 = 4096;

impl<S: Scalar, const D: usize, R: Rule<S>> World<'_, S, D, R> {
    /// The next event happens; none if nothing will ever happen again.
    ///
    /// # Errors
    /// [`Error::Stuck`], [`Error::OutsideTable`], [`Error::InvalidOutcome`], [`Error::NotFinite`].
    pub fn step(&mut self) -> Result<Option<Event<S>>, Error> {
        self.step_observed(&mut ())
    }

    /// As [`World::step`], observed.
    ///
    /// # Errors
    /// As [`World::step`].
    pub fn step_observed(
        &mut self,
        observer: &mut impl Observer<S, D>,
    ) -> Result<Option<Event<S>>, Error> {
        self.step_within(S::NEVER, observer)
    }

    /// The next event that is due by `limit` happens.
    pub(super) fn step_within(
        &mut self,
        limit: S,
        observer: &mut impl Observer<S, D>,
    ) -> Result<Option<Event<S>>, Error> {
        let step = self.clusters.due();
        let Some(grain) = self.due(limit.min(step)) else {
            if self.has_clusters() && step <= limit {
                return self.step_clusters(step, observer).map(Some);
            }
            return Ok(None);
        };
        let due = self.queue.event(grain);
        self.move_clock(grain, &due)?;
        let (at, partner, kind) = (self.now(), due.with(), due.kind);
        let mut event = Event { at, grain, partner, kind, outcome: None };
        observer.before(&event, self.view());
        let mut effects = Effects::default();
        let before = self.before_collision(grain, &due);
        let outcome = self.resolve(grain, &due, &mut effects);
        self.statistics.count(&effects.incidents);
        event.outcome = Some(outcome?);
        self.predict_affected(&effects)?;
        if let (Some(before), Some(EventOutcome::Collision { .. })) = (before, event.outcome) {
            self.collide_together(&before)?;
        }
        if kind.is_bookkeeping() {
            self.renew_prediction(grain, due)?;
        }
        observer.after(&event, self.view());
        self.keep_time(kind);
        Ok(Some(event))
    }

    /// Whose event is the earliest, if it is due by `limit`; stale ones are predicted anew on the way.
    fn due(&mut self, limit: S) -> Option<usize> {
        loop {
            let grain = self.queue.first()?;
            let event = self.queue.events.get(grain)?;
            let time = event.time;
            if event.kind == EventKind::Nothing || !(time <= limit) {
                return None;
            }
            let queued = (grain, event);
            let stale = match first_of_instant(&self.particles, &self.domain, &self.queue, queued) {
                Ok(first) if first == grain => return Some(grain),
                Ok(first) => {
                    let is_collision = self.queue.event(first).kind == EventKind::Collision;
                    self.statistics.reordered += u64::from(is_collision);
                    return Some(first);
                }
                Err(stale) => stale,
            };
            self.statistics.stale += 1;
            self.clock.move_to(time);
            let event = self.predict(stale);
            self.queue.set(stale, event);
        }
    }

    /// The event's time becomes the present, which never goes back.
    fn move_clock(&mut self, grain: usize, event: &ScheduledEvent<S>) -> Result<(), Error> {
        self.clock.move_to(event.time);
        let [events, renewals] = &mut self.progress.at_once;
        let is_renewal = event.kind.is_bookkeeping();
        let count = if is_renewal { renewals } else { events };
        *count = count.saturating_add(1);
        if *count < EVENTS_AT_ONCE {
            return Ok(());
        }
        let count = *count;
        self.look_for_jam(count, is_renewal)
            .map_or(Ok(()), |at| Err(Error::Stuck { grain, with: event.with(), at, events: count }))
    }

    /// Time must move on visibly, by 2^−48 of the world's age, before the grains concerned have too many events: when
    /// it did not. Predictions may be renewed by all grains at once. Looks seldom, as all bodies are read.
    #[inline(never)]
    fn look_for_jam(&mut self, events: u32, is_renewal: bool) -> Option<Instant> {
        let at = self.now();
        if !(events.is_power_of_two() || events == u32::MAX) {
            return None;
        }
        let since = self.clock.last_visible;
        if at.is_visibly_after(self.clock.instant_of(since)) {
            (self.clock.last_visible, self.progress.at_once) = (self.clock.now, [0; 2]);
            return None;
        }
        // When its last collision was, or a little after its contact began.
        let touched = |body: &&Body<S, D>| is_renewal || body.reference_time >= since;
        let concerned = self.particles.bodies.iter().filter(touched).count();
        let many = events / EVENTS_AT_ONCE;
        (events == u32::MAX || concerned <= many as usize).then_some(at)
    }

    /// What the event does to the bodies, and what it leaves to be done.
    fn resolve(
        &mut self,
        grain: usize,
        event: &ScheduledEvent<S>,
        effects: &mut Effects,
    ) -> Result<EventOutcome<S>, Error> {
        let mut context = Context {
            particles: &mut self.particles,
            domain: &self.domain,
            clock: &self.clock,
            parameters: &mut self.parameters,
            clusters: &mut self.clusters,
            effects,
        };
        let before = context.clusters.speed;
        let outcome = resolve::resolve(&mut context, &self.rule, (grain, event));
        if self.has_clusters() && self.clusters.speed > before {
            self.shorten_step();
        }
        outcome
    }

    /// Predicts the next events of the grains that an event concerned, and checks that they still can be
    /// computed with. What lies on a grain that was at rest until now looks whether it is still supported.
    pub(super) fn predict_affected(&mut self, effects: &Effects) -> Result<(), Error> {
        for (place, &grain) in effects.void.iter().enumerate() {
            self.check_range(grain)?;
            let event = self.predict_beside(grain, effects.alone >> place & 1 == 1);
            self.queue.set(grain, event);
        }
        for &grain in &effects.woken {
            let (particles, queue) = (&self.particles, &mut self.queue);
            let (domain, now) = (&self.domain, self.clock.now);
            let Some(body) = particles.body(grain) else { continue };
            particles.cells.for_each_near(body.cell, body.radius, |k| {
                if resolve::lies_on(particles, domain, (now, &self.parameters), [k, grain]) {
                    queue.set(k, ScheduledEvent::alone(now, EventKind::SupportCheck));
                }
            });
        }
        Ok(())
    }

    /// A prediction reached no further, or other grains are near now.
    fn renew_prediction(&mut self, grain: usize, event: ScheduledEvent<S>) -> Result<(), Error> {
        self.statistics.count_bookkeeping(event.kind);
        if S::RANGE.is_some() {
            self.check_range(grain)?;
        }
        let next = self.predict_after_crossing(grain, event);
        self.queue.set(grain, next);
        Ok(())
    }

    /// Whether a grain can still be computed with: now, too, if its number type has a range to leave.
    pub(super) fn check_range(&self, grain: usize) -> Result<(), Error> {
        let broken = match S::RANGE {
            Some(_) => self.particles.present(grain, &self.domain, self.clock.now).out_of_range(),
            None => self.particles.body(grain).and_then(|body| body.out_of_range()),
        };
        match (broken, S::RANGE) {
            (None, _) => Ok(()),
            (Some(field), None) => Err(Error::NotFinite { grain, field, at: self.now() }),
            (Some(field), Some(most)) => {
                Err(Error::overflow(Subject::Grain(grain), field, most.to_f64()))
            }
        }
    }

    /// Nothing happens before this instant; none if nothing will ever happen. Firmware can sleep until then.
    #[must_use]
    pub fn next_event_time(&self) -> Option<Instant> {
        let event = self.queue.earliest()?;
        let time = event.time.min(self.clusters.due());
        (time < S::NEVER).then(|| self.clock.instant_of(time))
    }

    /// The present.
    #[must_use]
    pub fn now(&self) -> Instant {
        self.clock.instant()
    }

    /// A grain as it is now, in the order in which grains were added.
    #[must_use]
    pub fn grain(&self, index: usize) -> Option<Grain<S, D>> {
        self.view().grain(index)
    }

    /// How often everything happened.
    #[must_use]
    pub fn statistics(&self) -> &Statistics {
        &self.statistics
    }

    /// The world to look at.
    #[must_use]
    pub fn view(&self) -> View<'_, S, D> {
        View {
            particles: &self.particles,
            domain: &self.domain,
            clock: &self.clock,
            statistics: &self.statistics,
        }
    }
}

impl<S: Scalar, const D: usize, R: Rule<S>> core::fmt::Debug for World<'_, S, D, R> {
    /// What [`View`] shows.
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("World").field("view", &self.view()).finish_non_exhaustive()
    }
}
