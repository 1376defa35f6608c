//! How is a world described one thing after the other? Reads a thing, checks it at once; writes the builder.
//!
//! The chain of [`WorldBuilder`]'s other methods is taken by value and tells at its end what was wrong. Who is asked
//! from outside, by C or by a user at a prompt, answers each call: an error leaves the description as it was.

use super::builder::WorldBuilder;
use super::check_input;
use crate::error::{Error, Subject};
use crate::law::Rule;
use crate::scalar::{Scalar, Vector};
use crate::space::{PeriodicAxis, Plane, Surface};

impl<S: Scalar, const D: usize, R> WorldBuilder<'_, S, D, R> {
    /// As [`WorldBuilder::plane`], and says its number.
    ///
    /// # Errors
    /// [`Error::Input`] for what `start` would refuse, [`Error::Full`] if there is no place for it. Nothing has changed
    /// then, here and in all that follows.
    pub fn add_plane(&mut self, plane: Plane<S, D>) -> Result<usize, Error> {
        let (plane, number) = (plane.with_unit_normal(), self.boundary.planes().len());
        check_input::plane(&plane, number)?;
        if self.boundary.add_plane(plane) { Ok(number) } else { Err(self.too_many_planes()) }
    }

    /// A box of plane walls, `[low, high]` along each axis: all of them, or none.
    ///
    /// # Errors
    /// [`Error::Input`] for an interval or a surface that is none, [`Error::Full`] if there are not places for all.
    pub fn add_walls(&mut self, sides: [[S; 2]; D], surface: Surface<S>) -> Result<(), Error> {
        if self.boundary.capacity() < self.boundary.planes().len() + 2 * D {
            return Err(self.too_many_planes());
        }
        for (axis, [low, high]) in sides.into_iter().enumerate() {
            let length = high - low;
            if !(length > S::zero() && length.is_finite()) {
                let (value, wanted) = (length.to_f64(), "finite and above 0");
                return Err(Error::input(Subject::Axis(axis), "length", value, wanted));
            }
        }
        for (axis, [low, high]) in sides.into_iter().enumerate() {
            self.add_plane(Plane::across(axis, low, true, surface))?;
            self.add_plane(Plane::across(axis, high, false, surface))?;
        }
        Ok(())
    }

    /// As [`WorldBuilder::periodic_axis`].
    ///
    /// # Errors
    /// [`Error::Input`] for an axis that is none or an interval that is none. That it is long enough for the largest
    /// grain is checked by `start`.
    pub fn set_periodic_axis(&mut self, axis: usize, [low, high]: [S; 2]) -> Result<(), Error> {
        let subject = Subject::Axis(axis);
        if axis >= D {
            return Err(Error::input(subject, "axis", axis as f64, "the number of an axis"));
        }
        let length = high - low;
        if !(length > S::zero() && length.is_finite()) {
            return Err(Error::input(subject, "length", length.to_f64(), check_input::LENGTH));
        }
        self.boundary.set_periodic(axis, PeriodicAxis { low, length });
        Ok(())
    }

    /// As [`WorldBuilder::gravity`].
    ///
    /// # Errors
    /// [`Error::Input`] if a component is not finite, [`Error::Overflow`] if one does not fit a fixed-point number.
    pub fn set_gravity(&mut self, gravity: [S; D]) -> Result<(), Error> {
        let gravity = Vector::from(gravity);
        check_input::finite(Subject::World, "gravity", &gravity)?;
        self.gravity = gravity;
        Ok(())
    }

    /// As [`WorldBuilder::contact_time`].
    ///
    /// # Errors
    /// [`Error::Input`] if it is not finite and above 0. Whether it is too long is checked by `start`.
    pub fn set_contact_time(&mut self, time: S) -> Result<(), Error> {
        if !(time > S::zero() && time.is_finite()) {
            let wanted = "finite and above 0";
            return Err(Error::input(Subject::World, "contact time", time.to_f64(), wanted));
        }
        self.settings.contact_time = Some(time);
        Ok(())
    }

    /// As [`WorldBuilder::steps_per_contact`].
    ///
    /// # Errors
    /// [`Error::Input`] if it is not between 8 and 131,072; in fixed point 16,384, so that its numbers hold it.
    pub fn set_steps_per_contact(&mut self, steps: u32) -> Result<(), Error> {
        let most = if S::RANGE.is_some() { 16_384 } else { 131_072 };
        if !(8..=most).contains(&steps) {
            let (steps, wanted) = (f64::from(steps), "between 8 and 131072 (fixed point: 16384)");
            return Err(Error::input(Subject::World, "steps per contact", steps, wanted));
        }
        self.settings.steps = S::from_count(steps);
        Ok(())
    }
}

impl<S: Scalar, const D: usize, R: Rule<S>> WorldBuilder<'_, S, D, R> {
    /// Another rule of the same type in place of the one that is there.
    ///
    /// # Errors
    /// [`Error::Input`] that names the parameter.
    pub fn set_rule(&mut self, rule: R) -> Result<(), Error> {
        rule.check()?;
        self.rule = rule;
        Ok(())
    }

    /// Whether [`WorldBuilder::start`] would start; it takes the description with it if it does not.
    ///
    /// ```
    /// # use carom::{Grain, Memory, World, law::HardSphere};
    /// let mut memory = Memory::<f32, 1, 8>::new();
    /// let mut beads = World::builder(&mut memory).rule(HardSphere { restitution: 0.9 });
    /// beads.add_grain(Grain::with_mass(0.5, 1.0))?;
    /// assert!(beads.check().is_ok());
    /// beads.add_grain(Grain::with_mass(0.5, 1.0).at([0.25]))?;
    /// assert!(matches!(beads.check(), Err(carom::Error::Overlap { grain: 1, .. })));
    /// # Ok::<(), carom::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`WorldBuilder::start`].
    pub fn check(&mut self) -> Result<(), Error>
    where
        R: Clone,
    {
        let world = self.lent().build()?;
        check_input::overlaps(&world.particles, &world.domain, world.clock.now)
    }

    /// The same description, its memory lent for a while.
    fn lent(&mut self) -> WorldBuilder<'_, S, D, R>
    where
        R: Clone,
    {
        WorldBuilder {
            buffers: self.buffers.lent(),
            count: self.count,
            boundary: self.boundary.lent(),
            gravity: self.gravity,
            shear: self.shear,
            release: self.release,
            t_c: self.t_c,
            settings: self.settings,
            rule: self.rule.clone(),
            error: self.error,
        }
    }
}
