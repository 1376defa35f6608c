//! `carom figure`, `carom divergence`: do we get what the papers got? Reads an id or a number of gases; writes data, comparison, picture and page.

use crate::divergence::{self, Errors};
use crate::figure::{self, page};
use crate::plot::{self, methods};
use anyhow::Result;
use clap::Args;
use serde::Serialize;
use std::io::Write;
use std::path::PathBuf;

/// What the papers have besides.
const DRAWINGS: &str = "Drawings of a setup, not made: MP13 Figs. 1 and 2, BSFP14 Figs. 1, 2, 4 and 6. \
MP13's Tables I and II are ranges of parameters: carom table.";

/// The options of `carom figure`.
#[derive(Args, Debug)]
pub struct FigureOptions {
    /// Which figure, as bsfp14-7; without it, the list of all.
    id: Option<String>,
    /// Print the data as JSON instead of a table.
    #[arg(long)]
    json: bool,
    /// Print the data as CSV: series, x, y and standard error, a line for each point.
    #[arg(long, conflicts_with_all = ["json", "markdown"])]
    csv: bool,
    /// Draw the figure into this file (.png, .svg or .pdf).
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// With more statistics, as the figure's page says: minutes, for bsfp14-3 hours.
    #[arg(long)]
    full: bool,
    /// Print the page docs/figures/ID.md; without an id, the list of all pages.
    #[arg(long, conflicts_with = "json")]
    markdown: bool,
    /// With --markdown: the day that the page says it was made on, as 2026-11-26.
    #[arg(long, requires = "markdown", value_name = "DAY", value_parser = day)]
    date: Option<String>,
}

/// A day, written as 2026-11-26.
fn day(text: &str) -> Result<String, String> {
    let is_day = text.bytes().enumerate().all(|(k, c)| match k {
        4 | 7 => c == b'-',
        _ => c.is_ascii_digit(),
    });
    match is_day && text.len() == 10 {
        true => Ok(text.to_owned()),
        false => Err("a day is written as 2026-11-26".to_owned()),
    }
}

/// Makes a figure.
///
/// # Errors
/// An unknown id, a run that fails, a picture that cannot be written.
pub fn figure(options: &FigureOptions) -> Result<()> {
    let mut out = std::io::stdout().lock();
    let Some(id) = &options.id else {
        if options.markdown {
            return Ok(write!(out, "{}", page::index(figure::all()))?);
        }
        for entry in figure::all() {
            writeln!(out, "{:<13} {}", entry.id, entry.what)?;
        }
        writeln!(out, "{DRAWINGS}")?;
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
    if options.csv {
        return figure::write_csv(&mut out, &made.figure);
    }
    if options.markdown {
        let origin = page::Origin { full: options.full, date: options.date.clone() };
        return Ok(write!(out, "{}", page::page(entry, &made, &origin))?);
    }
    figure::print(&mut out, entry.what, &made)
}

/// The options of `carom divergence`.
#[derive(Args, Debug)]
pub struct DivergenceOptions {
    /// How many gases of ten grains, each from its own seed.
    #[arg(long, default_value_t = 100, value_parser = clap::value_parser!(u64).range(1..=100_000))]
    seeds: u64,
    /// How many collisions of each gas to follow.
    #[arg(long, default_value_t = 10, value_parser = clap::value_parser!(u16).range(1..=1000))]
    collisions: u16,
    /// Print the errors as JSON.
    #[arg(long)]
    json: bool,
    /// Print the table in docs/guide/exactness.md: the collisions 1, 2, 5, 10, 20, 50 and so on.
    #[arg(long, conflicts_with = "json")]
    markdown: bool,
    /// Draw them into this file (.png, .svg or .pdf).
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
}

/// One variant's errors, as JSON shows them.
#[derive(Serialize)]
struct Row {
    method: &'static str,
    collision: usize,
    runs: usize,
    median: Option<f64>,
    max: Option<f64>,
}

/// Runs the study.
///
/// # Errors
/// A picture that cannot be written, or a gas that a method refuses.
pub fn divergence(options: &DivergenceOptions) -> Result<()> {
    if let Some(file) = &options.plot {
        plot::ending(file)?;
    }
    let study = divergence::study(0..options.seeds, usize::from(options.collisions))?;
    let mut out = std::io::stdout().lock();
    let rows: Vec<Row> = study.iter().flat_map(rows).collect();
    if options.json {
        writeln!(out, "{}", serde_json::to_string_pretty(&rows)?)?;
    } else if options.markdown {
        markdown(&mut out, &study)?;
    } else {
        print(&mut out, &rows)?;
    }
    match &options.plot {
        Some(file) => {
            plot::save(&methods::divergence(&study, usize::try_from(options.seeds)?), file)
        }
        None => Ok(()),
    }
}

fn rows(errors: &Errors) -> impl Iterator<Item = Row> + '_ {
    errors.by_collision.iter().enumerate().map(|(k, list)| Row {
        method: errors.variant.name(),
        collision: k + 1,
        runs: list.len(),
        median: errors.median(k),
        max: errors.max(k),
    })
}

/// Median and in brackets the largest, a line for each of some collisions.
fn markdown(out: &mut impl Write, study: &[Errors]) -> Result<()> {
    let names: Vec<_> =
        study.iter().map(|errors| errors.variant.name().replace('*', "\\*")).collect();
    writeln!(out, "| after collision | {} |", names.join(" | "))?;
    writeln!(out, "|---|{}", "---|".repeat(names.len()))?;
    let last = study.iter().map(|errors| errors.by_collision.len()).max().unwrap_or(0);
    let some = (0..).flat_map(|power| [1, 2, 5].map(|first| first * 10_usize.pow(power)));
    for collision in some.take_while(|&collision| collision <= last) {
        let show = |x: Option<f64>| x.map_or_else(|| "-".to_owned(), |x| format!("{x:.1e}"));
        let cell = |errors: &Errors| {
            format!("{} ({})", show(errors.median(collision - 1)), show(errors.max(collision - 1)))
        };
        let cells: Vec<_> = study.iter().map(cell).collect();
        writeln!(out, "| {collision} | {} |", cells.join(" | "))?;
    }
    Ok(())
}

fn print(out: &mut impl Write, rows: &[Row]) -> Result<()> {
    writeln!(out, "Distance of free grains from exact MD, in units of l = R1 + R2")?;
    writeln!(
        out,
        "  {:<22}{:>10}{:>7}{:>11}{:>11}",
        "method", "collision", "runs", "median", "max"
    )?;
    for row in rows {
        let show = |x: Option<f64>| x.map_or_else(|| "-".to_owned(), |x| format!("{x:.1e}"));
        let (median, max) = (show(row.median), show(row.max));
        let Row { method, collision, runs, .. } = row;
        writeln!(out, "  {method:<22}{collision:>10}{runs:>7}{median:>11}{max:>11}")?;
    }
    Ok(())
}
