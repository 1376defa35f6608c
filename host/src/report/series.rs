//! How do energy and counters go with time? Reads samples; writes rows of CSV.

use crate::method::Logged;
use crate::output::Draft;
use crate::run::Sample;
use anyhow::Result;
use std::path::Path;

/// A time series as CSV: time, kinetic energy, collisions and the method's counters.
#[derive(Debug)]
pub struct Series {
    rows: csv::Writer<Draft>,
    begun: bool,
}

impl Series {
    /// Opens the file.
    ///
    /// # Errors
    /// When it cannot be made.
    pub fn new(file: &Path) -> Result<Self> {
        Ok(Self { rows: csv::Writer::from_writer(Draft::new(file)?), begun: false })
    }

    /// One row.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn add(&mut self, sample: &Sample) -> Result<()> {
        if !self.begun {
            let names = sample.counters.iter().map(|(name, _)| *name);
            self.rows.write_record(
                ["time", "kinetic_energy", "contacts_begun"].into_iter().chain(names),
            )?;
            self.begun = true;
        }
        let mut row = vec![
            format!("{:?}", sample.time),
            format!("{:?}", sample.kinetic_energy),
            sample.collisions.to_string(),
        ];
        row.extend(sample.counters.iter().map(|(_, count)| count.to_string()));
        Ok(self.rows.write_record(row)?)
    }

    /// The file appears.
    ///
    /// # Errors
    /// When the last rows cannot be written.
    pub fn finish(self) -> Result<()> {
        let draft = self.rows.into_inner().map_err(|error| error.into_error())?;
        draft.finish()
    }
}

/// The header of an event log.
///
/// # Errors
/// When it cannot be written.
pub fn events_head(rows: &mut csv::Writer<Draft>) -> Result<()> {
    Ok(rows.write_record(["time", "what", "grain", "partner", "plane"])?)
}

/// The rows of an event log.
///
/// # Errors
/// When they cannot be written.
pub fn write_events(rows: &mut csv::Writer<Draft>, events: &[Logged]) -> Result<()> {
    let number = |number: Option<usize>| number.map_or_else(String::new, |n| n.to_string());
    for event in events {
        rows.write_record([
            format!("{:?}", event.time),
            event.what.to_owned(),
            event.grain.to_string(),
            number(event.partner),
            number(event.plane),
        ])?;
    }
    Ok(())
}
