//! How far from contact do spheres collide? Runs gases of 13,500; writes histograms in units of the last place (BSFP14 Fig. 3).

use super::gas::{self, REACH, Seen};
use crate::figure::draw::{self, Kind, Look, Mark, Scale};
use crate::figure::hard::Fluid;
use crate::figure::{Figure, Made, Note, Options, Series};
use crate::plot::{Colour, colour};
use anyhow::Result;

const RESTITUTIONS: [f64; 3] = [1.0, 0.9, 0.5];
/// N of the paper.
const GRAINS: usize = 13_500;

/// Makes the figure: one histogram for each density and coefficient of restitution.
pub fn make(options: &Options) -> Result<Made> {
    let collisions = if options.full { 1_000_000_000 } else { 150_000 };
    let fluid = Fluid::elastic(GRAINS, 0.5);
    let seen = gas::all("bsfp14-3", &fluid, &RESTITUTIONS, collisions)?;
    let axes = ["|r| − σ [floating-point numbers from σ]", "share of impacts"];
    let mut figure = Figure::new("bsfp14-3", axes);
    let mut notes = Vec::new();
    for seen in &seen {
        figure = figure.with(series(seen));
        notes.push(note(seen));
    }
    let title = format!("Separation at impact, *N* = 13,500, {collisions} collisions each");
    let look = Look::new(title)
        .labels("(|*r*| − σ) / distance of floating-point numbers", "share of impacts")
        .scales(Scale::LINEAR.from(-60.0, 60.0), Scale::LOG.from(1e-6, 1.0))
        .kinds(&[Kind::Line])
        .mark(Mark::Place(0.0, "paper: mean and mode at σ".to_owned()));
    let look = Look { colours: colours(), ..look };
    let picture = draw::draw(&figure, &look);
    Ok(Made { figure, picture, notes })
}

fn series(seen: &Seen) -> Series {
    let Seen { restitution, density, overlaps, .. } = seen;
    let (mean, deviation) = seen.moments();
    let count = overlaps.impacts as f64;
    let mut series = Series::new(seen.name())
        .param("eps", *restitution)
        .param("density", *density)
        .param("impacts", count)
        .param("overlapping", overlaps.overlapping as f64 / count)
        .param("mean_in_ulps", mean)
        .param("deviation_in_ulps", deviation)
        .param("deepest", -overlaps.deepest);
    for (bin, hits) in (-REACH..).zip(&seen.histogram).filter(|(_, hits)| **hits > 0) {
        series.push(f64::from(bin), *hits as f64 / count);
    }
    series
}

fn note(seen: &Seen) -> Note {
    let overlaps = &seen.overlaps;
    let (mean, deviation) = seen.moments();
    let share = 100.0 * overlaps.overlapping as f64 / overlaps.impacts as f64;
    let ours = format!(
        "mean {mean:+.2}, mode {:+}, deviation {deviation:.1} ulp; {share:.1} % overlap, at most by {:.1e}",
        seen.mode(),
        -overlaps.deepest
    );
    Note::new(seen.name(), "mean and mode at σ; about half overlap", ours)
}

/// One colour a density, paler the more dissipative.
fn colours() -> Vec<Colour> {
    let hues = [colour::BLUE, colour::EMD_STAR, colour::EMD];
    let shades = |hue: Colour| [1.0, 0.65, 0.35].map(|opacity| hue.with_opacity(opacity));
    hues.into_iter().flat_map(shades).collect()
}
