//! What are the pressure and the mean free time of a fluid, and what should they be? Runs an elastic one; writes means with errors.

use super::fluid::Fluid;
use anyhow::Result;
use carom::HeapMemory;
use carom::world::{Event, EventKind};
use carom::{Instant, Observer, View};
use std::f64::consts::PI;

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
/// An error of the engine.
pub fn measure<const D: usize>(
    fluid: &Fluid,
    plan: Plan,
    mut each: impl FnMut(),
) -> Result<Measured> {
    let n = fluid.grains;
    let start = fluid.equilibrium::<D>(plan.equilibrate)?;
    let mut storage = HeapMemory::with_capacity(n);
    let mut world = fluid.world(&mut storage, start)?;
    let energy = world.view().kinetic_energy();
    let kt = 2.0 * energy / (D * (n - 1)) as f64;
    let (mut z, mut time) = (Vec::new(), Vec::new());
    for _ in 0..plan.blocks {
        let mut gauge = Gauge::new(fluid.restitution, world.now());
        while gauge.collisions() < plan.block * n as u64 / 2 {
            world.step_observed(&mut gauge)?;
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

/// Sums what compressibility factor and mean free time are made of.
///
/// Masses are 1 and collisions have coefficient of restitution ε.
#[derive(Clone, Copy, Debug)]
pub struct Gauge {
    restitution: f64,
    begin: Instant,
    virial: f64,
    collisions: u64,
}

impl Gauge {
    /// Begins to measure at this instant.
    pub const fn new(restitution: f64, begin: Instant) -> Self {
        Self { restitution, begin, virial: 0.0, collisions: 0 }
    }

    /// Collisions of two grains so far.
    pub const fn collisions(&self) -> u64 {
        self.collisions
    }

    /// The compressibility factor Z = p V/(N kT) = 1 + Σ r·Δp/(D N kT t), the sum over the collisions of time t.
    pub fn compressibility<const D: usize>(&self, grains: usize, kt: f64, now: Instant) -> f64 {
        let time: f64 = now.since(self.begin);
        1.0 + self.virial / (D as f64 * grains as f64 * kt * time)
    }

    /// The mean time between two collisions of one grain: N t/(2 C) with C collisions of pairs in time t.
    pub fn mean_free_time(&self, grains: usize, now: Instant) -> f64 {
        grains as f64 * now.since::<f64>(self.begin) / (2.0 * self.collisions as f64)
    }
}

impl<const D: usize> Observer<f64, D> for Gauge {
    fn before(&mut self, event: &Event<f64>, view: View<'_, f64, D>) {
        let (EventKind::Collision, Some(k)) = (event.kind, event.partner.as_grain()) else {
            return;
        };
        let (Some(a), Some(b)) = (view.grain(event.grain), view.grain(k)) else { return };
        let r = view.boundary().nearest(a.position - b.position);
        let approach = -r.dot(&(a.velocity - b.velocity));
        self.collisions += 1;
        self.virial += 0.5 * (1.0 + self.restitution) * approach;
    }
}

/// The packing fraction of spheres of diameter 1.
pub fn packing_of_spheres(density: f64) -> f64 {
    density * PI / 6.0
}

/// The packing fraction of disks of diameter 1.
pub fn packing_of_disks(density: f64) -> f64 {
    density * PI / 4.0
}

/// Z of hard spheres at packing fraction η: Carnahan and Starling (J. Chem. Phys. 51, 635, 1969,
/// doi:10.1063/1.1672048). Good to about 0.3 % in the fluid, η < 0.49.
///
/// ```
/// use carom_host::figure::hard::pressure::carnahan_starling;
/// // Second virial coefficient: Z = 1 + 4 η + …
/// assert!(((carnahan_starling(1e-6) - 1.0) / 1e-6 - 4.0).abs() < 1e-4);
/// ```
pub fn carnahan_starling(eta: f64) -> f64 {
    (1.0 + eta + eta * eta - eta.powi(3)) / (1.0 - eta).powi(3)
}

/// Coefficients of η^0, η^1, … in [`hansen_goos`].
const SPHERES: [f64; 8] =
    [9.0, -19.0, 47.0 / 3.0, -2.635_232, -1.265_575, 0.041_212, 0.248_245, -0.096_495];

/// Z of hard spheres at packing fraction η: Hansen-Goos (J. Chem. Phys. 144, 164506, 2016),
/// Eq. (6) and Table I, a fit to simulations over the whole fluid.
///
/// ```
/// use carom_host::figure::hard::pressure::hansen_goos;
/// // The virial coefficients B2 to B7: exact, and Labík, Kolafa and Malijevský (Phys. Rev. E 71, 021105, 2005).
/// let virial = [1.0, 4.0, 10.0, 18.364768, 28.22445, 39.81550, 53.3413];
/// let z: f64 = (0..).zip(virial).map(|(k, b)| b * 0.1_f64.powi(k)).sum();
/// assert!((hansen_goos(0.1) - z).abs() < 2e-5);
/// ```
pub fn hansen_goos(eta: f64) -> f64 {
    let sum = SPHERES.iter().rev().fold(0.0, |sum, c| sum * eta + c);
    8.0 * libm::log1p(-eta) / eta + sum / (1.0 - eta).powi(3)
}

/// Coefficients of x^1, x^2, … in [`kolafa_rottner`].
const DISKS: [f64; 12] = [
    2.0,
    1.128_017_75,
    0.001_818_952_91,
    -0.052_613_473_7,
    0.050_496_016_8,
    -0.032_553_779_2,
    0.013_457_863_2,
    0.001_408_881_82,
    -0.008_342_736_01,
    0.006_941_273_67,
    -0.002_622_547_23,
    0.000_355_746_352,
];

/// Z of hard disks at packing fraction η: Kolafa and Rottner (Mol. Phys. 104, 3435, 2006,
/// doi:10.1080/00268970600967963), their fit up to density 0.9, η < 0.707.
///
/// ```
/// use carom_host::figure::hard::pressure::kolafa_rottner;
/// // The virial series of Clisby and McCoy (J. Stat. Phys. 122, 15, 2006) up to its tenth term.
/// let virial = [1.0, 1.0, 0.782004, 0.5322318, 0.33355604, 0.1988425, 0.1148728, 0.064993, 0.0362193, 0.0199537];
/// let z: f64 = (0..).zip(virial).map(|(k, b)| b * 0.4_f64.powi(k)).sum();
/// assert!((kolafa_rottner(0.2) - z).abs() < 1e-4);
/// ```
pub fn kolafa_rottner(eta: f64) -> f64 {
    let x = eta / (1.0 - eta);
    let sum = DISKS.iter().rev().fold(0.0, |sum, c| (sum + c) * x);
    1.0 + sum - 5.246_729_38e-9 * x.powi(22)
}

/// The mean free time of hard spheres of diameter and mass 1 at kT = 1, with Enskog's exact relation
/// between collision rate and pressure: 1/τ = 4 ρ χ √π, χ = (Z − 1)/(4 η).
pub fn mean_free_time(density: f64, compressibility: f64) -> f64 {
    let chi = (compressibility - 1.0) / (4.0 * packing_of_spheres(density));
    1.0 / (4.0 * density * chi * PI.sqrt())
}

/// The mean free time at density 0.5 by molecular dynamics: Lue (J. Chem. Phys. 122, 044513, 2005,
/// doi:10.1063/1.1834498).
pub const LUE: f64 = 0.1303;
