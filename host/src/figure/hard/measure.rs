//! What are the pressure and the mean free time of a fluid? Runs an elastic one in blocks; writes means with their errors.

use super::{Fluid, Gauge};
use crate::storage::Storage;
use anyhow::Result;

/// A mean and its standard error, from blocks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mean {
    /// The mean.
    pub value: f64,
    /// Its standard error.
    pub error: f64,
}

/// What was measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// Z = p V/(N kT).
    pub compressibility: Mean,
    /// The mean time between two collisions of one grain, for kT = 1.
    pub mean_free_time: Mean,
    /// |E/E_0 − 1| at the end.
    pub energy_drift: f64,
}

/// How long to run, in collisions a grain (a collision of two counts for both).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Plan {
    /// Before measuring.
    pub equilibrate: u64,
    /// In each block.
    pub block: u64,
    /// How many blocks.
    pub blocks: u64,
}

/// Measures an elastic fluid in D dimensions; `each` is called after each block.
///
/// kT is 2 E/(D (N − 1)): the total momentum is zero.
///
/// # Errors
/// What the engine says.
pub fn measure<const D: usize>(
    fluid: &Fluid,
    plan: Plan,
    mut each: impl FnMut(),
) -> Result<Measured> {
    let n = fluid.grains;
    let start = fluid.equilibrium::<D>(plan.equilibrate)?;
    let mut storage = Storage::new(n);
    let mut world = fluid.world(&mut storage, start)?;
    let energy = world.view().kinetic_energy();
    let kt = 2.0 * energy / (D * (n - 1)) as f64;
    let (mut z, mut time) = (Vec::new(), Vec::new());
    for _ in 0..plan.blocks {
        let mut gauge = Gauge::new(fluid.restitution, world.now());
        while gauge.collisions() < plan.block * n as u64 / 2 {
            world.step_watched(&mut gauge)?;
        }
        z.push(gauge.compressibility::<D>(n, kt, world.now()));
        time.push(gauge.mean_free_time(n, world.now()) * kt.sqrt());
        each();
    }
    let energy_drift = (world.view().kinetic_energy() / energy - 1.0).abs();
    Ok(Measured { compressibility: mean(&z), mean_free_time: mean(&time), energy_drift })
}

fn mean(values: &[f64]) -> Mean {
    let count = values.len() as f64;
    let value = values.iter().sum::<f64>() / count;
    let square: f64 = values.iter().map(|x| (x - value) * (x - value)).sum();
    Mean { value, error: (square / (count * (count - 1.0))).sqrt() }
}
