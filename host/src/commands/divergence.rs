//! `carom divergence`: how do event-driven runs leave force-based MD? Runs small gases; writes a table or JSON, and a picture if asked.

use crate::divergence::{self, Errors};
use crate::plot::{self, figures};
use anyhow::Result;
use clap::Args;
use serde::Serialize;
use std::io::Write;
use std::path::PathBuf;

/// The options of `carom divergence`.
#[derive(Args, Debug)]
pub struct Options {
    /// How many gases of ten grains, each from its own seed.
    #[arg(long, default_value_t = 100, value_parser = clap::value_parser!(u64).range(1..=100_000))]
    seeds: u64,
    /// How many collisions of each gas to follow.
    #[arg(long, default_value_t = 10, value_parser = clap::value_parser!(u16).range(1..=1000))]
    collisions: u16,
    /// Print the errors as JSON.
    #[arg(long)]
    json: bool,
    /// Draw them into this file (.png or .svg).
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
}

/// One way's errors, as JSON shows them.
#[derive(Serialize)]
struct Row {
    method: &'static str,
    collision: usize,
    runs: usize,
    median: Option<f64>,
    largest: Option<f64>,
}

/// Runs the study.
///
/// # Errors
/// A picture that cannot be written, or a gas that a method refuses.
pub fn run(options: &Options) -> Result<()> {
    if let Some(file) = &options.plot {
        plot::ending(file)?;
    }
    let study = divergence::study(0..options.seeds, usize::from(options.collisions))?;
    let mut out = std::io::stdout().lock();
    let rows: Vec<Row> = study.iter().flat_map(rows).collect();
    if options.json {
        writeln!(out, "{}", serde_json::to_string_pretty(&rows)?)?;
    } else {
        print(&mut out, &rows)?;
    }
    match &options.plot {
        Some(file) => {
            plot::save(&figures::divergence::draw(&study, usize::try_from(options.seeds)?), file)
        }
        None => Ok(()),
    }
}

fn rows(errors: &Errors) -> impl Iterator<Item = Row> + '_ {
    errors.by_collision.iter().enumerate().map(|(k, list)| Row {
        method: errors.way.name(),
        collision: k + 1,
        runs: list.len(),
        median: errors.median(k),
        largest: errors.largest(k),
    })
}

fn print(out: &mut impl Write, rows: &[Row]) -> Result<()> {
    writeln!(out, "Distance of free grains from exact MD, in units of l = R1 + R2")?;
    writeln!(
        out,
        "  {:<22}{:>10}{:>7}{:>11}{:>11}",
        "method", "collision", "runs", "median", "largest"
    )?;
    for row in rows {
        let show = |x: Option<f64>| x.map_or_else(|| "-".to_owned(), |x| format!("{x:.1e}"));
        let (median, largest) = (show(row.median), show(row.largest));
        let Row { method, collision, runs, .. } = row;
        writeln!(out, "  {method:<22}{collision:>10}{runs:>7}{median:>11}{largest:>11}")?;
    }
    Ok(())
}
