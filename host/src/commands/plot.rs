//! `carom plot`: how does what a run wrote look? Reads a CSV or Parquet file; writes a picture.

use crate::columns;
use crate::figure::curves::{Curves, Wishes};
use crate::plot;
use anyhow::{Context, Result};
use clap::{Args, ValueEnum};
use std::io::Write;
use std::path::PathBuf;

/// The options of `carom plot`.
#[derive(Args, Debug)]
pub struct Options {
    /// A table of numbers, as carom run writes it: curves over its first column.
    file: PathBuf,
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
    let Options { file, out, show, log } = options;
    let out = out.clone().unwrap_or_else(|| file.with_extension("png"));
    plot::ending(&out)?;
    let (columns, rows) = columns::read_file(file)?;
    let wishes = Wishes {
        show: show.clone(),
        logarithmic: [Log::X, Log::Y].map(|axis| *log == Some(axis) || *log == Some(Log::Xy)),
        title: file.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default(),
    };
    let curves = Curves::new(columns, rows, show).with_context(|| file.display().to_string())?;
    let scene = curves.draw(&wishes).with_context(|| file.display().to_string())?;
    plot::save(&scene, &out)?;
    Ok(writeln!(std::io::stdout().lock(), "{}", out.display())?)
}
