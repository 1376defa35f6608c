//! `carom run`: what do the grains do? Reads a scenario; writes time series, trajectories and a summary.

use crate::scenario::{MethodName, Scenario, Start};
use crate::session::{self, Orders, Summary};
use anyhow::{Context, Result, ensure};
use clap::Args;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The options of `carom run`.
#[derive(Args, Debug)]
pub struct Options {
    /// The scenario (TOML); docs/guide/scenario.md has all fields, host/scenarios some files.
    scenario: PathBuf,
    /// Where to write; a name each for every method.
    #[arg(long, value_name = "DIR", default_value = "carom-out")]
    out: PathBuf,
    /// Go on where a run of this scenario into this folder was stopped, to the same bits; begin if there is
    /// none, and do nothing if it is whole.
    #[arg(long)]
    restart: bool,
    /// Seconds of computing from one checkpoint to the next.
    #[arg(long, value_name = "SECONDS", default_value_t = 60.0, value_parser = seconds)]
    checkpoint: f64,
    /// Print the summary as JSON instead of a table.
    #[arg(long)]
    json: bool,
    /// Run this method only, whatever the scenario says.
    #[arg(long, value_enum)]
    method: Option<MethodName>,
}

fn seconds(text: &str) -> Result<f64> {
    let value: f64 = text.parse()?;
    ensure!((0.0..=1e9).contains(&value), "must be from 0 to 1e9");
    Ok(value)
}

/// Runs every method of the scenario.
///
/// # Errors
/// A scenario that cannot be read or run, a file that cannot be written.
pub fn run(options: &Options) -> Result<()> {
    let named = || options.scenario.display().to_string();
    let mut scenario = Scenario::read(&options.scenario)?;
    if let Some(method) = options.method {
        scenario = scenario.with_method(method).with_context(named)?;
    }
    let start = Start::new(&scenario).with_context(named)?;
    let orders = Orders {
        out: options.out.clone(),
        text: std::fs::read_to_string(&options.scenario).with_context(named)?,
        restart: options.restart,
        checkpoint: Duration::from_secs_f64(options.checkpoint),
    };
    let summary = session::run(&scenario, &start, &orders).with_context(named)?;
    print(options.json, &summary, &options.out)
}

fn print(json: bool, summary: &Summary, folder: &Path) -> Result<()> {
    let mut sink = std::io::stdout().lock();
    if json {
        return Ok(writeln!(sink, "{}", serde_json::to_string_pretty(summary)?)?);
    }
    let title = if summary.title.is_empty() { "a scenario" } else { &summary.title };
    writeln!(sink, "{title} ({} grains)", summary.grains)?;
    for run in &summary.runs {
        writeln!(
            sink,
            "  {:<9}  t = {} s  {} collisions  {:.4e} J  {:.3} s of computing",
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
