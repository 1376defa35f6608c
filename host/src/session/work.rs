//! What is done for a run, one method after the other? Reads a scenario; writes the files of its methods and a summary.

use super::summary::{MethodSummary, Summary};
use super::unfinished::Unfinished;
use crate::method::{self, Method};
use crate::output;
use crate::report::Files;
use crate::run::{self, Attendant, Ended, Plan, Position, RunProgress, Sample};
use crate::scenario::{MethodName, Scenario, Start};
use anyhow::{Error, Result};
use std::path::{Path, PathBuf};

/// What is asked of a run besides its scenario.
#[derive(Clone, Debug)]
pub struct Orders {
    /// The folder of the results.
    pub out: PathBuf,
}

const SUMMARY: &str = "summary.json";

/// Runs every method of the scenario.
///
/// # Errors
/// A method that refuses the scenario, in which case nothing is written; a fault in a run, which leaves
/// what was sampled until then, marked as broken off, in the folder `unfinished`; a file that cannot be
/// written.
pub fn run(scenario: &Scenario, start: &Start, orders: &Orders) -> Result<Summary> {
    let methods = scenario.chosen_methods();
    for name in &methods {
        method::with(*name, scenario, start, |_| Ok(()))?;
    }
    let unfinished = Unfinished::new(&orders.out)?;
    unfinished.clear()?;
    let (title, grains) = (scenario.title.clone(), start.grains.len());
    let mut summary = Summary { title, grains, runs: Vec::new(), broken_off: None };
    for name in methods {
        let (method, ended) = one(name, scenario, start, unfinished.path())?;
        summary.runs.extend(method);
        if let Ended::BrokenOff(why) = ended {
            return Err(broken_off(summary, &unfinished, why.context(name.label())));
        }
    }
    publish(summary, unfinished, &orders.out)
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

/// Runs one method; what it came to is there if there was a sample.
fn one(
    name: MethodName,
    scenario: &Scenario,
    start: &Start,
    folder: &Path,
) -> Result<(Option<MethodSummary>, Ended)> {
    let plan = Plan::new(scenario);
    method::with(name, scenario, start, |method| {
        let files = Files::new(folder, name, scenario)?;
        let progress = RunProgress::new(method, &plan);
        let mut scribe = Scribe { start, files, progress, last: None };
        let mut position = Position::default();
        let ended = run::attend(method, &plan, &mut position, &mut scribe)?;
        scribe.files.secured()?;
        Ok((scribe.summary(folder, position.seconds), ended))
    })
}

/// Writes every sample down.
struct Scribe<'a> {
    start: &'a Start,
    files: Files,
    progress: RunProgress,
    last: Option<MethodSummary>,
}

impl Attendant for Scribe<'_> {
    fn sample(&mut self, method: &mut dyn Method, time: f64) -> Result<()> {
        let sample = Sample::take(method, time);
        self.last = Some(MethodSummary::new(method.name(), &sample));
        self.files.add(self.start, &sample)
    }

    fn pause(&mut self, method: &mut dyn Method, _: &Position) -> Result<()> {
        self.progress.show(method);
        Ok(())
    }
}

impl Scribe<'_> {
    fn summary(self, folder: &Path, wall_seconds: f64) -> Option<MethodSummary> {
        let files = self.files.names().iter().map(|name| folder.join(name)).collect();
        self.last.map(|last| MethodSummary { wall_seconds, files, ..last })
    }
}
