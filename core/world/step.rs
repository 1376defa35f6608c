//! And then? One event after the other; reads the queue, writes the scene and the queue.

use super::World;
use super::watch::{Happening, View, Watch};
use crate::event::apply::{self, Affected, Deed};
use crate::event::{Counters, Kind, Slot, order, support, wake};
use crate::fault::{Fault, Subject};
use crate::law::Rule;
use crate::matter::Grain;
use crate::number::{Instant, Scalar};

/// Events that a grain can have at one instant, on average, before the world is called stuck.
const EVENTS_AT_ONCE: u32 = 4096;

impl<S: Scalar, const D: usize, R: Rule<S>> World<'_, S, D, R> {
    /// The next event happens; none if nothing will ever happen again.
    ///
    /// # Errors
    /// [`Fault::Stuck`], [`Fault::OutsideTable`], [`Fault::BadRule`], [`Fault::NotFinite`].
    pub fn step(&mut self) -> Result<Option<Happening<S>>, Fault> {
        self.step_watched(&mut ())
    }

    /// As [`World::step`], watched.
    ///
    /// # Errors
    /// As [`World::step`].
    pub fn step_watched(
        &mut self,
        watch: &mut impl Watch<S, D>,
    ) -> Result<Option<Happening<S>>, Fault> {
        self.step_until(S::NEVER, watch)
    }

    /// Everything up to and including this instant happens, and it becomes the present: exactly, or as
    /// nearly before it as `S` can tell.
    ///
    /// It does not matter in how many calls one gets there: the state is the same to the last bit.
    ///
    /// # Errors
    /// As [`World::step`], and [`Fault::Past`].
    pub fn advance_to(&mut self, instant: impl Into<Instant>) -> Result<(), Fault> {
        self.advance_watched(instant, &mut ())
    }

    /// As [`World::advance_to`], watched.
    ///
    /// # Errors
    /// As [`World::advance_to`].
    pub fn advance_watched(
        &mut self,
        instant: impl Into<Instant>,
        watch: &mut impl Watch<S, D>,
    ) -> Result<(), Fault> {
        let asked = instant.into();
        let now = self.now();
        if asked < now {
            return Err(Fault::Past { asked, now });
        }
        let mut epoch = self.scene.epoch;
        let mut limit = asked.span_since(epoch);
        while self.step_until(limit, watch)?.is_some() {
            if self.scene.epoch != epoch {
                epoch = self.scene.epoch;
                limit = asked.span_since(epoch);
            }
        }
        loop {
            let span: S = asked.span_since(self.scene.epoch);
            self.scene.now = self.scene.now.larger(span.smaller(S::LATE));
            if !(span > S::LATE) {
                return Ok(());
            }
            self.set_clocks_back(self.scene.now);
            self.predict_all();
        }
    }

    /// The next event that is due by `limit` happens.
    fn step_until(
        &mut self,
        limit: S,
        watch: &mut impl Watch<S, D>,
    ) -> Result<Option<Happening<S>>, Fault> {
        let Some((grain, slot)) = self.due(limit) else { return Ok(None) };
        self.move_clock(grain, &slot)?;
        let mut happening =
            Happening { at: self.now(), grain, partner: slot.with(), kind: slot.kind, deed: None };
        watch.before(&happening, View { scene: &self.scene });
        let mut affected = Affected::default();
        happening.deed = Some(self.apply(grain, &slot, &mut affected)?);
        self.reschedule(&affected)?;
        if slot.kind == Kind::Wander {
            if S::RANGE.is_some() {
                self.still_a_number(grain)?;
            }
            let next = self.predict_ahead(grain, slot);
            self.queue.set(grain, next);
        }
        watch.after(&happening, View { scene: &self.scene });
        self.keep_time(slot.kind);
        Ok(Some(happening))
    }

    /// The earliest event, if it is due by `limit`; void ones are predicted anew on the way.
    fn due(&mut self, limit: S) -> Option<(usize, Slot<S>)> {
        loop {
            let grain = self.queue.first()?;
            let slot = self.queue.slot(grain);
            if slot.kind == Kind::Nothing || !(slot.time <= limit) {
                return None;
            }
            let stale = match order::fastest(&self.scene, &self.queue, grain, &slot) {
                Ok(fastest) => {
                    let first = self.queue.slot(fastest);
                    let faster = fastest != grain && first.kind == Kind::Meet;
                    self.scene.counters.reordered += u64::from(faster);
                    return Some((fastest, first));
                }
                Err(stale) => stale,
            };
            let grain = stale;
            self.scene.counters.stale += 1;
            self.scene.now = self.scene.now.larger(slot.time);
            let slot = self.predict(grain);
            self.queue.set(grain, slot);
        }
    }

    /// The event's time becomes the present, which never goes back; too many before time moves on
    /// visibly, by 2^−48 of the world's age, are a fault.
    fn move_clock(&mut self, grain: usize, slot: &Slot<S>) -> Result<(), Fault> {
        self.scene.now = self.scene.now.larger(slot.time);
        self.at_once = self.at_once.saturating_add(1);
        let grains = u32::try_from(self.scene.bodies.len()).unwrap_or(u32::MAX);
        if self.at_once <= EVENTS_AT_ONCE.saturating_mul(grains) {
            return Ok(());
        }
        let (at, events) = (self.now(), self.at_once);
        if !at.is_visibly_after(self.mark) {
            return Err(Fault::Stuck { grain, with: slot.with(), at, events });
        }
        (self.mark, self.at_once) = (at, 0);
        Ok(())
    }

    fn apply(
        &mut self,
        grain: usize,
        slot: &Slot<S>,
        affected: &mut Affected,
    ) -> Result<Deed<S>, Fault> {
        let scene = &mut self.scene;
        match slot.kind {
            Kind::Meet => apply::meet(scene, &self.rule, grain, slot.partner, affected),
            Kind::Release => Ok(apply::release(scene, grain, affected)),
            Kind::TakeOff => Ok(wake::take_off(scene, grain, affected)),
            Kind::Check => Ok(wake::check(scene, grain, affected)),
            Kind::Wander | Kind::Nothing => Ok(apply::wander(scene, grain, slot.face)),
        }
    }

    /// Predicts the next events of the grains that an event concerned, and checks that they still can be
    /// computed with. What lies on a grain that was at rest until now looks whether it is still held.
    fn reschedule(&mut self, affected: &Affected) -> Result<(), Fault> {
        for &grain in &affected.again {
            self.still_a_number(grain)?;
            let slot = self.predict(grain);
            self.queue.set(grain, slot);
        }
        for &grain in &affected.woken {
            let cell = self.scene.body(grain).map_or(0, |body| body.cell);
            let (scene, queue) = (&self.scene, &mut self.queue);
            scene.cells.near(cell, |k| {
                if support::lies_on(scene, k, grain) {
                    queue.set(k, Slot::alone(scene.now, Kind::Check));
                }
            });
        }
        Ok(())
    }

    /// Whether a grain can still be computed with: now, too, if its number type has a range to leave.
    fn still_a_number(&self, grain: usize) -> Result<(), Fault> {
        let scene = &self.scene;
        let broken = match S::RANGE {
            Some(_) => apply::broken(&scene.present(grain)),
            None => scene.body(grain).and_then(apply::broken),
        };
        match (broken, S::RANGE) {
            (None, _) => Ok(()),
            (Some(field), None) => Err(Fault::NotFinite { grain, field, at: self.now() }),
            (Some(field), Some(most)) => {
                Err(Fault::overflow(Subject::Grain(grain), field, most.to_f64()))
            }
        }
    }

    /// Nothing happens before this instant; none if nothing will ever happen. Firmware can sleep until then.
    #[must_use]
    pub fn next_event_time(&self) -> Option<Instant> {
        let slot = self.queue.slot(self.queue.first()?);
        (slot.time < S::NEVER).then(|| self.scene.epoch + Instant::from(slot.time))
    }

    /// The present.
    #[must_use]
    pub fn now(&self) -> Instant {
        self.scene.instant()
    }

    /// A grain as it is now, in the order in which grains were added.
    #[must_use]
    pub fn grain(&self, index: usize) -> Option<Grain<S, D>> {
        self.view().grain(index)
    }

    /// How often everything happened.
    #[must_use]
    pub fn counters(&self) -> &Counters {
        &self.scene.counters
    }

    /// The world to look at.
    #[must_use]
    pub fn view(&self) -> View<'_, S, D> {
        View { scene: &self.scene }
    }
}
