//! What is written while a method runs? Reads its samples; writes rows, frames and, from time to time, a checkpoint.

use super::checkpoint::{Checkpoint, State, Store};
use super::summary::MethodSummary;
use crate::interrupt::{Heed, Stopped};
use crate::method::Method;
use crate::observe::Recorder;
use crate::report::Files;
use crate::run::{Attendant, Plan, Position, RunProgress, Sample};
use crate::scenario::{Placed, Scenario, Start};
use anyhow::{Result, bail};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// When checkpoints are due, and what else stands in them.
#[derive(Debug)]
pub struct Every<'a> {
    span: Duration,
    last: Instant,
    store: &'a Store,
    /// The methods that are through.
    done: &'a [MethodSummary],
}

impl<'a> Every<'a> {
    /// So often, in this file, with what is through already.
    pub fn new(span: Duration, store: &'a Store, done: &'a [MethodSummary]) -> Self {
        Self { span, last: Instant::now(), store, done }
    }
}

/// Writes every sample down, and checkpoints.
pub struct Scribe<'a> {
    start: &'a Start,
    folder: PathBuf,
    files: Files,
    last: Option<MethodSummary>,
    progress: RunProgress,
    every: Every<'a>,
    heed: Heed,
    recorder: Option<Recorder>,
    /// What was looked at last: a sample at the same time is of the same grains.
    seen: Option<(f64, Vec<Placed>)>,
}

impl<'a> Scribe<'a> {
    /// Begins the files of a method, or goes on with them.
    ///
    /// # Errors
    /// When they cannot be made or are shorter than they were.
    pub fn new(
        start: &'a Start,
        scenario: &Scenario,
        folder: &Path,
        (method, plan): (&dyn Method, &Plan),
        (state, every): (Option<&State>, Every<'a>),
    ) -> Result<Self> {
        let lengths = state.map_or(&[][..], |state| &state.lengths);
        let files = Files::from_lengths(folder, method.name(), scenario, lengths)?;
        let last = state.and_then(|state| state.last.clone());
        let progress = RunProgress::new(method, plan);
        let measured = state.and_then(|state| state.measured.as_deref());
        let recorder = Recorder::new(scenario, start, measured)?;
        Ok(Self {
            recorder,
            seen: None,
            start,
            folder: folder.to_owned(),
            files,
            last,
            progress,
            every,
            heed: Heed::new(),
        })
    }

    /// The files are whole; what the method came to is there if there was a sample.
    ///
    /// # Errors
    /// When the last bytes cannot be written.
    pub fn finish(
        mut self,
        position: &Position,
        digest: Option<u64>,
    ) -> Result<Option<MethodSummary>> {
        self.files.secured()?;
        let mut names = self.files.names().to_vec();
        let stem = self.last.as_ref().map_or("", |last| last.method.file_stem());
        for table in self.recorder.iter().flat_map(Recorder::tables) {
            names.extend(table.write(&self.folder, stem)?);
        }
        let files = names.iter().map(|name| self.folder.join(name)).collect();
        let wall_seconds = position.seconds;
        let digest = digest.map(|digest| format!("{digest:016x}"));
        Ok(self.last.map(|last| MethodSummary { wall_seconds, digest, files, ..last }))
    }

    /// Writes a checkpoint, if the method can be saved.
    fn save(&mut self, method: &mut dyn Method, position: &Position) -> Result<()> {
        self.every.last = Instant::now();
        self.files.add_events(&method.take_events())?;
        let Some(bytes) = method.save()? else { return Ok(()) };
        let state = State {
            position: *position,
            lengths: self.files.secured()?,
            last: self.last.clone(),
            method: bytes,
            measured: self.recorder.as_ref().map(Recorder::save).transpose()?,
        };
        let runs = self.every.done.to_vec();
        self.every.store.write(&Checkpoint { runs, current: Some(state) })
    }
}

impl Attendant for Scribe<'_> {
    fn sample(&mut self, method: &mut dyn Method, time: f64) -> Result<()> {
        let seen = self.seen.take().filter(|(then, _)| *then == time);
        let grains = seen.map_or_else(|| method.grains(), |(_, grains)| grains);
        let sample = Sample::of(method, time, grains);
        self.last = Some(MethodSummary::new(method.name(), &sample));
        self.files.add(self.start, &sample)
    }

    fn look(&mut self, method: &mut dyn Method, time: f64) {
        let tally = method.take_tally();
        if let Some(recorder) = &mut self.recorder {
            let grains = method.grains();
            recorder.look(time, &tally, &grains);
            self.seen = Some((time, grains));
        }
    }

    fn pause(&mut self, method: &mut dyn Method, position: &Position) -> Result<()> {
        self.progress.show(method);
        if self.heed.is_asked() {
            self.save(method, position)?;
            bail!(Stopped { time: method.time() });
        }
        if self.every.last.elapsed() >= self.every.span {
            self.save(method, position)?;
        }
        Ok(())
    }
}
