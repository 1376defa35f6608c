//! And then, for clustered grains? A step of all of them; reads bodies and the rule, writes bodies and the queue.

use super::observe::{Event, Observer};
use super::state::World;
use crate::cluster::{self, Crush, Receiver, Transfer};
use crate::detect::EventKind;
use crate::error::Error;
use crate::law::Rule;
use crate::particle::{Body, Partner};
use crate::resolve::EventOutcome;
use crate::scalar::{Instant, Scalar};

/// An observer who is told of what clustered grains do.
struct Told<'a, O>(&'a mut O);

impl<S: Scalar, const D: usize, O: Observer<S, D>> Receiver<S, D> for Told<'_, O> {
    #[inline(always)]
    fn receive(&mut self, transfer: &Transfer<S, D>) {
        self.0.transferred(transfer);
    }
}

impl<S: Scalar, const D: usize, R: Rule<S>> World<'_, S, D, R> {
    /// Whether grains are clustered now.
    #[inline]
    pub(super) fn has_clusters(&self) -> bool {
        self.parameters.settings.is_integrated(&self.rule) && self.clusters.count > 0
    }

    /// Clustered grains move on to this time, and all that may touch next is predicted.
    pub(super) fn step_clusters(
        &mut self,
        to: S,
        observer: &mut impl Observer<S, D>,
    ) -> Result<Event<S>, Error> {
        let grain = self.clusters.first().unwrap_or(0);
        self.clock.move_to(to);
        (self.clock.last_visible, self.progress.at_once) = (self.clock.now, [0; 2]);
        let (at, kind) = (self.now(), EventKind::Step);
        let mut event = Event { at, grain, partner: Partner::NOTHING, kind, outcome: None };
        observer.before(&event, self.view());
        let crush = self.move_observed(to, observer)?;
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

    /// The step under way ends now, between events: nobody observes what it does.
    pub(super) fn cut_step(&mut self) -> Result<(), Error> {
        self.statistics.cut_steps += u64::from(self.clusters.time < self.clock.now);
        self.move_observed(self.clock.now, &mut ()).map(|_| ())
    }

    /// Clustered grains move on to this time.
    fn move_observed(
        &mut self,
        to: S,
        observer: &mut impl Observer<S, D>,
    ) -> Result<Option<Crush<S>>, Error> {
        let (rule, told) = ((&self.rule, &self.parameters.settings), &mut Told(observer));
        let (particles, clusters) = (&mut self.particles, &mut self.clusters);
        let crush = cluster::step(particles, &self.domain, clusters, rule, to, told)?;
        self.predict_changed().map(|()| crush)
    }

    /// Visits the contacts of grains that sleep, with each other and with planes: the forces that hold them, as
    /// [`Transfer`]s of one unit of time, and since which instant. Observers are told of all others, in the steps of
    /// clusters ([`Observer::transferred`]). [`Enduring::Integrated`](crate::Enduring) only: what rests in the papers'
    /// mode touches without force.
    pub fn for_each_resting_contact(&self, mut visit: impl FnMut(&Transfer<S, D>, Instant)) {
        if !self.parameters.settings.is_integrated(&self.rule) {
            return;
        }
        let rule = (&self.rule, &self.parameters.settings);
        let now = self.clock.now;
        let tell = &mut |transfer: &Transfer<S, D>, since| {
            visit(transfer, self.clock.instant_of(since));
        };
        cluster::for_each_resting(&self.particles, &self.domain, rule, now, tell);
    }

    /// Who of the clustered grains flies or sleeps from now on, and what happens to each next.
    fn predict_changed(&mut self) -> Result<(), Error> {
        let mut next = self.clusters.first();
        while let Some(grain) = next {
            next = self.particles.body(grain).and_then(|body| body.partner.next_clustered());
            self.check_range(grain)?;
            let who = (&self.parameters.settings, grain);
            cluster::settle(&mut self.particles, &self.domain, &mut self.clusters, who);
            self.settle_rotation(grain);
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
        let Some(around) = self.particles.body(grain).map(|body| (body.cell, body.radius)) else {
            return;
        };
        let mut after = None;
        while let Some(k) = self.next_free_near(around, after) {
            let event = self.predict(k);
            self.queue.set(k, event);
            after = Some(k);
        }
    }

    /// The free grain near this cell with the next number.
    fn next_free_near(&self, (cell, radius): (u32, S), after: Option<usize>) -> Option<usize> {
        let mut next = None;
        self.particles.cells.for_each_near(cell, radius, |k| {
            let is_free = |body: &Body<S, D>| !body.is_clustered() && !body.is_asleep();
            let counts = after.is_none_or(|after| k > after) && next.is_none_or(|next| k < next);
            if counts && self.particles.body(k).is_some_and(is_free) {
                next = Some(k);
            }
        });
        next
    }

    /// Somebody faster is clustered now, for whom the step under way may be too long.
    #[inline(never)]
    pub(super) fn shorten_step(&mut self) {
        let none = (S::zero(), S::zero());
        let step = self.parameters.settings.step(&self.rule, self.clusters.speed, none);
        self.clusters.shorten(step, self.clock.now);
    }
}
