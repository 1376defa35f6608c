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
    Demo(commands::demo::Options),
    /// Run a scenario by the methods it names; write time series, trajectories and a summary.
    Run(commands::run::Options),
    /// Run a scenario by several methods from the same start and compare what they get.
    Compare(commands::compare::Options),
    /// Run gases of ten grains until three touch, and show how far event-driven runs are from MD.
    Divergence(commands::divergence::Options),
    /// Make a figure of the papers anew and set their numbers beside ours.
    Figure(commands::figure::Options),
    /// Answer isolated two-grain collisions listed in a CSV file, as CSV on standard output.
    Collide(commands::collide::Options),
    /// Measure pressure and mean free time of hard spheres and disks against published values.
    Fluid(commands::fluid::Options),
    /// Run a dissipative gas for millions of collisions, and check that nothing breaks.
    Soak(commands::soak::Options),
    /// Do many runs of a scenario, each with other fields or seeds; a Parquet row for each.
    Sweep(commands::sweep::Options),
    /// Put the shards of a sweep together.
    Merge(commands::merge::Options),
    /// Measure collisions per second and bytes per grain.
    Bench(commands::bench::Options),
    /// Show what the embedded tables hold and how exact they are.
    Table(commands::table::Options),
}

/// Parses the arguments and runs the command.
///
/// # Errors
/// One line: what was wrong with the arguments or the files, and what would be right.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> Result<()> {
    let arguments = match Arguments::try_parse_from(arguments) {
        Ok(arguments) => arguments,
        Err(error) => return refuse(&error),
    };
    match arguments.command {
        Some(Command::Compare(options)) => commands::compare::run(&options),
        Some(Command::Divergence(options)) => commands::divergence::run(&options),
        Some(Command::Figure(options)) => commands::figure::run(&options),
        Some(Command::Collide(options)) => commands::collide::run(&options),
        Some(Command::Fluid(options)) => commands::fluid::run(&options),
        Some(Command::Soak(options)) => commands::soak::run(&options),
        Some(Command::Sweep(options)) => commands::sweep::run(&options),
        Some(Command::Merge(options)) => commands::merge::run(&options),
        Some(Command::Bench(options)) => commands::bench::run(&options),
        Some(Command::Table(options)) => commands::table::run(&options),
        Some(Command::Run(options)) => commands::run::run(&options),
        Some(Command::Demo(options)) => commands::demo::run(&options),
        None => commands::demo::run(&commands::demo::Options::default()),
    }
}

/// Help and version are printed as asked; any other complaint becomes one line.
fn refuse(error: &clap::Error) -> Result<()> {
    if matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion) {
        return Ok(error.print()?);
    }
    let text = error.to_string();
    let message = text.split("\n\nUsage:").next().unwrap_or(&text);
    let message = message.split("\n\nFor more information").next().unwrap_or(message);
    let words: Vec<&str> = message.trim_start_matches("error: ").split_whitespace().collect();
    Err(anyhow!("{} (carom --help lists what there is)", words.join(" ")))
}
