//! `carom scenario`: is a file right, and which fields are there? Reads a scenario or the types; writes what is wrong, or the fields.

use crate::method;
use crate::observe::Recorder;
use crate::scenario::{Found, Problem, Scenario, Start, examine_file, fields, place_of, schema};
use anyhow::{Error, Result, bail};
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
    let (start, mut found) = examine_file(file)?;
    if let Some(start) = start.as_ref().filter(|_| found.is_empty()) {
        found = refusals(file, start)?;
    }
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

/// What does not fit the box and the grains as they were placed: something to be measured, or a method.
fn refusals(file: &Path, start: &Start) -> Result<Found> {
    let (scenario, text) = (Scenario::read(file)?, std::fs::read_to_string(file)?);
    let mut found = Found::new();
    let mut say = |path: &str, why: Error| {
        let message = format!("{why:#}");
        // Most name their field.
        let field = message.split([' ', ':']).next().filter(|field| field.starts_with("observe"));
        let named = why.downcast_ref::<Problem>().map(|problem| problem.path.as_str());
        let path = named.or(field).unwrap_or(path).to_owned();
        let problem = Problem { path, offset: None, message };
        found.push((place_of(&text, &problem), problem));
    };
    if let Err(why) = Recorder::new(&scenario, start, None) {
        say("observe", why);
    }
    for name in scenario.chosen_methods() {
        if let Err(why) = method::begin(name, &scenario, start, None) {
            say("methods", why);
        }
    }
    Ok(found)
}
