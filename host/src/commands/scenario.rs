//! `carom scenario`: is a file right, and which fields are there? Reads a scenario or the types; writes what is wrong, or the fields.

use crate::scenario::{examine_file, fields, schema};
use anyhow::{Result, bail};
use clap::{Args, Subcommand};
use std::io::Write;
use std::path::{Path, PathBuf};

/// The options of `carom scenario`.
#[derive(Args, Debug)]
#[command(arg_required_else_help = true, subcommand_negates_reqs = true)]
pub struct Options {
    #[command(subcommand)]
    command: Option<Command>,
    /// Print JSON Schema of scenario files, for editors and other programs.
    #[arg(long, conflicts_with = "markdown", required_unless_present = "markdown")]
    schema: bool,
    /// Print all fields as tables, as docs/guide/scenario.md has them.
    #[arg(long)]
    markdown: bool,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Say all that is wrong with a scenario, with line and column, and place its grains; nothing is run.
    Check {
        /// The scenario (TOML).
        file: PathBuf,
    },
}

/// Checks a file or prints the fields.
///
/// # Errors
/// When the file cannot be read, or something is wrong with it.
pub fn run(options: &Options) -> Result<()> {
    let mut sink = std::io::stdout().lock();
    match &options.command {
        Some(Command::Check { file }) => return check(&mut sink, file),
        None if options.schema => {
            serde_json::to_writer_pretty(&mut sink, schema())?;
            writeln!(sink)?;
        }
        None => sink.write_all(fields().as_bytes())?,
    }
    Ok(())
}

fn check(sink: &mut dyn Write, file: &Path) -> Result<()> {
    let (start, found) = examine_file(file)?;
    let name = file.display();
    for ((line, column), problem) in &found {
        writeln!(sink, "{name}:{line}:{column}: {problem}")?;
    }
    match (found.len(), start) {
        (0, Some(start)) => writeln!(sink, "{name}: good, {} grains", start.grains.len())?,
        (1, _) => bail!("{name}: 1 thing is wrong"),
        (count, _) => bail!("{name}: {count} things are wrong"),
    }
    Ok(())
}
