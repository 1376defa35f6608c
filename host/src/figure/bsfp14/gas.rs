//! How far from contact do hard spheres collide? Runs gases at densities and ε; writes the separations at their impacts (BSFP14 Fig. 3).

use crate::figure::data::{Figure, Made, Note, Options, Series};
use crate::figure::draw::{self, Kind, Mark, PlotStyle, Scale};
use crate::figure::hard::{Fluid, Impact, Overlaps, Run};
use crate::plot::Colour;
use crate::progress::Progress;
use anyhow::Result;
use carom::world::Event;
use carom::{Grain, Observer, View};
use rayon::prelude::*;

/// Bins on each side of contact; what is further off is in the outermost.
pub const MAX_EXCESS: i32 = 200;

/// What was seen at the impacts of one gas.
pub struct ImpactStatistics {
    /// ε.
    pub restitution: f64,
    /// ρ.
    pub density: f64,
    /// How often |r| − σ was so many floating-point numbers from contact, from −MAX_EXCESS to MAX_EXCESS.
    pub histogram: Vec<u64>,
    /// Overlapping pairs.
    pub overlaps: Overlaps,
    sum: f64,
    squares: f64,
}

impl ImpactStatistics {
    fn new(fluid: &Fluid) -> Self {
        Self {
            restitution: fluid.restitution,
            density: fluid.density,
            histogram: vec![0; 2 * MAX_EXCESS as usize + 1],
            overlaps: Overlaps::new(fluid.grains),
            sum: 0.0,
            squares: 0.0,
        }
    }

    /// Mean and standard deviation of the excess, in units of the last place of σ = 1.
    pub fn moments(&self) -> (f64, f64) {
        let count = self.overlaps.impacts.max(1) as f64;
        let mean = self.sum / count;
        (mean, (self.squares / count - mean * mean).max(0.0).sqrt())
    }

    /// Which gas it is.
    pub fn name(&self) -> String {
        format!("ε = {}, ρ = {}", self.restitution, self.density)
    }

    /// The most frequent excess, in floating-point numbers.
    pub fn mode(&self) -> i32 {
        let most = (-MAX_EXCESS..).zip(&self.histogram).max_by_key(|(_, count)| **count);
        most.map_or(0, |(bin, _)| bin)
    }

    fn add(&mut self, impact: Impact) {
        let bin = (impact.excess.round() as i32).clamp(-MAX_EXCESS, MAX_EXCESS) + MAX_EXCESS;
        self.histogram[bin as usize] += 1;
        let ulps = if impact.excess < 0.0 { impact.excess / 2.0 } else { impact.excess };
        self.sum += ulps;
        self.squares += ulps * ulps;
    }
}

impl Observer<f64, 3> for ImpactStatistics {
    fn before(&mut self, event: &Event<f64>, view: View<'_, f64, 3>) {
        self.overlaps.before(event, view);
        if let Some(impact) = self.overlaps.impact {
            self.add(impact);
        }
    }

    fn after(&mut self, event: &Event<f64>, view: View<'_, f64, 3>) {
        self.overlaps.after(event, view);
    }
}

/// Runs a gas from equilibrium for so many collisions.
///
/// # Errors
/// An error of the engine.
pub fn run(
    fluid: &Fluid,
    start: &[Grain<f64, 3>],
    collisions: u64,
    mut each: impl FnMut(u64),
) -> Result<ImpactStatistics> {
    let mut seen = ImpactStatistics::new(fluid);
    let mut shown = 0;
    Run::new(*fluid, start.to_vec()).run(collisions, &mut seen, |state| {
        each(state.collisions - shown);
        shown = state.collisions;
        Ok(())
    })?;
    Ok(seen)
}

/// Densities of the paper's gases.
pub const DENSITIES: [f64; 3] = [0.1, 0.5, 0.9];

/// Runs gases like `fluid` at all densities and at these coefficients of restitution, several at once.
///
/// # Errors
/// An error of the engine.
pub fn all(
    id: &str,
    fluid: &Fluid,
    restitutions: &[f64],
    collisions: u64,
) -> Result<Vec<ImpactStatistics>> {
    let gases = (DENSITIES.len() * restitutions.len()) as u64;
    let progress = Progress::new(id, gases * collisions);
    let start = |density: &f64| {
        let fluid = Fluid { density: *density, ..*fluid };
        Ok((fluid, fluid.equilibrium::<3>(20)?))
    };
    let starts = DENSITIES.par_iter().map(start).collect::<Result<Vec<_>>>()?;
    let points: Vec<_> =
        starts.iter().flat_map(|start| restitutions.iter().map(move |e| (start, *e))).collect();
    let gas = |((fluid, start), restitution): &(&(Fluid, Vec<Grain<f64, 3>>), f64)| {
        let fluid = Fluid { restitution: *restitution, ..*fluid };
        run(&fluid, start, collisions, |done| progress.add(done))
    };
    points.par_iter().map(gas).collect()
}

const IMPACT_RESTITUTIONS: [f64; 3] = [1.0, 0.9, 0.5];
/// N of the paper.
const IMPACT_GRAINS: usize = 13_500;

/// Makes the figure: one histogram for each density and coefficient of restitution.
pub fn make_impacts(options: &Options) -> Result<Made> {
    let collisions = if options.full { 1_000_000_000 } else { 150_000 };
    let fluid = Fluid::elastic(IMPACT_GRAINS, 0.5);
    let seen = all("bsfp14-3", &fluid, &IMPACT_RESTITUTIONS, collisions)?;
    let axes = ["|r| − σ [floating-point numbers from σ]", "share of impacts"];
    let mut figure = Figure::new("bsfp14-3", axes);
    let mut notes = Vec::new();
    for seen in &seen {
        figure = figure.with(impact_series(seen));
        notes.push(note_impacts(seen));
    }
    let title = format!("Separation at impact, *N* = 13,500, {collisions} collisions each");
    let style = PlotStyle::new(title)
        .labels("(|*r*| − σ) / distance of floating-point numbers", "share of impacts")
        .scales(Scale::LINEAR.from(-60.0, 60.0), Scale::LOG.from(1e-6, 1.0))
        .kinds(&[Kind::Line])
        .mark(Mark::Place(0.0, "paper: mean and mode at σ".to_owned()));
    let style = PlotStyle { colours: impact_colours(), ..style };
    let picture = draw::draw(&figure, &style);
    Ok(Made { figure, picture, notes })
}

fn impact_series(seen: &ImpactStatistics) -> Series {
    let ImpactStatistics { restitution, density, overlaps, .. } = seen;
    let (mean, deviation) = seen.moments();
    let count = overlaps.impacts as f64;
    let mut impact_series = Series::new(seen.name())
        .param("eps", *restitution)
        .param("density", *density)
        .param("impacts", count)
        .param("overlapping", overlaps.overlapping as f64 / count)
        .param("mean_in_ulps", mean)
        .param("deviation_in_ulps", deviation)
        .param("deepest", -overlaps.deepest);
    for (bin, hits) in (-MAX_EXCESS..).zip(&seen.histogram).filter(|(_, hits)| **hits > 0) {
        impact_series.push(f64::from(bin), *hits as f64 / count);
    }
    impact_series
}

fn note_impacts(seen: &ImpactStatistics) -> Note {
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
fn impact_colours() -> Vec<Colour> {
    let hues = [Colour::BLUE, Colour::EMD_STAR, Colour::EMD];
    let shades = |hue: Colour| [1.0, 0.65, 0.35].map(|opacity| hue.with_opacity(opacity));
    hues.into_iter().flat_map(shades).collect()
}
