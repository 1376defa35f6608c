//! `carom run`: what do the grains do? Reads a scenario; writes time series, trajectories and a summary.

use crate::report::Files;
use crate::run::{self, Plan};
use crate::scenario::{MethodName, Scenario, Start};
use crate::{method, output};
use anyhow::{Context, Result};
use clap::Args;
use serde::Serialize;
use std::io::Write;
use std::path::{Path, PathBuf};

/// The options of `carom run`.
#[derive(Args, Debug)]
pub struct Options {
    /// The scenario (TOML); three are explained in host/scenarios.
    scenario: PathBuf,
    /// Where to write; a name each for every method.
    #[arg(long, value_name = "DIR", default_value = "carom-out")]
    out: PathBuf,
    /// Print the summary as JSON instead of a table.
    #[arg(long)]
    json: bool,
    /// Run this method only, whatever the scenario says.
    #[arg(long, value_enum)]
    method: Option<MethodName>,
}

/// What a run came to.
#[derive(Debug, Serialize)]
struct Summary {
    title: String,
    grains: usize,
    runs: Vec<Run>,
}

#[derive(Debug, Serialize)]
struct Run {
    method: MethodName,
    time: f64,
    collisions: u64,
    kinetic_energy: f64,
    wall_seconds: f64,
    statistics: Vec<(&'static str, u64)>,
    motions: Vec<(&'static str, usize)>,
    files: Vec<PathBuf>,
}

/// Runs every method of the scenario.
///
/// # Errors
/// A scenario that cannot be read or run, a file that cannot be written.
pub fn run(options: &Options) -> Result<()> {
    let mut scenario = Scenario::read(&options.scenario)?;
    if let Some(method) = options.method {
        scenario = scenario.with_method(method).with_context(|| named(options))?;
    }
    let start = Start::new(&scenario).with_context(|| named(options))?;
    let methods = scenario.chosen_methods();
    let one = |name: &MethodName| one(*name, &scenario, &start, &options.out);
    let runs = methods.iter().map(one).collect::<Result<Vec<Run>>>();
    let runs = runs.with_context(|| named(options))?;
    let summary = Summary { title: scenario.title.clone(), grains: start.grains.len(), runs };
    let json = serde_json::to_vec_pretty(&summary)?;
    output::write_file(&options.out.join("summary.json"), &json)?;
    print(options.json.then_some(json.as_slice()), &summary, &options.out)
}

fn named(options: &Options) -> String {
    options.scenario.display().to_string()
}

fn one(name: MethodName, scenario: &Scenario, start: &Start, folder: &Path) -> Result<Run> {
    let mut files = Files::new(folder, name, scenario)?;
    let mut last = None;
    let wall_seconds = method::with(name, scenario, start, |method| {
        run::drive(method, &Plan::new(scenario), |sample| {
            last = Some(sample.clone());
            files.add(start, sample)
        })
    })?;
    let files = files.finish()?;
    let last = last.context("no sample was taken")?;
    let run::Sample { time, collisions, kinetic_energy, statistics, motions, .. } = last;
    let method = name;
    Ok(Run { method, time, collisions, kinetic_energy, wall_seconds, statistics, motions, files })
}

fn print(json: Option<&[u8]>, summary: &Summary, folder: &Path) -> Result<()> {
    let mut sink = std::io::stdout().lock();
    if let Some(json) = json {
        sink.write_all(json)?;
        writeln!(sink)?;
        return Ok(());
    }
    writeln!(sink, "{} ({} grains)", summary.title, summary.grains)?;
    for run in &summary.runs {
        writeln!(
            sink,
            "  {:<9}  t = {} s  {} collisions  {:.6} J  {:.3} s of computing",
            run.method.label(),
            run.time,
            run.collisions,
            run.kinetic_energy,
            run.wall_seconds
        )?;
        if !run.motions.is_empty() {
            let motions = run.motions.iter().map(|(name, count)| format!("{count} {name}"));
            writeln!(sink, "             {}", motions.collect::<Vec<_>>().join(", "))?;
        }
        let statistics = run
            .statistics
            .iter()
            .map(|(name, count)| format!("{} {count}", name.replace('_', " ")));
        writeln!(sink, "             {}", statistics.collect::<Vec<_>>().join(", "))?;
        for file in &run.files {
            writeln!(sink, "             {}", file.display())?;
        }
    }
    writeln!(sink, "  summary: {}", folder.join("summary.json").display())?;
    Ok(())
}
