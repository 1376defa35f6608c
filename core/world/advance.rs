//! How far does a world advance? To an instant, to the next event before one, or as far as a budget of events allows.
//!
//! Reads the queue; writes the world.

use super::observe::{Event, Observer};
use super::state::World;
use crate::error::{Error, Subject};
use crate::law::Rule;
use crate::resolve::EventOutcome;
use crate::scalar::{Instant, IntoInstant, Scalar};

impl<S: Scalar, const D: usize, R: Rule<S>> World<'_, S, D, R> {
    /// Everything up to and including this instant happens, and it becomes the present: exactly, or as
    /// nearly before it as `S` can tell.
    ///
    /// It does not matter in how many calls one gets there: the state is the same to the last bit.
    ///
    /// # Errors
    /// As [`World::step`]; [`Error::Past`]; [`Error::Input`] for a time that is not finite.
    pub fn advance_to(&mut self, instant: impl IntoInstant) -> Result<(), Error> {
        self.advance_observed(instant, &mut ())
    }

    /// As [`World::advance_to`], observed.
    ///
    /// # Errors
    /// As [`World::advance_to`].
    pub fn advance_observed(
        &mut self,
        instant: impl IntoInstant,
        observer: &mut impl Observer<S, D>,
    ) -> Result<(), Error> {
        let asked = self.not_past(instant)?;
        self.advance(asked, None, observer).map(drop)
    }

    /// As [`World::advance_to`], but after so many events it stops: false if it has not arrived then.
    ///
    /// Called again until it arrives, it ends in the same state to the last bit. Cell crossings and
    /// rechecks are events here: what is bounded is work.
    ///
    /// ```
    /// # use carom::{Grain, Memory, World, law::HardSphere};
    /// # let mut memory = Memory::<f32, 2, 1>::new();
    /// # let mut world = World::builder(&mut memory)
    /// #     .walls([[0.0, 1.0]; 2])
    /// #     .rule(HardSphere { restitution: 1.0 })
    /// #     .grain(Grain::with_mass(0.1, 1.0).at([0.5, 0.5]).moving([3.0, 2.0]))?
    /// #     .start()?;
    /// // One frame: physics takes its share, and slows down where there is too much to do.
    /// if !world.advance_with_budget(0.025, 200)? {
    ///     // not there yet: draw, and go on in the next frame
    /// }
    /// # Ok::<(), carom::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`World::advance_to`].
    pub fn advance_with_budget(
        &mut self,
        instant: impl IntoInstant,
        events: u32,
    ) -> Result<bool, Error> {
        self.advance_observed_with_budget(instant, events, &mut ())
    }

    /// As [`World::advance_with_budget`], observed.
    ///
    /// # Errors
    /// As [`World::advance_to`].
    pub fn advance_observed_with_budget(
        &mut self,
        instant: impl IntoInstant,
        events: u32,
        observer: &mut impl Observer<S, D>,
    ) -> Result<bool, Error> {
        let asked = self.not_past(instant)?;
        self.advance(asked, Some(events), observer)
    }

    /// The next event that changes a trajectory happens, if it is not later than this instant; else the
    /// instant becomes the present.
    ///
    /// # Errors
    /// As [`World::advance_to`].
    pub fn step_until(&mut self, instant: impl IntoInstant) -> Result<Option<Event<S>>, Error> {
        self.step_until_observed(instant, &mut ())
    }

    /// As [`World::step_until`], observed.
    ///
    /// # Errors
    /// As [`World::advance_to`].
    pub fn step_until_observed(
        &mut self,
        instant: impl IntoInstant,
        observer: &mut impl Observer<S, D>,
    ) -> Result<Option<Event<S>>, Error> {
        let asked = self.not_past(instant)?;
        loop {
            let Some(event) = self.step_within(asked.span_since(self.clock.epoch), observer)?
            else {
                self.arrive(asked);
                return Ok(None);
            };
            let changed = !matches!(
                event.outcome,
                Some(EventOutcome::CellCrossed | EventOutcome::Unchanged) | None
            );
            if changed {
                return Ok(Some(event));
            }
        }
    }

    /// The instant that is meant, if it can still be reached.
    fn not_past(&self, instant: impl IntoInstant) -> Result<Instant, Error> {
        let asked = instant.into_instant().map_err(|value| {
            Error::input(Subject::World, "time to advance to", value, "a finite number")
        })?;
        let now = self.now();
        if asked < now { Err(Error::Past { asked, now }) } else { Ok(asked) }
    }

    /// Whether the world has arrived there before its budget of events, if it has one, was used up.
    fn advance(
        &mut self,
        asked: Instant,
        mut budget: Option<u32>,
        observer: &mut impl Observer<S, D>,
    ) -> Result<bool, Error> {
        let mut epoch = self.clock.epoch;
        let mut limit = asked.span_since(epoch);
        loop {
            if budget == Some(0) {
                return Ok(false);
            }
            if self.step_within(limit, observer)?.is_none() {
                break;
            }
            budget = budget.map(|events| events - 1);
            if self.clock.epoch != epoch {
                epoch = self.clock.epoch;
                limit = asked.span_since(epoch);
            }
        }
        self.arrive(asked);
        Ok(true)
    }

    /// Nothing happens any more before this instant: it becomes the present.
    fn arrive(&mut self, asked: Instant) {
        loop {
            let span: S = asked.span_since(self.clock.epoch);
            self.clock.move_to(span.min(S::LATE));
            if !(span > S::LATE) {
                return;
            }
            self.set_clocks_back(self.clock.now);
            self.predict_all();
        }
    }
}
