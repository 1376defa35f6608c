//! `carom demo`: does eMD* give what force-based MD gives? Runs two shipped scenarios three ways; writes tables and pictures.

use crate::compare;
use crate::plot::{self, Scene, figures};
use crate::scenario::Scenario;
use anyhow::{Context, Result};
use clap::Args;
use std::io::Write;
use std::path::{Path, PathBuf};

/// MP13 Fig. 6, as shipped.
pub const FIG6: &str = include_str!("../../scenarios/fig6.toml");
/// The gas, as shipped.
pub const GAS: &str = include_str!("../../scenarios/gas.toml");

/// The options of `carom demo`.
#[derive(Args, Debug)]
pub struct Options {
    /// Where to write the pictures.
    #[arg(long, value_name = "DIR", default_value = "carom-out")]
    out: PathBuf,
}

impl Default for Options {
    fn default() -> Self {
        Self { out: PathBuf::from("carom-out") }
    }
}

/// Runs the demo.
///
/// # Errors
/// A picture that cannot be written.
pub fn run(options: &Options) -> Result<()> {
    let fig6 = Scenario::parse(FIG6).context("fig6.toml")?;
    part(&fig6)?;
    save(&options.out, "fig6", &figures::fig6::draw(&fig6)?)?;
    let gas = Scenario::parse(GAS).context("gas.toml")?;
    let comparison = part(&gas)?;
    save(&options.out, "gas", &figures::gas::draw(&comparison))
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
