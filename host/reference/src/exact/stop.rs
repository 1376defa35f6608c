//! When may an exact run stop? Reads contacts and forecasts; goes on until nothing more comes.

use super::run::Exact;
use crate::error::ReferenceError;
use crate::quiet::{Quiet, Stop};

impl<const D: usize> Exact<D> {
    /// Goes on until no contact exists and none can come, or none has existed for some time.
    ///
    /// # Errors
    ///
    /// As [`Exact::advance_to`].
    ///
    /// # Examples
    ///
    /// ```
    /// use carom_reference::{Boundary, End, Exact, ForceLaw, Grain, Plate, Quiet, Stop, System};
    /// let bead = Grain { radius: 0.5, mass: 1.0, position: [1.0], velocity: [-1.0] };
    /// let system = System::new(vec![bead], [Boundary::Plate(Plate::fixed(0.0))], [0.0])?;
    /// let mut run = Exact::new(system, ForceLaw::spring_of(1.0, 1e-3, 0.9)?, End::Overlap)?;
    /// let quiet = Quiet { interval: f64::INFINITY, limit: 10.0 };
    /// assert_eq!(run.advance_until_quiet(quiet)?, Stop::Separated);
    /// // L94 Sec. III A: at a wall μ is D_n/2, so that ε there is above that of a pair.
    /// assert!((run.velocity(0)[0] - 0.92823).abs() < 1e-5);
    /// # Ok::<(), carom_reference::ReferenceError>(())
    /// ```
    pub fn advance_until_quiet(&mut self, quiet: Quiet) -> Result<Stop, ReferenceError> {
        loop {
            let idle = self.clusters.is_empty();
            let next = self.next_forecast().0;
            if idle && next == f64::INFINITY {
                return Ok(Stop::Separated);
            }
            let patience = self.now + quiet.interval;
            if idle && patience <= quiet.limit && next > patience {
                // Forecasts may be only times to look again.
                if self.next_event(patience)?.is_none() {
                    return Ok(Stop::Quiet);
                }
                continue;
            }
            if self.next_event(quiet.limit)?.is_none() && self.now >= quiet.limit {
                return Ok(Stop::Limit);
            }
        }
    }
}
