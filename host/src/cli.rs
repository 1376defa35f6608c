//! Which commands and options are there? Reads the command line; writes nothing, calls one command.

use crate::commands;
use anyhow::{Result, anyhow};
use clap::error::ErrorKind;
use clap::{Parser, Subcommand};
use std::ffi::OsString;

/// Event-driven molecular dynamics of soft and hard grains, compared with force-based MD.
///
/// Without a command: `carom demo`.
#[derive(Debug, Parser)]
#[command(name = "carom", version, arg_required_else_help = false)]
struct Arguments {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// The main job: MP13 Fig. 6 and a gas of 1,000 grains three ways, with two pictures.
    Demo(commands::compare::DemoOptions),
    /// Run a scenario by the methods it names; write time series, trajectories and a summary.
    Run(commands::run::Options),
    /// Draw what a run wrote: curves over the first column of a CSV or Parquet file.
    Plot(commands::plot::Options),
    /// Check a scenario file, or print which fields there are.
    Scenario(commands::scenario::Options),
    /// Run a scenario by several methods from the same start and compare what they get.
    Compare(commands::compare::CompareOptions),
    /// Run gases of ten grains until three touch, and show how far event-driven runs are from MD.
    Divergence(commands::figure::DivergenceOptions),
    /// Reproduce a figure of the papers and compare its numbers.
    Figure(commands::figure::FigureOptions),
    /// Compute isolated two-grain collisions listed in a CSV file, as CSV on standard output.
    Collide(commands::collide::Options),
    /// Measure pressure and mean free time of hard spheres and disks against published values.
    Fluid(commands::hard::FluidOptions),
    /// Run a dissipative gas for millions of collisions, and check that nothing breaks.
    Soak(commands::hard::SoakOptions),
    /// Do many runs of a scenario, each with other fields or seeds; a Parquet row for each.
    Sweep(commands::sweep::SweepOptions),
    /// Put the shards of a sweep together.
    Merge(commands::sweep::MergeOptions),
    /// Measure collisions per second and bytes per grain.
    Bench(commands::bench::Options),
    /// Show what the embedded tables hold and how exact they are.
    Table(commands::table::TableOptions),
}

/// Parses the arguments and runs the command.
///
/// # Errors
/// One line: what was wrong with the arguments or the files, and what would be right.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> Result<()> {
    let arguments = match Arguments::try_parse_from(arguments) {
        Ok(arguments) => arguments,
        Err(error) => return parse_error(&error),
    };
    match arguments.command {
        Some(Command::Compare(options)) => commands::compare::compare(&options),
        Some(Command::Divergence(options)) => commands::figure::divergence(&options),
        Some(Command::Figure(options)) => commands::figure::figure(&options),
        Some(Command::Collide(options)) => commands::collide::run(&options),
        Some(Command::Fluid(options)) => commands::hard::fluid(&options),
        Some(Command::Soak(options)) => commands::hard::soak(&options),
        Some(Command::Sweep(options)) => commands::sweep::sweep(&options),
        Some(Command::Merge(options)) => commands::sweep::merge(&options),
        Some(Command::Bench(options)) => commands::bench::run(&options),
        Some(Command::Table(options)) => commands::table::table(&options),
        Some(Command::Plot(options)) => commands::plot::run(&options),
        Some(Command::Run(options)) => commands::run::run(&options),
        Some(Command::Scenario(options)) => commands::scenario::run(&options),
        Some(Command::Demo(options)) => commands::compare::demo(&options),
        None => commands::compare::demo(&commands::compare::DemoOptions::default()),
    }
}

/// Help and version are printed as asked; any other error becomes one line.
fn parse_error(error: &clap::Error) -> Result<()> {
    if matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion) {
        return Ok(error.print()?);
    }
    let text = error.to_string();
    let message = text.split("\n\nUsage:").next().unwrap_or(&text);
    let message = message.split("\n\nFor more information").next().unwrap_or(message);
    let words: Vec<&str> = message.trim_start_matches("error: ").split_whitespace().collect();
    Err(anyhow!("{} (carom --help lists commands and options)", words.join(" ")))
}
