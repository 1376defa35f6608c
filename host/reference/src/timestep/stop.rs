//! How far does a run in fixed steps go? Reads a time, or contacts and free flights; goes on until then, or until nothing more comes.

use super::gear::Gear;
use super::verlet::Verlet;
use crate::error::ReferenceError;
use crate::quiet::{Quiet, Stop, all_separated};

/// Molecular dynamics in fixed steps, by whatever scheme.
trait Steps<const D: usize> {
    /// Positions, velocities and clock.
    fn state(&self) -> &Verlet<D>;

    /// Goes on to an instant.
    fn come_to(&mut self, t: f64) -> Result<(), ReferenceError>;
}

impl<const D: usize> Steps<D> for Verlet<D> {
    fn state(&self) -> &Self {
        self
    }

    fn come_to(&mut self, t: f64) -> Result<(), ReferenceError> {
        self.advance_to(t)
    }
}

impl<const D: usize> Steps<D> for Gear<D> {
    fn state(&self) -> &Verlet<D> {
        &self.state
    }

    fn come_to(&mut self, t: f64) -> Result<(), ReferenceError> {
        self.advance_to(t)
    }
}

fn advance_until_quiet<const D: usize>(
    scheme: &mut impl Steps<D>,
    quiet: Quiet,
) -> Result<Stop, ReferenceError> {
    loop {
        if let Some(stop) = scheme.state().over(quiet) {
            return Ok(stop);
        }
        let t = scheme.state().next_look(quiet);
        scheme.come_to(t)?;
    }
}

impl<const D: usize> Verlet<D> {
    /// Goes on until all fly apart for good, or no contact has existed for some time.
    ///
    /// That is looked at about once a contact time, so the run stops a little late. A contact whose
    /// force changes velocities by less than 1e-6 of the fastest one counts as none.
    ///
    /// # Errors
    ///
    /// As [`Verlet::advance_to`].
    pub fn advance_until_quiet(&mut self, quiet: Quiet) -> Result<Stop, ReferenceError> {
        advance_until_quiet(self, quiet)
    }

    /// Whether there is a contact now whose force, over a contact time, changes a velocity by more
    /// than 1e-6 of the fastest one.
    pub fn in_contact(&self) -> bool {
        self.pushed
    }

    fn next_look(&self, quiet: Quiet) -> f64 {
        (self.now + self.step * self.options.steps_per_contact).min(quiet.limit)
    }

    fn over(&self, quiet: Quiet) -> Option<Stop> {
        let touches = self.pushed;
        if !touches && all_separated(&self.grains(), &self.boundary, &self.gravity) {
            return Some(Stop::Separated);
        }
        if !touches && self.now - self.touched.max(0.0) > quiet.interval {
            return Some(Stop::Quiet);
        }
        (self.now >= quiet.limit).then_some(Stop::Limit)
    }
}

impl<const D: usize> Gear<D> {
    /// Goes on to time t in equal steps, none longer than [`Gear::time_step`].
    ///
    /// # Errors
    ///
    /// As [`Verlet::advance_to`].
    pub fn advance_to(&mut self, t: f64) -> Result<(), ReferenceError> {
        if !(t.is_finite() && t >= self.state.now) {
            return Err(ReferenceError::parameter("t", t, "finite and at least the present time"));
        }
        while self.state.now < t {
            let left = t - self.state.now;
            let count = (left / self.state.step).ceil().max(1.0);
            let done = self.take_steps(count as u64, left / count);
            let state = &mut self.state;
            let arrived = done == count as u64;
            state.now = if arrived { t } else { state.now + done as f64 * left / count };
            state.clock = state.now;
            if !state.fastest.is_finite() {
                let why = "its velocity is no longer finite";
                return Err(ReferenceError::Unresolved { time: state.now, grain: 0, why });
            }
        }
        Ok(())
    }

    /// Whether there is a contact now whose force, over a contact time, changes a velocity by more
    /// than 1e-6 of the fastest one.
    pub fn in_contact(&self) -> bool {
        self.state.in_contact()
    }

    /// As [`Verlet::advance_until_quiet`].
    ///
    /// # Errors
    ///
    /// As [`Verlet::advance_to`].
    pub fn advance_until_quiet(&mut self, quiet: Quiet) -> Result<Stop, ReferenceError> {
        advance_until_quiet(self, quiet)
    }
}
