//! Which files does one run fill? Reads samples; writes time series, trajectory and event log.

use super::{Series, write_events, write_frame};
use crate::output::Draft;
use crate::run::Sample;
use crate::scenario::{MethodName, Scenario, Start};
use anyhow::Result;
use std::path::{Path, PathBuf};

/// The files of one run, under temporary names until it is over.
#[derive(Debug)]
pub struct Files {
    names: Vec<PathBuf>,
    series: Series,
    frames: Draft,
    events: Option<csv::Writer<Draft>>,
}

impl Files {
    /// Opens NAME.csv and NAME.xyz, and NAME-events.csv if the scenario asks for it.
    ///
    /// # Errors
    /// When one cannot be made.
    pub fn new(folder: &Path, name: MethodName, scenario: &Scenario) -> Result<Self> {
        let stem = name.file_stem();
        let mut names =
            vec![folder.join(format!("{stem}.csv")), folder.join(format!("{stem}.xyz"))];
        let (series, frames) = (Series::new(&names[0])?, Draft::new(&names[1])?);
        let mut events = None;
        if scenario.options.events && matches!(name, MethodName::Emd | MethodName::EmdStar) {
            names.push(folder.join(format!("{stem}-events.csv")));
            let mut rows = csv::Writer::from_writer(Draft::new(&names[2])?);
            super::events_head(&mut rows)?;
            events = Some(rows);
        }
        Ok(Self { names, series, frames, events })
    }

    /// One more sample.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn add(&mut self, start: &Start, sample: &Sample) -> Result<()> {
        self.series.add(sample)?;
        write_frame(&mut self.frames, start, sample)?;
        match &mut self.events {
            Some(rows) => write_events(rows, &sample.events),
            None => Ok(()),
        }
    }

    /// The files appear; returns their names.
    ///
    /// # Errors
    /// When the last bytes cannot be written.
    pub fn finish(self) -> Result<Vec<PathBuf>> {
        self.series.finish()?;
        self.frames.finish()?;
        if let Some(rows) = self.events {
            rows.into_inner().map_err(|error| error.into_error())?.finish()?;
        }
        Ok(self.names)
    }
}
