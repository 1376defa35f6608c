//! What does a gas of hard spheres show at its impacts? Runs it at a density and a coefficient of restitution; writes a histogram and counts.

use crate::figure::Progress;
use crate::figure::hard::{Fluid, Impact, Overlaps, Run};
use anyhow::Result;
use carom::world::Happening;
use carom::{Grain, View, Watch};
use rayon::prelude::*;

/// Bins on each side of contact; what is further off is in the outermost.
pub const REACH: i32 = 200;

/// What was seen at the impacts of one gas.
pub struct Seen {
    /// ε.
    pub restitution: f64,
    /// ρ.
    pub density: f64,
    /// How often |r| − σ was so many floating-point numbers from contact, from −REACH to REACH.
    pub histogram: Vec<u64>,
    /// Overlapping pairs.
    pub overlaps: Overlaps,
    sum: f64,
    squares: f64,
}

impl Seen {
    fn new(fluid: &Fluid) -> Self {
        Self {
            restitution: fluid.restitution,
            density: fluid.density,
            histogram: vec![0; 2 * REACH as usize + 1],
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
        let most = (-REACH..).zip(&self.histogram).max_by_key(|(_, count)| **count);
        most.map_or(0, |(bin, _)| bin)
    }

    fn add(&mut self, impact: Impact) {
        let bin = (impact.excess.round() as i32).clamp(-REACH, REACH) + REACH;
        self.histogram[bin as usize] += 1;
        let ulps = if impact.excess < 0.0 { impact.excess / 2.0 } else { impact.excess };
        self.sum += ulps;
        self.squares += ulps * ulps;
    }
}

impl Watch<f64, 3> for Seen {
    fn before(&mut self, happening: &Happening<f64>, view: View<'_, f64, 3>) {
        self.overlaps.before(happening, view);
        if let Some(impact) = self.overlaps.impact {
            self.add(impact);
        }
    }

    fn after(&mut self, happening: &Happening<f64>, view: View<'_, f64, 3>) {
        self.overlaps.after(happening, view);
    }
}

/// Runs a gas from equilibrium for so many collisions.
///
/// # Errors
/// What the engine says.
pub fn run(
    fluid: &Fluid,
    start: &[Grain<f64, 3>],
    collisions: u64,
    mut each: impl FnMut(u64),
) -> Result<Seen> {
    let mut seen = Seen::new(fluid);
    let mut shown = 0;
    Run::new(*fluid, start.to_vec()).run(collisions, &mut seen, |pace| {
        each(pace.collisions - shown);
        shown = pace.collisions;
        Ok(())
    })?;
    Ok(seen)
}

/// Densities of the paper's gases.
pub const DENSITIES: [f64; 3] = [0.1, 0.5, 0.9];

/// Runs gases like `fluid` at all densities and at these coefficients of restitution, several at once.
///
/// # Errors
/// What the engine says.
pub fn all(id: &str, fluid: &Fluid, restitutions: &[f64], collisions: u64) -> Result<Vec<Seen>> {
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
