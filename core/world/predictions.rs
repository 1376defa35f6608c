//! When are predictions made? Reads the world's state; writes its queue.

use super::state::World;
use crate::cluster;
use crate::detect::{self, EventKind, ScheduledEvent};
use crate::law::Rule;
use crate::particle::Body;
use crate::scalar::Scalar;

impl<S: Scalar, const D: usize, R: Rule<S>> World<'_, S, D, R> {
    /// A grain's next event. Without cells it is brought back into the box first, so that the nearest
    /// image is one box length away at most.
    pub(super) fn predict(&mut self, grain: usize) -> ScheduledEvent<S> {
        let settled = |body: &Body<S, D>| body.is_clustered() || body.is_asleep();
        if self.parameters.settings.is_integrated(&self.rule)
            && self.particles.body(grain).is_some_and(settled)
        {
            return self.predict_settled(grain);
        }
        if self.particles.cells.grid.is_none() {
            self.particles.rewrap(grain, &self.domain, self.clock.now);
        }
        detect::next_event(&self.particles, &self.domain, self.clock.now, grain)
    }

    /// The same for one that may be known to be near nobody else. Only small machines ask: where neighbours are looked at
    /// side by side a look is cheap.
    #[inline(always)]
    pub(super) fn predict_beside(&mut self, grain: usize, alone: bool) -> ScheduledEvent<S> {
        #[cfg(not(feature = "alloc"))]
        if alone && self.particles.cells.grid.is_some() {
            return detect::next_event_alone(&self.particles, &self.domain, self.clock.now, grain);
        }
        let _ = alone;
        self.predict(grain)
    }

    /// The same for a clustered or sleeping grain: what sleeps waits.
    fn predict_settled(&self, grain: usize) -> ScheduledEvent<S> {
        if self.particles.body(grain).is_some_and(Body::is_asleep) {
            return ScheduledEvent::NONE;
        }
        let clusters = (&self.clusters, &self.parameters.settings);
        cluster::next_event(&self.particles, &self.domain, clusters, self.clock.now, grain)
    }

    /// The same for a grain that has just crossed into another cell.
    pub(super) fn predict_after_crossing(
        &mut self,
        grain: usize,
        crossing: ScheduledEvent<S>,
    ) -> ScheduledEvent<S> {
        if self.particles.cells.grid.is_none() {
            return self.predict(grain);
        }
        let now = self.clock.now;
        detect::next_event_after_crossing(&self.particles, &self.domain, now, (grain, crossing))
    }

    /// Predicts every grain's next event. Who was told to check what supports it still does so first.
    pub(super) fn predict_all(&mut self) {
        for i in 0..self.particles.bodies.len() {
            let event = match self.queue.event(i).kind {
                _ if self.particles.body(i).is_some_and(Body::is_vacant) => ScheduledEvent::NONE,
                EventKind::SupportCheck => {
                    ScheduledEvent::alone(self.clock.now, EventKind::SupportCheck)
                }
                _ => self.predict(i),
            };
            if let Some(place) = self.queue.events.get_mut(i) {
                *place = event;
            }
        }
        self.queue.rebuild();
    }
}
