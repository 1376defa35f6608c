//! When are clocks set back, and what changes with gravity? Reads and writes the whole state between events.

use super::World;
use crate::event::scene::Scene;
use crate::event::{Kind, contact, support};
use crate::fault::{Fault, Subject};
use crate::law::Rule;
use crate::matter::{Field, flight};
use crate::number::{Instant, Scalar, Vector, all_numbers};

/// So many times as many looks around as events end an epoch, too.
const WANDERS: u32 = 64;

impl<S: Scalar, const D: usize, R: Rule<S>> World<'_, S, D, R> {
    /// Sets the clocks back by the leading digits of now once enough events have happened, so that times
    /// stay small and their last place fine, and predicts everything anew from there.
    ///
    /// Looks around are no events here, unless there is little else: when clocks are set back must not
    /// depend on how neighbours are found.
    pub(super) fn keep_time(&mut self, kind: Kind) {
        let count = if kind == Kind::Wander { &mut self.wanders } else { &mut self.since_epoch };
        *count = count.saturating_add(1);
        let grains = u32::try_from(self.scene.bodies.len()).unwrap_or(u32::MAX);
        let enough = S::EVENTS_PER_EPOCH.saturating_mul(grains).saturating_add(8);
        let due = self.since_epoch >= enough || self.wanders >= enough.saturating_mul(WANDERS);
        let late = self.scene.now > S::LATE;
        if !((due || late) && self.scene.now > S::zero()) {
            return;
        }
        self.set_clocks_back(self.scene.now.leading_digits());
        self.predict_all();
    }

    /// Every grain flies to the present; the epoch moves on by `back`. All events must be predicted anew.
    pub(super) fn set_clocks_back(&mut self, back: S) {
        (self.since_epoch, self.wanders) = (0, 0);
        self.scene.counters.epochs += 1;
        let now = self.scene.now - back;
        let Scene { bodies, gravity, weightless, boundary, now: present, .. } = &mut self.scene;
        let field = Field { gravity, weightless: *weightless, boundary };
        for body in bodies.iter_mut() {
            flight::advance(body, field, *present);
            body.clock = now;
            if body.release_at < S::NEVER {
                body.release_at -= back;
            }
            if body.moment > -S::NEVER {
                let moment = body.moment - back;
                body.moment = if moment.is_number() { moment } else { -S::NEVER };
            }
        }
        self.scene.now = now;
        self.scene.epoch = self.scene.epoch + Instant::from(back);
        self.scene.boundary.start_epoch(self.scene.epoch);
    }

    /// Changes gravity now: between events, in the middle of contacts too. All events are predicted anew.
    ///
    /// # Errors
    /// [`Fault::Input`] if a component is not finite.
    pub fn set_gravity(&mut self, gravity: [S; D]) -> Result<(), Fault> {
        let gravity = Vector::from(gravity);
        if let Some(most) = S::RANGE.filter(|_| !gravity.iter().all(|x| x.in_range())) {
            return Err(Fault::overflow(Subject::World, "gravity", most.to_f64()));
        }
        if !all_numbers(&gravity) {
            let value = gravity.iter().find(|x| !x.is_number()).map_or(0.0, |x| x.to_f64());
            return Err(Fault::input(Subject::World, "gravity", value, "a finite number"));
        }
        self.set_clocks_back(self.scene.now);
        self.at_once = 0;
        let before = core::mem::replace(&mut self.scene.gravity, gravity);
        self.scene.weightless = flight::is_weightless(&gravity);
        self.scene.hop = support::hop(&gravity, self.scene.largest_radius);
        for body in self.scene.bodies.iter_mut() {
            *body = body.let_go();
        }
        self.scene.held = 0;
        for i in 0..self.scene.bodies.len() {
            contact::goes_on(&mut self.scene, i, &before);
        }
        self.predict_all();
        Ok(())
    }
}
