//! How often does a sphere overlap two others at an impact? Runs gases of hard spheres; writes the frequency against ε (BSFP14 Fig. 5).
//!
//! Overlaps are made by rounding, and with positions to 2⁻⁵³ three of them at once are too rare to be
//! counted. So each gas runs a second time far from the origin, where positions are coarse and the
//! events frequent, and the frequency there is scaled down with the spread of the separations at impact.

use super::gas::{DENSITIES, ImpactStatistics, all};
use crate::figure::data::{Figure, Made, Note, Options, Series};
use crate::figure::draw::{self, Kind, Mark, PlotStyle, Scale};
use crate::figure::hard::Fluid;
use crate::plot::{Colour, Scene};
use anyhow::Result;

const RESTITUTIONS: [f64; 8] = [0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 0.9, 1.0];
/// Below this all dense gases collapse.
const NO_COLLAPSE: f64 = 0.4;
const GRAINS: usize = 1_372;
/// 1.5 · 2^37: there floating-point numbers are 2^−15 apart.
pub const FAR: f64 = 1.5 * 137_438_953_472.0;

/// Makes the figure: for each density three curves over the coefficient of restitution.
///
/// # Errors
/// An error of the engine.
pub fn make(options: &Options) -> Result<Made> {
    let collisions = if options.full { 5_000_000 } else { 100_000 };
    let near = Fluid::elastic(GRAINS, 0.5);
    let fine = all("bsfp14-5", &near, &RESTITUTIONS, collisions)?;
    let far = Fluid { middle: FAR, ..near };
    let coarse = all("bsfp14-5, coarse", &far, &RESTITUTIONS, collisions)?;
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
    let picture = picture(&figure, collisions);
    let notes = fine.iter().zip(&coarse).map(|(fine, coarse)| note(fine, coarse)).collect();
    Ok(Made { figure, picture, notes })
}

fn picture(figure: &Figure, collisions: u64) -> Scene {
    let title = format!("Doubly overlapped grains, *N* = 1,372, {collisions} collisions each");
    let style = PlotStyle::new(title)
        .scales(Scale::LINEAR.from(0.0, 1.05), Scale::LOG.from(1e-17, 1.0))
        .kinds(&[[Kind::Dots; 3], [Kind::Both; 3], [Kind::Line; 3]].concat())
        .mark(Mark::Points(vec![[1.0, 1e-9]], "paper: elastic, dilute".to_owned()))
        .mark(Mark::Level(1e-6, "paper: inelastic, up to".to_owned()))
        .mark(Mark::Level(1.0 / collisions as f64, "one event in a run".to_owned()));
    draw::draw(&seen(figure), &PlotStyle { colours: colours(), ..style })
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

/// Whether collapses decide what is counted, not rounding: with fine positions three bodies overlap in collapses only.
fn collapses(fine: &ImpactStatistics) -> bool {
    fine.restitution < NO_COLLAPSE || fine.overlaps.three_body > 0
}

/// Frequency and its error, which is Poisson's, and that of one event where none was seen.
fn frequency(seen: &ImpactStatistics) -> [f64; 2] {
    let (hits, count) = (seen.overlaps.three_body as f64, seen.overlaps.impacts as f64);
    [hits / count, hits.max(1.0).sqrt() / count]
}

/// The frequency as counted.
fn counted(density: f64, positions: &str, gases: &[ImpactStatistics]) -> Series {
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
fn expected(fine: &ImpactStatistics, coarse: &ImpactStatistics) -> [f64; 2] {
    let ratio = fine.moments().1 / coarse.moments().1;
    frequency(coarse).map(|share| share * ratio)
}

fn scaled(density: f64, fine: &[ImpactStatistics], coarse: &[ImpactStatistics]) -> Series {
    let mut series = Series::new(format!("ρ = {density}, scaled"))
        .param("density", density)
        .param("positions", "coarse, scaled to fine");
    let here = |fine: &ImpactStatistics| fine.density == density && !collapses(fine);
    for (fine, coarse) in fine.iter().zip(coarse).filter(|(fine, _)| here(fine)) {
        let [share, error] = expected(fine, coarse);
        series.push_with_error(fine.restitution, share, error);
    }
    series
}

fn note(fine: &ImpactStatistics, coarse: &ImpactStatistics) -> Note {
    let paper = if fine.restitution == 1.0 { "≈ 1e-9 (dilute)" } else { "up to ≈ 1e-6" };
    let counted = format!(
        "{} of {} impacts; coarse positions {}",
        fine.overlaps.three_body, fine.overlaps.impacts, coarse.overlaps.three_body
    );
    let [share, error] = expected(fine, coarse);
    let ours = match collapses(fine) {
        true => counted,
        false => format!("{counted}, scaled to fine ones ({share:.1e} ± {error:.1e})"),
    };
    Note::new(fine.name(), paper, ours)
}

/// One colour a density.
fn colours() -> Vec<Colour> {
    let hues = [Colour::BLUE, Colour::EMD_STAR, Colour::EMD];
    let shades = |opacity: f32| hues.map(|hue| hue.with_opacity(opacity));
    [1.0, 0.6, 1.0].into_iter().flat_map(shades).collect()
}
