//! And then? One event after the other; reads the queue, writes the world.

use super::observe::{Event, Observer};
use super::state::World;
use super::statistics::Statistics;
use super::view::View;
use crate::cluster::{self, Crush};
use crate::detect::{EventKind, ScheduledEvent};
use crate::error::{Error, Subject};
use crate::law::Rule;
use crate::particle::{Body, Grain, Partner};
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
        let Some((grain, due)) = self.due(limit.min(step)) else {
            if self.has_clusters() && step <= limit {
                return self.step_clusters(step, observer).map(Some);
            }
            return Ok(None);
        };
        self.move_clock(grain, &due)?;
        let (at, partner, kind) = (self.now(), due.with(), due.kind);
        let mut event = Event { at, grain, partner, kind, outcome: None };
        observer.before(&event, self.view());
        let mut effects = Effects::default();
        let outcome = self.resolve(grain, &due, &mut effects);
        self.statistics.count(&effects.incidents);
        event.outcome = Some(outcome?);
        self.predict_affected(&effects)?;
        if kind.is_bookkeeping() {
            self.renew_prediction(grain, due)?;
        }
        observer.after(&event, self.view());
        self.keep_time(kind);
        Ok(Some(event))
    }

    /// The earliest event, if it is due by `limit`; stale ones are predicted anew on the way.
    fn due(&mut self, limit: S) -> Option<(usize, ScheduledEvent<S>)> {
        loop {
            let grain = self.queue.first()?;
            let event = self.queue.event(grain);
            if event.kind == EventKind::Nothing || !(event.time <= limit) {
                return None;
            }
            let queued = (grain, &event);
            let stale = match first_of_instant(&self.particles, &self.domain, &self.queue, queued) {
                Ok(first) => {
                    let due = self.queue.event(first);
                    let faster = first != grain && due.kind == EventKind::Collision;
                    self.statistics.reordered += u64::from(faster);
                    return Some((first, due));
                }
                Err(stale) => stale,
            };
            self.statistics.stale += 1;
            self.clock.move_to(event.time);
            let event = self.predict(stale);
            self.queue.set(stale, event);
        }
    }

    /// Whether grains are clustered now.
    #[inline]
    pub(super) fn has_clusters(&self) -> bool {
        self.parameters.settings.is_integrated(&self.rule) && self.clusters.count > 0
    }

    /// Clustered grains move on to this time, and all that may touch next is predicted.
    fn step_clusters(
        &mut self,
        to: S,
        observer: &mut impl Observer<S, D>,
    ) -> Result<Event<S>, Error> {
        let grain = self.clusters.first().unwrap_or(0);
        self.clock.move_to(to);
        (self.clock.last_visible, self.progress.at_once) = (self.clock.now, 0);
        let (at, kind) = (self.now(), EventKind::Step);
        let mut event = Event { at, grain, partner: Partner::NOTHING, kind, outcome: None };
        observer.before(&event, self.view());
        let crush = self.move_clusters(to)?;
        self.statistics.steps += 1;
        self.statistics.crushed += u64::from(crush.is_some());
        event.outcome = Some(EventOutcome::Stepped);
        if let Some(Crush { grain, with, overlap, .. }) = crush {
            (event.grain, event.partner) = (grain, with);
            event.outcome = Some(EventOutcome::Crushed { overlap });
        }
        observer.after(&event, self.view());
        self.keep_time(kind);
        Ok(event)
    }

    /// The same without an observer.
    pub(super) fn move_clusters(&mut self, to: S) -> Result<Option<Crush<S>>, Error> {
        let rule = (&self.rule, &self.parameters.settings);
        let crush = cluster::step(&mut self.particles, &self.domain, &mut self.clusters, rule, to);
        self.predict_changed().map(|()| crush)
    }

    /// Who of the clustered grains flies or sleeps from now on, and what happens to each next.
    fn predict_changed(&mut self) -> Result<(), Error> {
        let mut next = self.clusters.first();
        while let Some(grain) = next {
            next = self.particles.body(grain).and_then(|body| body.partner.next_clustered());
            self.check_range(grain)?;
            let who = (&self.parameters.settings, grain);
            cluster::settle(&mut self.particles, &self.domain, &mut self.clusters, who);
            let event = self.predict(grain);
            if event.kind != EventKind::Nothing
                || self.queue.event(grain).kind != EventKind::Nothing
            {
                self.queue.set(grain, event);
            }
            if self.particles.body(grain).is_some_and(Body::is_asleep) {
                self.predict_free_near(grain);
            }
        }
        Ok(())
    }

    /// A grain that fell asleep looks for nothing any more: free ones near it look for it.
    fn predict_free_near(&mut self, grain: usize) {
        let Some(cell) = self.particles.body(grain).map(|body| body.cell) else { return };
        let mut after = None;
        while let Some(k) = self.next_free_near(cell, after) {
            let event = self.predict(k);
            self.queue.set(k, event);
            after = Some(k);
        }
    }

    /// The free grain near this cell with the next number.
    fn next_free_near(&self, cell: u32, after: Option<usize>) -> Option<usize> {
        let mut next = None;
        self.particles.cells.for_each_near(cell, |k| {
            let is_free = |body: &Body<S, D>| !body.is_clustered() && !body.is_asleep();
            let counts = after.is_none_or(|after| k > after) && next.is_none_or(|next| k < next);
            if counts && self.particles.body(k).is_some_and(is_free) {
                next = Some(k);
            }
        });
        next
    }

    /// The event's time becomes the present, which never goes back.
    fn move_clock(&mut self, grain: usize, event: &ScheduledEvent<S>) -> Result<(), Error> {
        self.clock.move_to(event.time);
        self.progress.at_once = self.progress.at_once.saturating_add(1);
        if self.progress.at_once < EVENTS_AT_ONCE {
            return Ok(());
        }
        self.look_for_jam().map_or(Ok(()), |(at, events)| {
            Err(Error::Stuck { grain, with: event.with(), at, events })
        })
    }

    /// Time must move on visibly, by 2^−48 of the world's age, before the grains concerned have too many events: when
    /// and after how many it did not. Looks seldom, as all bodies are read.
    #[inline(never)]
    fn look_for_jam(&mut self) -> Option<(Instant, u32)> {
        let (at, events) = (self.now(), self.progress.at_once);
        if !(events.is_power_of_two() || events == u32::MAX) {
            return None;
        }
        let since = self.clock.last_visible;
        if at.is_visibly_after(self.clock.instant_of(since)) {
            (self.clock.last_visible, self.progress.at_once) = (self.clock.now, 0);
            return None;
        }
        // When its last collision was, or a little after its contact began.
        let touched = |body: &&Body<S, D>| body.reference_time >= since;
        let concerned = self.particles.bodies.iter().filter(touched).count();
        let many = events / EVENTS_AT_ONCE;
        (events == u32::MAX || concerned <= many as usize).then_some((at, events))
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

    /// Somebody faster is clustered now, for whom the step under way may be too long.
    #[inline(never)]
    fn shorten_step(&mut self) {
        let none = (S::zero(), S::zero());
        let step = self.parameters.settings.step(&self.rule, self.clusters.speed, none);
        self.clusters.shorten(step, self.clock.now);
    }

    /// Predicts the next events of the grains that an event concerned, and checks that they still can be
    /// computed with. What lies on a grain that was at rest until now looks whether it is still supported.
    fn predict_affected(&mut self, effects: &Effects) -> Result<(), Error> {
        for &grain in &effects.void {
            self.check_range(grain)?;
            let event = self.predict(grain);
            self.queue.set(grain, event);
        }
        for &grain in &effects.woken {
            let (particles, queue) = (&self.particles, &mut self.queue);
            let (domain, now) = (&self.domain, self.clock.now);
            let cell = particles.body(grain).map_or(0, |body| body.cell);
            particles.cells.for_each_near(cell, |k| {
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
    fn check_range(&self, grain: usize) -> Result<(), Error> {
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
        let event = self.queue.event(self.queue.first()?);
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
