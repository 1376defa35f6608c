//! How long does a hard sphere fly between two collisions? Runs elastic gases of several densities; writes mean free times beside known ones.

use crate::figure::data::{Figure, Made, Note, Options, Series};
use crate::figure::draw::{self, Kind, Mark, PlotStyle, Scale};
use crate::figure::hard::pressure::{hansen_goos, mean_free_time, packing_of_spheres};
use crate::figure::hard::{Fluid, Mean, Plan, measure};
use crate::figure::number::{fixed, measured};
use crate::plot::Scene;
use crate::progress::Progress;
use anyhow::Result;
use rayon::prelude::*;

/// N, as DynamO's test has it.
const GRAINS: usize = 1_372;
const DENSITIES: [f64; 9] = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9];
/// Density and mean free time of DynamO's test (`hardsphere_test.cpp`, to 1 %), after Lue (2005).
pub const KNOWN: [f64; 2] = [0.5, 0.13031];
/// Collisions a grain before measuring, and in each block.
const PLAN: Plan = Plan { equilibrate: 100, block: 50, blocks: 20 };

/// The mean free time of a gas of this density.
///
/// # Errors
/// An error of the engine.
pub fn free_time(grains: usize, density: f64, plan: Plan) -> Result<Mean> {
    Ok(measure::<3>(&Fluid::elastic(grains, density), plan, || {})?.mean_free_time)
}

/// Enskog's, with Z from a fit to simulations.
fn enskog(density: f64) -> f64 {
    mean_free_time(density, hansen_goos(packing_of_spheres(density)))
}

/// Makes the figure.
///
/// # Errors
/// An error of the engine.
pub fn make(_: &Options) -> Result<Made> {
    let progress = Progress::new("mean-free-time", DENSITIES.len() as u64);
    let one = |density: &f64| {
        let found = free_time(GRAINS, *density, PLAN);
        progress.add(1);
        found
    };
    let found: Vec<Mean> = DENSITIES.par_iter().map(one).collect::<Result<_>>()?;
    let (mut ours, mut theory) = (Series::new("carom"), Series::new("Enskog, Hansen-Goos' Z"));
    for (density, Mean { value, error }) in DENSITIES.iter().zip(&found) {
        ours.push_with_error(*density, *value, *error);
        theory.push(*density, enskog(*density));
    }
    let axes = ["number density ρ σ³", "mean free time (σ √(m/kT))"];
    let figure = Figure::new("mean-free-time", axes).with(ours.param("method", "ED"));
    let picture = picture(&figure);
    let notes = DENSITIES.iter().zip(&found).map(|(density, found)| note(*density, found));
    let notes = notes.collect();
    Ok(Made { figure: figure.with(theory.param("method", "theory")), picture, notes })
}

fn picture(figure: &Figure) -> Scene {
    let steps = (0..=88).map(|k| 0.06 + 0.01 * f64::from(k));
    let style = PlotStyle::new("Mean free time of elastic hard spheres (*N* = 1,372)")
        .labels("number density ρ σ³", "mean free time / σ √(*m*/*kT*)")
        .scales(Scale::LINEAR.from(0.0, 1.0), Scale::LOG.from(0.01, 2.0))
        .kinds(&[Kind::Dots])
        .mark(Mark::Curve(steps.map(|x| [x, enskog(x)]).collect(), "Enskog".to_owned()))
        .mark(Mark::Points(vec![KNOWN], "Lue 2005, in DynamO’s test".to_owned()));
    draw::draw(figure, &style)
}

fn note(density: f64, found: &Mean) -> Note {
    let known = if density == KNOWN[0] { Some(KNOWN[1]) } else { None };
    let expected = enskog(density);
    let from = |whom: &str, value: f64| {
        let more = fixed(100.0 * (found.value / value - 1.0), 2);
        format!("{more} % from {whom}")
    };
    let mut differences = vec![from("Enskog", expected)];
    differences.extend(known.map(|value| from("0.13031", value)));
    let says = format!("{} ({})", measured(found.value, found.error), differences.join(", "));
    let paper = known.map_or("not given".to_owned(), |value| format!("{value} (Lue 2005)"));
    Note::new(format!("ρ σ³ = {density}"), paper, says).theory(fixed(expected, 5))
}
