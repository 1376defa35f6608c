//! `carom compare`: do the methods agree? Reads a scenario; writes a table or JSON, and files if asked.

use crate::compare::{self, Comparison};
use crate::output;
use crate::plot::{self, figures};
use crate::scenario::Scenario;
use anyhow::{Context, Result};
use clap::Args;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

/// The options of `carom compare`.
#[derive(Args, Debug)]
pub struct Options {
    /// The scenario (TOML); three are explained in host/scenarios.
    scenario: PathBuf,
    /// Print JSON instead of a table.
    #[arg(long)]
    json: bool,
    /// Also write comparison.csv, .json, .png and .svg into this directory.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// Columns of comparison.csv.
const HEAD: [&str; 8] = [
    "method",
    "time",
    "collisions",
    "collisions_per_grain",
    "kinetic_energy",
    "apart_median",
    "apart_rms",
    "apart_largest",
];

/// Runs and compares.
///
/// # Errors
/// A scenario that cannot be read or run, a file that cannot be written.
pub fn run(options: &Options) -> Result<()> {
    let scenario = Scenario::read(&options.scenario)?;
    let name = options.scenario.display();
    let (start, tracks) = compare::tracks(&scenario).with_context(|| format!("{name}"))?;
    let comparison = compare::summarise(&scenario, &start, &tracks)?;
    let mut sink = BufWriter::new(std::io::stdout().lock());
    if options.json {
        serde_json::to_writer_pretty(&mut sink, &comparison)?;
        writeln!(sink)?;
    } else {
        compare::print(&mut sink, &comparison)?;
    }
    if let Some(folder) = &options.out {
        write_files(folder, &comparison)?;
    }
    sink.flush()?;
    Ok(())
}

/// Writes comparison.csv, .json, .png and .svg.
///
/// # Errors
/// A file that cannot be written.
pub fn write_files(folder: &Path, comparison: &Comparison) -> Result<()> {
    let json = serde_json::to_vec_pretty(comparison)?;
    output::write_file(&folder.join("comparison.json"), &json)?;
    output::write_file(&folder.join("comparison.csv"), &rows(comparison)?)?;
    let picture = figures::gas::draw(comparison);
    plot::save(&picture, &folder.join("comparison.png"))?;
    plot::save(&picture, &folder.join("comparison.svg"))
}

fn rows(comparison: &Comparison) -> Result<Vec<u8>> {
    let mut rows = csv::Writer::from_writer(Vec::new());
    rows.write_record(HEAD)?;
    for summary in &comparison.methods {
        for point in &summary.series {
            let numbers = point.apart.map(|apart| [apart.median, apart.rms, apart.largest]);
            let numbers = numbers.map(|all| all.map(|x| format!("{x:?}"))).unwrap_or_default();
            let mut row = vec![
                summary.method.file_stem().to_owned(),
                format!("{:?}", point.time),
                point.collisions.to_string(),
                format!("{:?}", point.collisions_per_grain),
                format!("{:?}", point.kinetic_energy),
            ];
            row.extend(numbers);
            rows.write_record(row)?;
        }
    }
    Ok(rows.into_inner()?)
}
