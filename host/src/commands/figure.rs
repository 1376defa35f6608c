//! `carom figure`: do we get what the papers got? Reads an id; writes the figure's data, comparison and picture.

use crate::figure::{self, table};
use crate::plot;
use anyhow::Result;
use clap::Args;
use std::io::Write;
use std::path::PathBuf;

/// The options of `carom figure`.
#[derive(Args, Debug)]
pub struct Options {
    /// Which figure, as bsfp14-7; without it, the list of all.
    id: Option<String>,
    /// Print the data as JSON instead of a table.
    #[arg(long)]
    json: bool,
    /// Draw the figure into this file (.png or .svg).
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// With the paper's statistics, however long it takes.
    #[arg(long)]
    full: bool,
}

/// Makes a figure.
///
/// # Errors
/// An unknown id, a run that fails, a picture that cannot be written.
pub fn run(options: &Options) -> Result<()> {
    let mut out = std::io::stdout().lock();
    let Some(id) = &options.id else {
        for entry in figure::all() {
            writeln!(out, "{:<13} {}", entry.id, entry.what)?;
        }
        return Ok(());
    };
    let entry = figure::find(id)?;
    if let Some(file) = &options.out {
        plot::ending(file)?;
    }
    let made = (entry.make)(&figure::Options { full: options.full })?;
    made.figure.check()?;
    if let Some(file) = &options.out {
        plot::save(&made.picture, file)?;
    }
    if options.json {
        return Ok(writeln!(out, "{}", serde_json::to_string_pretty(&made.figure)?)?);
    }
    table::print(&mut out, entry.what, &made)
}
