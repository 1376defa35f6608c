//! `carom table`: what do the tables hold? Reads the certificates; writes them as text or JSON, and MP13's figures.

use crate::plot::figures::matrix;
use crate::plot::{self, Scene};
use anyhow::Result;
use carom_tables::Law;
use clap::Args;
use std::path::{Path, PathBuf};

/// The options of `carom table`.
#[derive(Args, Debug)]
pub struct Options {
    /// Print the certificates as JSON.
    #[arg(long)]
    json: bool,
    /// Draw MP13's Figs. 3, 4 and 5 as NAME-fig3.png and so on (.png or .svg).
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    /// With --plot: draw only this figure, into FILE itself.
    #[arg(long, requires = "plot", value_parser = clap::value_parser!(u8).range(3..=5))]
    figure: Option<u8>,
}

/// Prints the certificates, draws the figures.
///
/// # Errors
/// A file that cannot be written.
pub fn run(options: &Options) -> Result<()> {
    if let Some(file) = &options.plot {
        plot::ending(file)?;
        match options.figure {
            Some(number) => plot::save(&figure(number), file)?,
            None => {
                for number in 3..=5 {
                    plot::save(&figure(number), &numbered(file, number))?;
                }
            }
        }
    }
    Ok(())
}

fn figure(number: u8) -> Scene {
    match number {
        3 => matrix::fig3(),
        4 => matrix::coefficients(Law::LinearDashpot),
        _ => matrix::coefficients(Law::Viscoelastic),
    }
}

/// `maps.png` becomes `maps-fig3.png`.
fn numbered(file: &Path, number: u8) -> PathBuf {
    let stem = file.file_stem().unwrap_or_default().to_string_lossy();
    let ending = file.extension().unwrap_or_default().to_string_lossy();
    file.with_file_name(format!("{stem}-fig{number}.{ending}"))
}
