//! `carom plot`: how does what a run wrote look? Reads a CSV or Parquet file, or a scenario and a trajectory; writes a picture.

use crate::columns;
use crate::figure::curves::{Curves, Wishes};
use crate::plot::{self, Scene};
use crate::scenario::{Scenario, Start};
use anyhow::{Context, Result, ensure};
use clap::{Args, ValueEnum};
use std::io::Write;
use std::path::PathBuf;

/// The options of `carom plot`.
#[derive(Args, Debug)]
pub struct Options {
    /// A table of numbers, as carom run writes it: curves over its first column. Or a scenario (.toml): its grains, box
    /// and obstacles.
    file: PathBuf,
    /// With a scenario: the grains of this trajectory (.xyz, as carom run writes it) instead of those at the start.
    #[arg(long, value_name = "TRAJECTORY")]
    grains: Option<PathBuf>,
    /// Which frame of the trajectory, counted from 0; the last one if left out.
    #[arg(long, value_name = "NUMBER", requires = "grains")]
    frame: Option<usize>,
    /// The picture (.png, .svg or .pdf); FILE.png beside the file if left out.
    #[arg(long, value_name = "PICTURE")]
    out: Option<PathBuf>,
    /// Only columns with this in their heads; may be given several times.
    #[arg(long, value_name = "WORDS")]
    show: Vec<String>,
    /// Logarithmic axes.
    #[arg(long, value_enum)]
    log: Option<Log>,
}

/// Which axes are logarithmic.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Log {
    X,
    Y,
    Xy,
}

/// Draws.
///
/// # Errors
/// A file that cannot be read or has nothing to draw, a picture that cannot be written.
pub fn run(options: &Options) -> Result<()> {
    let Options { file, out, grains, .. } = options;
    let is_scenario = file.extension().is_some_and(|ending| ending == "toml");
    let named = grains.as_ref().filter(|_| is_scenario).unwrap_or(file);
    let out = out.clone().unwrap_or_else(|| named.with_extension("png"));
    plot::ending(&out)?;
    let scene = if is_scenario { grains_of(options)? } else { curves_of(options)? };
    plot::save(&scene, &out)?;
    Ok(writeln!(std::io::stdout().lock(), "{}", out.display())?)
}

/// Box, obstacles and grains: those at the start, or of a trajectory's frame.
fn grains_of(options: &Options) -> Result<Scene> {
    let Options { file, grains, frame, show, log, .. } = options;
    ensure!(
        show.is_empty() && log.is_none(),
        "--show and --log are for tables, not for a scenario"
    );
    let scenario = Scenario::read(file)?;
    let start = Start::new(&scenario).with_context(|| file.display().to_string())?;
    let Some(trajectory) = grains else {
        return Ok(plot::grains(&start, &start.grains, &format!("{} (start)", scenario.title)));
    };
    let start = start.with_grains_of(trajectory, *frame)?;
    let frame = frame.map_or_else(|| "last frame".to_owned(), |frame| format!("frame {frame}"));
    Ok(plot::grains(&start, &start.grains, &format!("{} ({frame})", scenario.title)))
}

fn curves_of(options: &Options) -> Result<Scene> {
    let Options { file, show, log, grains, .. } = options;
    ensure!(grains.is_none(), "--grains is for a scenario (.toml), not for {}", file.display());
    let (columns, rows) = columns::read_file(file)?;
    let wishes = Wishes {
        show: show.clone(),
        logarithmic: [Log::X, Log::Y].map(|axis| *log == Some(axis) || *log == Some(Log::Xy)),
        title: file.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default(),
    };
    let curves = Curves::new(columns, rows, show).with_context(|| file.display().to_string())?;
    curves.draw(&wishes).with_context(|| file.display().to_string())
}
