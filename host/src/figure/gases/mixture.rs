//! Does a mixture that cools have one temperature? Runs heavy and light grains of constant ε; writes T_1/T_2 beside Garzó and Dufty's theory.
//!
//! Garzó and Dufty (Phys. Rev. E 60, 5706, 1999): both cool at the same rate, and so their temperatures
//! differ. Units: the light grains have mass and diameter 1, and kT is 1 at the start.

use super::direct::Direct;
use super::partial::Parts;
use crate::figure::data::{Figure, Made, Note, Options, Series};
use crate::figure::draw::{self, Kind, Mark, PlotStyle, Scale};
use crate::figure::fit;
use crate::figure::hard::Fluid;
use crate::figure::number::{fixed, measured};
use crate::plot::Scene;
use crate::progress::Progress;
use anyhow::{Context, Result};
use carom::law::HardSphere;
use carom::{Grain, HeapMemory, World};
use rayon::prelude::*;

/// Masses: every other grain is heavy.
const MASSES: [f64; 2] = [8.0, 1.0];
/// Diameters.
const DIAMETERS: [f64; 2] = [2.0, 1.0];
/// Packing fraction.
const PACKING: f64 = 0.005;
/// What it is made of.
pub const PARTS: Parts = Parts { masses: MASSES, diameters: DIAMETERS, packing: PACKING };
const GRAINS: usize = 864;
const RESTITUTIONS: [f64; 5] = [1.0, 0.95, 0.9, 0.8, 0.7];
/// Collisions a grain before measuring, while measuring and between two looks.
pub const COLLISIONS: [u64; 3] = [60, 120, 2];
const SEEDS: u64 = 32;
/// Of Enskog's equation: seeds, grains of each part, collisions a grain before and while measuring.
const ENSKOG: (u64, usize, [u64; 2]) = (4, 5_000, [60, 600]);

/// A mixture of so many grains.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mixture {
    /// N, half of them heavy.
    pub grains: usize,
    /// ε of all pairs.
    pub restitution: f64,
    /// Of the velocities.
    pub seed: u64,
}

impl Mixture {
    fn fluid(&self) -> Fluid {
        let mean = DIAMETERS.iter().map(|d| d.powi(3)).sum::<f64>() / 2.0;
        let density = PACKING * 6.0 / std::f64::consts::PI / mean;
        Fluid { seed: self.seed, ..Fluid::elastic(self.grains, density) }
    }

    /// On a lattice, with Maxwellian velocities of one temperature and no total momentum.
    fn start(&self) -> Result<Vec<Grain<f64, 3>>> {
        let lattice = self.fluid().lattice::<3>()?;
        let kind = |i: usize| [DIAMETERS[i % 2] / 2.0, MASSES[i % 2]];
        let velocity = |(i, grain): (usize, &Grain<f64, 3>)| grain.velocity / kind(i)[1].sqrt();
        let mut velocities: Vec<_> = lattice.iter().enumerate().map(velocity).collect();
        let total: f64 = (0..lattice.len()).map(|i| kind(i)[1]).sum();
        let momentum: carom::nalgebra::SVector<f64, 3> =
            velocities.iter().enumerate().map(|(i, v)| v * kind(i)[1]).sum();
        velocities.iter_mut().for_each(|v| *v -= momentum / total);
        let grain = |(i, v): (usize, &carom::nalgebra::SVector<f64, 3>)| {
            let [radius, mass] = kind(i);
            Grain::with_mass(radius, mass).at(lattice[i].position.into()).moving((*v).into())
        };
        Ok(velocities.iter().enumerate().map(grain).collect())
    }

    /// T_1/T_2 while it cools: the mean of the logarithm over so many collisions a grain, after others.
    ///
    /// # Errors
    /// An error of the engine.
    pub fn ratio(&self, [before, during, every]: [u64; 3]) -> Result<f64> {
        let half = self.fluid().length::<3>() / 2.0;
        let mut storage = HeapMemory::<f64, 3>::with_capacity(self.grains);
        let rule = HardSphere { restitution: self.restitution };
        let builder = World::builder(&mut storage).periodic([[-half, half]; 3]).rule(rule);
        let mut world = builder.grains(self.start()?)?.start()?;
        let mut logs = Vec::new();
        for look in before / every..(before + during) / every {
            while world.statistics().collisions < look * every * self.grains as u64 / 2 {
                world.step()?.context("no grain will ever collide")?;
            }
            let grains = (0..self.grains).map(|i| world.grain(i)).collect::<Option<Vec<_>>>();
            let [heavy, light] = temperatures(&grains.context("a grain")?);
            logs.push(libm::log(heavy / light));
        }
        Ok(libm::exp(fit::mean(&logs)[0]))
    }
}

