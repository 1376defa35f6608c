//! How often do three spheres overlap? Runs gases, with fine and with coarse positions; writes the frequency of doubly overlapped grains (BSFP14 Fig. 5).
//!
//! Overlaps are made by rounding, and with positions to 2⁻⁵³ three of them at once are too rare to be
//! counted. So each gas runs a second time far from the origin, where positions are coarse and the
//! events frequent, and the frequency there is scaled down with the spread of the separations at impact.

use super::gas::{self, DENSITIES, Seen};
use crate::figure::draw::{self, Kind, Look, Mark, Scale};
use crate::figure::hard::Fluid;
use crate::figure::{Figure, Made, Note, Options, Series};
use crate::plot::{Colour, colour};
use anyhow::Result;

const RESTITUTIONS: [f64; 8] = [0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 0.9, 1.0];
/// Below this gases collapse, and what is counted depends on how collapses are ended, not on rounding.
const NO_COLLAPSE: f64 = 0.4;
const GRAINS: usize = 1_372;
/// 1.5 · 2^37: there floating-point numbers are 2^−15 apart.
pub const FAR: f64 = 1.5 * 137_438_953_472.0;

/// Makes the figure: for each density three curves over the coefficient of restitution.
pub fn make(options: &Options) -> Result<Made> {
    let collisions = if options.full { 1_000_000_000 } else { 100_000 };
    let near = Fluid::elastic(GRAINS, 0.5);
    let fine = gas::all("bsfp14-5", &near, &RESTITUTIONS, collisions)?;
    let far = Fluid { middle: FAR, ..near };
    let coarse = gas::all("bsfp14-5, coarse", &far, &RESTITUTIONS, collisions)?;
    let axes = ["coefficient of restitution ε", "three-body impacts per impact"];
    let mut figure = Figure::new("bsfp14-5", axes);
    for (positions, gases) in [("fine", &fine), ("coarse", &coarse)] {
        for density in DENSITIES {
            figure = figure.with(counted(density, positions, gases));
        }
    }
    for density in DENSITIES {
        figure = figure.with(scaled(density, &fine, &coarse));
    }
    let title = format!("Doubly overlapped grains, *N* = 1,372, {collisions} collisions each");
    let look = Look::new(title)
        .scales(Scale::LINEAR.from(0.0, 1.05), Scale::LOG.from(1e-17, 1.0))
        .kinds(&[[Kind::Dots; 3], [Kind::Both; 3], [Kind::Line; 3]].concat())
        .mark(Mark::Points(vec![[1.0, 1e-9]], "paper: elastic, dilute".to_owned()))
        .mark(Mark::Level(1e-6, "paper: inelastic, up to".to_owned()))
        .mark(Mark::Level(1.0 / collisions as f64, "one event in a run".to_owned()));
    let picture = draw::draw(&seen(&figure), &Look { colours: colours(), ..look });
    let notes = fine.iter().zip(&coarse).map(|(fine, coarse)| note(fine, coarse)).collect();
    Ok(Made { figure, picture, notes })
}

/// The points at which there was an event: only they have a place on a logarithmic axis.
fn seen(figure: &Figure) -> Figure {
    let some = |series: &Series| {
        let mut seen = Series::new(&series.name);
        for k in (0..series.x.len()).filter(|k| series.y[*k] > 0.0) {
            seen.push_with_error(series.x[k], series.y[k], series.yerr[k]);
        }
        seen
    };
    Figure { series: figure.series.iter().map(some).collect(), ..figure.clone() }
}

/// Frequency and its error, which is Poisson's, and that of one event where none was seen.
fn frequency(seen: &Seen) -> [f64; 2] {
    let (hits, count) = (seen.overlaps.three_body as f64, seen.overlaps.impacts as f64);
    [hits / count, hits.max(1.0).sqrt() / count]
}

/// The frequency as counted.
fn counted(density: f64, positions: &str, gases: &[Seen]) -> Series {
    let mut series = Series::new(format!("ρ = {density}, {positions}"))
        .param("density", density)
        .param("positions", positions);
    for seen in gases.iter().filter(|seen| seen.density == density) {
        let [share, error] = frequency(seen);
        series.push_with_error(seen.restitution, share, error);
    }
    series
}

/// The frequency to be expected with fine positions: that with coarse ones, in proportion to the spread.
fn expected(fine: &Seen, coarse: &Seen) -> [f64; 2] {
    let ratio = fine.moments().1 / coarse.moments().1;
    frequency(coarse).map(|share| share * ratio)
}

fn scaled(density: f64, fine: &[Seen], coarse: &[Seen]) -> Series {
    let mut series = Series::new(format!("ρ = {density}, scaled"))
        .param("density", density)
        .param("positions", "coarse, scaled to fine");
    let here = |seen: &Seen| seen.density == density && seen.restitution >= NO_COLLAPSE;
    for (fine, coarse) in fine.iter().zip(coarse).filter(|(fine, _)| here(fine)) {
        let [share, error] = expected(fine, coarse);
        series.push_with_error(fine.restitution, share, error);
    }
    series
}

fn note(fine: &Seen, coarse: &Seen) -> Note {
    let paper = if fine.restitution == 1.0 { "≈ 1e-9 (dilute)" } else { "up to ≈ 1e-6" };
    let counted = format!(
        "{} of {} impacts; coarse positions {}",
        fine.overlaps.three_body, fine.overlaps.impacts, coarse.overlaps.three_body
    );
    let [share, error] = expected(fine, coarse);
    let ours = match fine.restitution >= NO_COLLAPSE {
        true => format!("{counted}, scaled to fine ones ({share:.1e} ± {error:.1e})"),
        false => counted,
    };
    Note::new(fine.name(), paper, ours)
}

/// One colour a density.
fn colours() -> Vec<Colour> {
    let hues = [colour::BLUE, colour::EMD_STAR, colour::EMD];
    let shades = |opacity: f32| hues.map(|hue| hue.with_opacity(opacity));
    [1.0, 0.6, 1.0].into_iter().flat_map(shades).collect()
}
