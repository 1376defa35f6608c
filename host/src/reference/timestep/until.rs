//! When may a run in fixed steps stop? Reads contacts and free flights; goes on until nothing more comes.

use super::super::error::ReferenceError;
use super::super::quiet::{Quiet, Stop, all_apart};
use super::{Gear, Verlet};

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
        loop {
            if let Some(stop) = self.over(quiet) {
                return Ok(stop);
            }
            self.advance_to(self.next_look(quiet))?;
        }
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
        if !touches && all_apart(&self.grains(), &self.boundary, &self.gravity) {
            return Some(Stop::Apart);
        }
        if !touches && self.now - self.touched.max(0.0) > quiet.interval {
            return Some(Stop::Quiet);
        }
        (self.now >= quiet.limit).then_some(Stop::Limit)
    }
}

impl<const D: usize> Gear<D> {
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
        loop {
            if let Some(stop) = self.state.over(quiet) {
                return Ok(stop);
            }
            self.advance_to(self.state.next_look(quiet))?;
        }
    }
}