/// T_1 and T_2, in equal proportion to the gas's own: a grain of mass m has 1 − m/M of it, as the total momentum is zero.
fn temperatures(grains: &[Grain<f64, 3>]) -> [f64; 2] {
    let total: f64 = grains.iter().map(|grain| grain.mass).sum();
    [0, 1].map(|kind| {
        let some = grains.iter().skip(kind).step_by(2);
        let square: f64 = some.map(|grain| grain.velocity.norm_squared()).sum();
        MASSES[kind] * square / (1.0 - MASSES[kind] / total)
    })
}

/// Makes the figure.
///
/// # Errors
/// An error of the engine.
pub fn make(options: &Options) -> Result<Made> {
    let seeds = if options.full { 4 * SEEDS } else { SEEDS };
    let progress = Progress::new("mixture", RESTITUTIONS.len() as u64 * (seeds + ENSKOG.0));
    let ours = means(seeds, |restitution, seed| {
        let found = Mixture { grains: GRAINS, restitution, seed }.ratio(COLLISIONS);
        progress.add(1);
        found
    })?;
    let (seeds, each, collisions) = ENSKOG;
    let enskog = means(seeds, |restitution, seed| {
        let found = Direct { parts: PARTS, restitution, each, seed }.ratio(collisions);
        progress.add(1);
        Ok(found)
    })?;
    let theory = RESTITUTIONS.iter().map(|e| (*e, PARTS.ratio(*e)));
    let theory = theory.fold(Series::new("Garzó and Dufty"), |all, (e, y)| all.point(e, y));
    let figure = Figure::new("mixture", ["ε", "T_1/T_2"])
        .with(series("carom", &ours).param("method", "ED"))
        .with(series("Enskog’s equation, by direct simulation", &enskog).param("method", "DSMC"));
    let picture = picture(&figure);
    let each = RESTITUTIONS.iter().zip(ours.iter().zip(&enskog));
    let notes = each.map(|(e, (ours, enskog))| note(*e, *ours, *enskog)).collect();
    Ok(Made { figure: figure.with(theory.param("method", "theory")), picture, notes })
}

/// Mean and standard error over so many seeds, for each ε.
fn means(seeds: u64, one: impl Fn(f64, u64) -> Result<f64> + Sync) -> Result<Vec<[f64; 2]>> {
    let jobs: Vec<(f64, u64)> =
        RESTITUTIONS.iter().flat_map(|e| (1..=seeds).map(|seed| (*e, seed))).collect();
    let all: Vec<f64> = jobs.par_iter().map(|(e, seed)| one(*e, *seed)).collect::<Result<_>>()?;
    Ok(all.chunks(seeds as usize).map(fit::mean).collect())
}

fn series(name: &str, all: &[[f64; 2]]) -> Series {
    let mut series = Series::new(name);
    let points = RESTITUTIONS.iter().zip(all);
    points.for_each(|(e, [value, error])| series.push_with_error(*e, *value, *error));
    series
}

fn picture(figure: &Figure) -> Scene {
    let steps = (0..=80).map(|k| 0.66 + 0.0043 * f64::from(k)).filter(|e| *e <= 1.0);
    let style = PlotStyle::new("A mixture cools: masses 8 to 1, diameters 2 to 1, η = 0.005")
        .labels("ε", "*T*_{1}/*T*_{2}, heavy over light")
        .scales(Scale::LINEAR.from(0.65, 1.02), Scale::LINEAR.from(0.95, 1.75))
        .kinds(&[Kind::Dots])
        .mark(Mark::Curve(
            steps.map(|e| [e, PARTS.ratio(e)]).collect(),
            "Garzó and Dufty".to_owned(),
        ))
        .mark(Mark::Level(1.0, "one temperature".to_owned()));
    draw::draw(figure, &style)
}

fn note(restitution: f64, ours: [f64; 2], enskog: [f64; 2]) -> Note {
    let expected = PARTS.ratio(restitution);
    let from = |value: f64| fixed(100.0 * (ours[0] / value - 1.0), 2);
    let says = format!(
        "{} ({} % from theory); Enskog’s equation itself {} ({} % from it)",
        measured(ours[0], ours[1]),
        from(expected),
        measured(enskog[0], enskog[1]),
        from(enskog[0])
    );
    let paper = if restitution == 1.0 { "1 (equipartition)" } else { "a curve" };
    Note::new(format!("T_1/T_2 at ε = {restitution}"), paper, says).theory(fixed(expected, 3))
}
