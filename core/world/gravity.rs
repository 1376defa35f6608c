//! What changes when gravity does? Reads and writes the whole state between events.

use super::check_scales;
use super::state::World;
use crate::error::{Error, Subject};
use crate::law::Rule;
use crate::resolve::{Context, Effects, continue_contact, min_hop_time};
use crate::scalar::{Scalar, Vector, all_finite};

impl<S: Scalar, const D: usize, R: Rule<S>> World<'_, S, D, R> {
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
        check_scales::gravity(&gravity, self.particles.largest_radius)?;
        if gravity == *self.domain.gravity() {
            return Ok(());
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
            parameters: &mut self.parameters,
            effects: &mut effects,
        };
        for i in 0..context.particles.bodies.len() {
            continue_contact(&mut context, i, before);
        }
    }
}
