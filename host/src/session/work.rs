//! What is done for a run, one method after the other? Reads a scenario; writes the files of its methods, checkpoints and a summary.

use super::checkpoint::{Checkpoint, Identity, State, Store};
use super::scribe::{Every, Scribe};
use super::summary::{MethodSummary, Summary};
use super::unfinished::Unfinished;
use crate::method;
use crate::observe::Recorder;
use crate::output;
use crate::run::{self, Ended, Plan, Position};
use crate::scenario::{MethodName, Scenario, Start};
use anyhow::{Context, Error, Result};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// What is asked of a run besides its scenario.
#[derive(Clone, Debug)]
pub struct Orders {
    /// The folder of the results.
    pub out: PathBuf,
    /// The scenario as its file says it: a run goes on only with the same one.
    pub text: String,
    /// Go on from the checkpoint that there is.
    pub restart: bool,
    /// Time from one checkpoint to the next.
    pub checkpoint: Duration,
}

const SUMMARY: &str = "summary.json";

/// Runs every method of the scenario, or goes on where a run that was stopped left a checkpoint.
///
/// # Errors
/// A method that refuses the scenario, in which case nothing is written; a checkpoint of another run; a
/// fault in a run, which leaves what was sampled until then, marked as broken off, in the folder
/// `unfinished`; a file that cannot be written; [`Stopped`](crate::interrupt::Stopped).
pub fn run(scenario: &Scenario, start: &Start, orders: &Orders) -> Result<Summary> {
    let methods = scenario.chosen_methods();
    for name in &methods {
        method::with(*name, scenario, start, |_| Ok(()))?;
    }
    // What cannot be measured is refused before anything is written.
    Recorder::new(scenario, start, None)?;
    let identity = identity(scenario, start, &orders.text)?;
    let unfinished = Unfinished::new(&orders.out)?;
    let store = Store::new(unfinished.path(), identity);
    let mut checkpoint = Checkpoint::default();
    match orders.restart.then(|| store.read()).transpose()?.flatten() {
        Some(found) => checkpoint = found,
        None => {
            if let Some(summary) = is_done(orders, &store)? {
                unfinished.publish(&[])?;
                return Ok(summary);
            }
            unfinished.clear()?;
        }
    }
    let work = Work {
        scenario,
        start,
        folder: unfinished.path(),
        store: &store,
        every: orders.checkpoint,
    };
    let ended = work.all(&methods, &mut checkpoint)?;
    let (title, grains) = (scenario.title.clone(), start.grains.len());
    let known_by = store.known_by();
    let summary = Summary { title, grains, known_by, runs: checkpoint.runs, broken_off: None };
    match ended {
        Ended::Whole => publish(summary, unfinished, &orders.out),
        Ended::BrokenOff(why) => {
            store.remove()?;
            Err(broken_off(summary, &unfinished, why))
        }
    }
}

fn identity(scenario: &Scenario, start: &Start, text: &str) -> Result<Identity> {
    let methods: Vec<&str> =
        scenario.chosen_methods().into_iter().map(MethodName::file_stem).collect();
    let grains: Vec<_> =
        start.grains.iter().map(|g| (g.radius, g.mass, g.position, g.velocity)).collect();
    Identity::new(format!("{text}\n{}", methods.join(" ")), &grains)
}

/// The summary of this very run, if it is whole already.
fn is_done(orders: &Orders, store: &Store) -> Result<Option<Summary>> {
    let file = orders.out.join(SUMMARY);
    if !orders.restart || !file.exists() {
        return Ok(None);
    }
    let text = fs::read(&file).with_context(|| format!("cannot read {}", file.display()))?;
    let summary: Option<Summary> = serde_json::from_slice(&text).ok();
    Ok(summary.filter(|summary| summary.known_by == store.known_by()))
}

/// Leaves what there is, with the reason why there is no more.
fn broken_off(mut summary: Summary, unfinished: &Unfinished, why: Error) -> Error {
    summary.broken_off = Some(format!("{why:#}"));
    let folder = unfinished.path();
    match write_summary(&summary, folder) {
        Ok(_) => why.context(format!("broken off, with all until then in {}", folder.display())),
        Err(other) => other.context(format!("{why:#}")),
    }
}

/// Everything appears at once, the summary last.
fn publish(mut summary: Summary, unfinished: Unfinished, out: &Path) -> Result<Summary> {
    let mut names = Vec::new();
    for run in &mut summary.runs {
        for file in &mut run.files {
            names.extend(file.file_name().map(|name| name.to_string_lossy().into_owned()));
            *file = names.last().map(|name| out.join(name)).unwrap_or_default();
        }
    }
    names.push(write_summary(&summary, unfinished.path())?);
    unfinished.publish(&names)?;
    Ok(summary)
}

fn write_summary(summary: &Summary, folder: &Path) -> Result<String> {
    output::write_file(&folder.join(SUMMARY), &serde_json::to_vec_pretty(summary)?)?;
    Ok(SUMMARY.to_owned())
}

/// What all methods of a run have in common.
struct Work<'a> {
    scenario: &'a Scenario,
    start: &'a Start,
    folder: &'a Path,
    store: &'a Store,
    every: Duration,
}

impl Work<'_> {
    /// Runs those methods that are not through, the first of them from where it stands.
    fn all(&self, methods: &[MethodName], checkpoint: &mut Checkpoint) -> Result<Ended> {
        for name in methods.iter().skip(checkpoint.runs.len()) {
            let current = checkpoint.current.take();
            let (summary, ended) = self.one(*name, current, &checkpoint.runs)?;
            checkpoint.runs.extend(summary);
            if let Ended::BrokenOff(why) = ended {
                return Ok(Ended::BrokenOff(why.context(name.label())));
            }
            self.store.write(checkpoint)?;
        }
        Ok(Ended::Whole)
    }

    /// Runs one method to its end; what it came to is there if there was a sample.
    fn one(
        &self,
        name: MethodName,
        state: Option<State>,
        done: &[MethodSummary],
    ) -> Result<(Option<MethodSummary>, Ended)> {
        let plan = Plan::new(self.scenario);
        let saved = state.as_ref().map(|state| state.method.as_slice());
        method::with_state(name, self.scenario, self.start, saved, |method| {
            let mut position = state.as_ref().map_or_else(Position::default, |s| s.position);
            let every = Every::new(self.every, self.store, done);
            let mut scribe = Scribe::new(
                self.start,
                self.scenario,
                self.folder,
                (method, &plan),
                (state.as_ref(), every),
            )?;
            let ended = run::attend(method, &plan, &mut position, &mut scribe)?;
            let digest = matches!(ended, Ended::Whole).then(|| method.digest()).flatten();
            Ok((scribe.finish(&position, digest)?, ended))
        })
    }
}
