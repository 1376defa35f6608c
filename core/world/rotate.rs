//! How do a world's grains rotate? Reads and writes angular velocities between events.

use super::check_rotation;
use super::state::World;
use super::view::View;
use crate::error::{Error, Subject};
use crate::law::Rule;
use crate::particle::{Body, Partner};
use crate::scalar::{Axial, Scalar, WideProduct, moment};

impl<S: Scalar, const D: usize, R: Rule<S>> World<'_, S, D, R> {
    /// Gives a grain another angular velocity now, between events. In two dimensions only the last component counts.
    ///
    /// # Units
    /// One over time.
    ///
    /// # Errors
    /// [`Error::Input`] if there is no such grain, it cannot rotate, or a component is not finite.
    pub fn set_angular_velocity(&mut self, grain: usize, velocity: [S; 3]) -> Result<(), Error> {
        let velocity = Axial::from(velocity);
        let there = self.particles.body(grain).is_some_and(|body| !body.is_vacant());
        let rotates = self.particles.rotation.capacity::<D>() > grain;
        if !(there && rotates) {
            let wanted = "that of a grain that is there, under a rule whose grains rotate";
            return Err(Error::input(Subject::Grain(grain), "number", grain as f64, wanted));
        }
        check_rotation::finite(grain, &velocity)?;
        self.particles.rotation.set_velocity::<D>(grain, &velocity);
        self.wake_for_rotation(grain)
    }

    /// q = I/(m R²) of all grains; none where they are smooth.
    #[must_use]
    pub fn inertia(&self) -> Option<S> {
        self.rule.inertia()
    }

    /// Who sleeps does not rotate: it is as if something had hit it.
    fn wake_for_rotation(&mut self, grain: usize) -> Result<(), Error> {
        let body = self.particles.present(grain, &self.domain, self.clock.now);
        if body.is_asleep() { self.set_velocity(grain, body.velocity.into()) } else { Ok(()) }
    }

    /// A grain that is in a cluster no longer is turned by nothing; if it sleeps it does not rotate.
    #[inline(always)]
    pub(super) fn settle_rotation(&mut self, grain: usize) {
        if self.rule.inertia().is_none() {
            return;
        }
        let (particles, zero) = (&mut self.particles, Axial::zeros());
        if particles.body(grain).is_some_and(|body| !body.is_clustered()) {
            particles.rotation.set_free::<D>(grain);
        }
        if particles.body(grain).is_some_and(Body::is_asleep) {
            particles.rotation.set_velocity::<D>(grain, &zero);
        }
    }

    /// A grain that is no longer there does not rotate, and touches nothing.
    #[inline(always)]
    pub(super) fn forget_rotation(&mut self, grain: usize) {
        if self.rule.inertia().is_some() {
            let rotation = &mut self.particles.rotation;
            rotation.set_velocity::<D>(grain, &Axial::zeros());
            rotation.set_free::<D>(grain);
        }
        let is_its =
            |first: usize, second: Partner| first == grain || second.as_grain() == Some(grain);
        if self.rule.inertia().is_some() || self.rule.remembers() {
            self.particles.contacts.forget(is_its);
        }
    }
}

impl<S: Scalar, const D: usize> View<'_, S, D> {
    /// The angular velocity ω of a grain now, about each axis; in two dimensions about the third only. None where
    /// grains do not rotate.
    ///
    /// # Units
    /// One over time.
    #[must_use]
    pub fn angular_velocity(&self, grain: usize) -> Option<[S; 3]> {
        let rotation = &self.particles.rotation;
        let rotates = rotation.capacity::<D>() > grain;
        rotates.then(|| rotation.velocity::<D>(grain).into())
    }

    /// Kinetic energy of rotation Σ q m R² ω²/2, of grains with this q = I/(m R²).
    #[must_use]
    pub fn rotational_energy(&self, inertia: S) -> S {
        let energy = |i: usize| {
            let (body, w) = (self.particles.body(i)?, self.particles.rotation.velocity::<D>(i));
            let speed = w * body.radius;
            Some(S::half() * (inertia * body.mass) * S::dot(&speed, &speed).rounded())
        };
        (0..self.len()).filter_map(energy).fold(S::zero(), |sum, e| sum + e)
    }

    /// Angular momentum about the origin, Σ m r × v + q m R² ω, of grains with this q = I/(m R²). Not conserved across
    /// a periodic boundary.
    #[must_use]
    pub fn angular_momentum(&self, inertia: S) -> [S; 3] {
        let of = |i: usize| {
            let (grain, w) = (self.released(i)?, self.particles.rotation.velocity::<D>(i));
            let spin = w * (inertia * grain.mass * grain.radius * grain.radius);
            Some(moment(&grain.position, &(grain.velocity * grain.mass)) + spin)
        };
        (0..self.len()).filter_map(of).fold(Axial::zeros(), |sum, l| sum + l).into()
    }
}
