//! What may a user change of a grain between events? Its velocity, and whether it is there; reads and writes the grain, its contact and who lies on it.

use super::state::World;
use super::{check_input, check_rotation, check_scales};
use crate::cluster;
use crate::detect::ScheduledEvent;
use crate::error::{Error, Subject};
use crate::law::Rule;
use crate::particle::{Body, Grain};
use crate::resolve::{self, Context, Effects};
use crate::scalar::{Scalar, Vector, norm};

impl<S: Scalar, const D: usize, R: Rule<S>> World<'_, S, D, R> {
    /// Gives a grain another velocity now, between events: a kick, a thermostat, a thermal wall after
    /// [`World::step`] has told that a grain hit it.
    ///
    /// A contact of two that the grain is in goes on by forces, or ends in the papers' mode as if a third body had
    /// come; who sleeps on the grain wakes.
    ///
    /// # Units
    /// Length over time.
    ///
    /// # Errors
    /// [`Error::Input`] if there is no such grain, or the velocity is not finite or does not fit the number type.
    ///
    /// ```
    /// use carom::{Grain, Memory, World, law::HardSphere};
    /// let mut memory = Memory::<f64, 1, 2>::new();
    /// let mut world = World::builder(&mut memory)
    ///     .rule(HardSphere { restitution: 1.0 })
    ///     .grain(Grain::with_mass(0.5, 1.0))?
    ///     .grain(Grain::with_mass(0.5, 1.0).at([3.0]))?
    ///     .start()?;
    /// world.set_velocity(0, [1.0])?;
    /// world.advance_to(3.0)?;
    /// assert_eq!(world.grain(1).unwrap().velocity[0], 1.0);
    /// # Ok::<(), carom::Error>(())
    /// ```
    pub fn set_velocity(&mut self, grain: usize, velocity: [S; D]) -> Result<(), Error> {
        let body = self.occupied(grain)?;
        let velocity = Vector::from(velocity);
        check_input::finite(Subject::Grain(grain), "velocity", &velocity)?;
        let changed = Body { velocity, ..body };
        let gravity = self.domain.gravity();
        check_scales::scales(&self.domain.boundary, gravity, (grain, &[changed]))?;
        let mut effects = Effects::default();
        self.set_free(grain, &mut effects)?;
        let body = Body { velocity, ..self.particles.present(grain, &self.domain, self.clock.now) };
        let body =
            if body.is_clustered() { body } else { Body { consecutive_collisions: 0, ..body } };
        self.particles.replace(&self.domain.boundary, grain, body);
        if body.is_clustered() {
            self.clusters.speed = self.clusters.speed.max(norm(&velocity));
            self.shorten_step();
        }
        effects.predict_anew(grain);
        self.settle_effects(&effects)
    }

    /// Puts one more grain into an empty place ([`WorldBuilder::reserve`](super::WorldBuilder::reserve), or one that
    /// was removed), now, between events; returns its number.
    ///
    /// # Errors
    /// [`Error::Full`] without an empty place. [`Error::Input`] for a field of the grain; its radius may not be larger
    /// than the largest at the start, and it needs the same kind of contacts: cells are made for both.
    /// [`Error::Overlap`] where another body is. Nothing has changed then.
    pub fn add(&mut self, grain: Grain<S, D>) -> Result<usize, Error> {
        let capacity = self.particles.bodies.len();
        let knob = "empty places for grains (WorldBuilder::reserve)";
        let place = self.particles.bodies.iter().position(Body::is_vacant);
        let place = place.ok_or(Error::Full { knob, capacity })?;
        let body = self.checked(&grain, place)?;
        if self.clusters.count > 0 && self.clusters.time < self.clock.now {
            self.cut_step()?;
        }
        let event_count = self.particles.body(place).map_or(0, |body| body.event_count);
        self.particles.occupy(place, Body { event_count, ..body });
        let others = |k| k != place;
        let who = (place, &self.particles.present(place, &self.domain, self.clock.now));
        let free =
            check_input::overlaps_of(&self.particles, &self.domain, who, self.clock.now, others);
        let settings = self.parameters.settings.with_grain(
            &self.rule,
            &body,
            (self.particles.bodies, &self.domain.boundary),
        );
        let fits = settings.sight() == self.parameters.settings.sight();
        let suits = check_rotation::mode(&self.rule, &settings);
        if free.is_err() || suits.is_err() || !fits {
            self.particles.vacate(place, self.clock.now);
            free?;
            suits?;
            let wanted = "one whose contacts last or do not, as those of all grains at the start";
            let material = f64::from(grain.material);
            return Err(Error::input(Subject::Grain(place), "material", material, wanted));
        }
        self.parameters.settings = settings;
        let mut effects = Effects::default();
        effects.predict_anew(place);
        self.settle_effects(&effects).map(|()| place)
    }

    /// Takes a grain out of the world now, between events. Its place, and with it the numbers of the others, stays;
    /// the next that is [added](World::add) gets the first empty one.
    ///
    /// # Errors
    /// [`Error::Input`] if there is no such grain.
    pub fn remove(&mut self, grain: usize) -> Result<Grain<S, D>, Error> {
        self.occupied(grain)?;
        let mut effects = Effects::default();
        self.set_free(grain, &mut effects)?;
        // Who lies on it looks for it before it is gone, and finds out afterwards.
        self.settle_effects(&effects)?;
        let taken = self.view().grain(grain);
        if self.particles.body(grain).is_some_and(Body::is_clustered) {
            cluster::leave(&mut self.particles, &mut self.clusters, (grain, self.clock.now));
        }
        self.particles.vacate(grain, self.clock.now);
        self.forget_rotation(grain);
        self.queue.set(grain, ScheduledEvent::NONE);
        Ok(taken.unwrap_or_else(|| Body::default().as_grain()))
    }

    /// A grain that there is.
    fn occupied(&self, grain: usize) -> Result<Body<S, D>, Error> {
        let body = self.particles.body(grain).filter(|body| !body.is_vacant());
        let wanted = "that of a grain that is there";
        body.copied().ok_or(Error::input(Subject::Grain(grain), "number", grain as f64, wanted))
    }

    /// A grain that may be put into this place, if nobody else is there.
    fn checked(&self, grain: &Grain<S, D>, place: usize) -> Result<Body<S, D>, Error> {
        check_input::grain(grain, place)?;
        let subject = Subject::Grain(place);
        if !(grain.radius <= self.particles.largest_radius) {
            let wanted = "at most the largest radius at the start";
            return Err(Error::input(subject, "radius", grain.radius.to_f64(), wanted));
        }
        let boundary = &self.domain.boundary;
        let mut body = Body { clock: self.clock.now, ..Body::new(grain) };
        let [position, velocity] =
            boundary.image_inside([body.position, body.velocity], self.clock.now);
        (body.position, body.velocity) = (boundary.to_lattice(position), velocity);
        check_input::inside(boundary, place, &body)?;
        check_scales::scales(boundary, self.domain.gravity(), (place, &[body]))?;
        Ok(body)
    }

    /// Ends the contact that a grain is in, and wakes it and those that lie on it.
    fn set_free(&mut self, grain: usize, effects: &mut Effects) -> Result<(), Error> {
        let is_integrated = self.parameters.settings.is_integrated(&self.rule);
        let mut context = Context {
            particles: &mut self.particles,
            domain: &self.domain,
            clock: &self.clock,
            parameters: &mut self.parameters,
            clusters: &mut self.clusters,
            effects,
        };
        let body = context.present(grain);
        if !is_integrated {
            if body.in_contact() {
                resolve::end_contact(&mut context, grain);
            }
            if body.is_supported() {
                resolve::let_go(&mut context, grain);
            }
            return Ok(());
        }
        if body.in_contact() {
            resolve::cluster_contact(&mut context, &self.rule, grain);
        } else if body.is_asleep() {
            context.join(grain);
        }
        while let Some(sleeper) = sleeper_at(&context, grain) {
            context.join(sleeper);
        }
        if self.clusters.count > 0 {
            self.cut_step()?;
        }
        Ok(())
    }

    /// Predicts what a change between events concerns.
    fn settle_effects(&mut self, effects: &Effects) -> Result<(), Error> {
        self.progress.at_once = [0; 2];
        self.statistics.count(&effects.incidents);
        self.predict_affected(effects)
    }
}

/// The first of those that sleep and touch a grain, or are so near that they may lie on it.
fn sleeper_at<S: Scalar, const D: usize>(
    context: &Context<'_, '_, S, D>,
    grain: usize,
) -> Option<usize> {
    let me = context.particles.body(grain)?;
    let here = context.present(grain);
    let mut first = None::<usize>;
    context.particles.cells.for_each_near(me.cell, me.radius, |k| {
        let Some(other) = context.particles.body(k).filter(|other| other.is_asleep()) else {
            return;
        };
        let apart = context.domain.separation(&here, other, context.now());
        let reach = (me.radius + other.radius) * (S::one() + S::from_f32(1.0 / 64.0));
        let touches = S::dot(&apart, &apart) < reach.times(reach);
        if touches && k != grain && first.is_none_or(|first| k < first) {
            first = Some(k);
        }
    });
    first
}
