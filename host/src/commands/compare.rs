//! `carom compare`, `carom demo`: do the methods agree? Reads a scenario, or two shipped ones; writes tables or JSON, and pictures.

use crate::compare::{self, Comparison};
use crate::output;
use crate::plot::{self, Scene, methods};
use crate::scenario::Scenario;
use anyhow::{Context, Result};
use clap::Args;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

/// The options of `carom compare`.
#[derive(Args, Debug)]
pub struct CompareOptions {
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
    "difference_median",
    "difference_rms",
    "difference_max",
];

/// Runs and compares.
///
/// # Errors
/// A scenario that cannot be read or run, a file that cannot be written.
pub fn compare(options: &CompareOptions) -> Result<()> {
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
fn write_files(folder: &Path, comparison: &Comparison) -> Result<()> {
    let json = serde_json::to_vec_pretty(comparison)?;
    output::write_file(&folder.join("comparison.json"), &json)?;
    output::write_file(&folder.join("comparison.csv"), &rows(comparison)?)?;
    let picture = methods::gas(comparison);
    plot::save(&picture, &folder.join("comparison.png"))?;
    plot::save(&picture, &folder.join("comparison.svg"))
}

fn rows(comparison: &Comparison) -> Result<Vec<u8>> {
    let mut rows = csv::Writer::from_writer(Vec::new());
    rows.write_record(HEAD)?;
    for summary in &comparison.methods {
        for point in &summary.series {
            let numbers = point.difference.map(|of| [of.median, of.rms, of.max]);
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

/// MP13 Fig. 6, as shipped.
pub const FIG6: &str = crate::figure::mp13::pair::SCENARIO;
/// The gas, as shipped.
pub const GAS: &str = include_str!("../../scenarios/gas.toml");

/// The options of `carom demo`.
#[derive(Args, Debug)]
pub struct DemoOptions {
    /// Where to write the pictures.
    #[arg(long, value_name = "DIR", default_value = "carom-out")]
    out: PathBuf,
}

impl Default for DemoOptions {
    fn default() -> Self {
        Self { out: PathBuf::from("carom-out") }
    }
}

/// Runs the demo.
///
/// # Errors
/// A picture that cannot be written.
pub fn demo(options: &DemoOptions) -> Result<()> {
    let fig6 = Scenario::parse(FIG6).context("fig6.toml")?;
    part(&fig6)?;
    save(&options.out, "fig6", &methods::fig6(&fig6)?)?;
    let gas = Scenario::parse(GAS).context("gas.toml")?;
    let comparison = part(&gas)?;
    save(&options.out, "gas", &methods::gas(&comparison))
}

fn part(scenario: &Scenario) -> Result<compare::Comparison> {
    let (start, tracks) = compare::tracks(scenario)?;
    let comparison = compare::summarise(scenario, &start, &tracks)?;
    let mut sink = std::io::stdout().lock();
    compare::print(&mut sink, &comparison)?;
    sink.flush()?;
    Ok(comparison)
}

/// Writes a picture as PNG and SVG and says where.
fn save(folder: &Path, name: &str, scene: &Scene) -> Result<()> {
    let files = ["png", "svg"].map(|ending| folder.join(format!("{name}.{ending}")));
    files.iter().try_for_each(|file| plot::save(scene, file))?;
    let [png, svg] = files.map(|file| file.display().to_string());
    Ok(writeln!(std::io::stdout().lock(), "  pictures: {png}, {svg}\n")?)
}
