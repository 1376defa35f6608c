//! What changes when gravity does? Reads and writes the whole state between events.

use super::state::World;
use super::{check_input, check_scales};
use crate::cluster;
use crate::error::{Error, Subject};
use crate::law::Rule;
use crate::resolve::{self, Context, Effects, continue_contact, min_hop_time};
use crate::scalar::{Scalar, Vector, all_finite, norm};

impl<S: Scalar, const D: usize, R: Rule<S>> World<'_, S, D, R> {
    /// Changes gravity now: between events, in the middle of contacts too. All events are predicted anew.
    ///
    /// # Errors
    /// [`Error::Input`] if a component is not finite; [`Error::LongContact`]. Nothing has changed then.
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
        check_input::sheared(&self.domain.boundary, &gravity)?;
        if gravity == *self.domain.gravity() {
            return Ok(());
        }
        if self.parameters.settings.is_integrated(&self.rule) {
            self.parameters.settings.check_contact_time(&gravity)?;
            return self.change_gravity(gravity);
        }
        self.set_clocks_back(self.clock.now);
        self.progress.at_once = [0; 2];
        let before = *self.domain.gravity();
        self.domain.set_gravity(gravity);
        self.parameters.min_hop_time = min_hop_time(&gravity, self.particles.largest_radius);
        self.wake_all();
        self.continue_contacts(&before);
        self.predict_all();
        Ok(())
    }

    /// The same where contacts are integrated: those with a plane go on by forces, and sleepers wake unless
    /// the change is less than what their contacts can take.
    fn change_gravity(&mut self, gravity: Vector<S, D>) -> Result<(), Error> {
        self.cluster_wall_contacts();
        if self.clusters.count > 0 && self.clusters.time < self.clock.now {
            self.cut_step()?;
        }
        self.set_clocks_back(self.clock.now);
        self.progress.at_once = [0; 2];
        self.domain.set_gravity(gravity);
        self.parameters.settings.take_gravity(&gravity, S::zero());
        let (now, change) = (self.clock.now, norm(&(gravity - self.parameters.settled_gravity)));
        if change > norm(&self.parameters.settled_gravity) * S::from_f64(0.005) {
            self.parameters.settled_gravity = gravity;
            cluster::wake(&mut self.particles, &self.domain, &mut self.clusters, now);
        }
        if self.clusters.count > 0 {
            self.cut_step()?;
        }
        self.predict_all();
        Ok(())
    }

    /// Contacts of two with a plane feel gravity: grains in one are clustered, as they are now.
    fn cluster_wall_contacts(&mut self) {
        let mut effects = Effects::default();
        let mut context = Context {
            particles: &mut self.particles,
            domain: &self.domain,
            clock: &self.clock,
            parameters: &mut self.parameters,
            clusters: &mut self.clusters,
            effects: &mut effects,
        };
        for i in 0..context.particles.bodies.len() {
            let body = context.particles.body(i);
            if body.is_some_and(|body| body.partner.as_plane().is_some()) {
                resolve::cluster_contact(&mut context, &self.rule, i);
            }
        }
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
            clusters: &mut self.clusters,
            effects: &mut effects,
        };
        for i in 0..context.particles.bodies.len() {
            continue_contact(&mut context, i, before);
        }
    }
}
