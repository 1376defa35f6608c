//! How does a fluid of equal hard spheres start? Reads number, density and seed; writes grains on a lattice, and a world of them.
//!
//! Units: diameter σ, mass and kT at the start are 1. The box is periodic.

mod gauge;
mod measure;
mod overlaps;
mod run;
pub mod theory;

pub use gauge::Gauge;
pub use measure::{Mean, Measured, Plan, measure};
pub use overlaps::{Impact, Overlaps};
pub use run::{Pace, Run};

use crate::storage::Storage;
use anyhow::{Result, ensure};
use carom::law::HardSphere;
use carom::{Grain, World};
use rand::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use rand_pcg::Pcg64;

/// The world that all of this is about.
pub type Spheres<'m, const D: usize> = World<'m, f64, D, HardSphere<f64>>;

/// A fluid of N equal hard spheres in D dimensions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fluid {
    /// N.
    pub grains: usize,
    /// Number density ρ = N σ^D/V.
    pub density: f64,
    /// ε.
    pub restitution: f64,
    /// Of the velocities.
    pub seed: u64,
    /// The middle of the box along each axis: 0, or far away, where floating-point numbers are far
    /// apart, to make positions as coarse as one likes.
    pub middle: f64,
}

impl Fluid {
    /// An elastic fluid.
    pub const fn elastic(grains: usize, density: f64) -> Self {
        Self { grains, density, restitution: 1.0, seed: 1, middle: 0.0 }
    }

    /// The length of the box.
    pub fn length<const D: usize>(&self) -> f64 {
        (self.grains as f64 / self.density).powf(1.0 / D as f64)
    }

    /// Grains on the lattice of points with an even sum of coordinates (fcc in 3D), with Maxwellian
    /// velocities, no total momentum and kT = 2 E/(D (N − 1)) = 1.
    ///
    /// # Errors
    /// When the lattice at this density is narrower than a diameter.
    pub fn lattice<const D: usize>(&self) -> Result<Vec<Grain<f64, D>>> {
        let length = self.length::<D>();
        let half = (1..).find(|k: &usize| (2 * k).pow(D as u32) / 2 >= self.grains).unwrap_or(1);
        let step = length / (2 * half) as f64;
        ensure!(
            self.density > 0.0 && step * 2f64.sqrt() > 1.0,
            "density {}: {} grains of diameter 1 do not fit on a lattice in a box of {length:.3}",
            self.density,
            self.grains
        );
        let sites = (0..(2 * half).pow(D as u32)).map(|site| coordinates::<D>(site, 2 * half));
        let even = sites.filter(|at| at.iter().sum::<usize>() % 2 == 0);
        let place =
            |at: [usize; D]| at.map(|c| step * (c as f64 + 0.25) - length / 2.0 + self.middle);
        let grain = |(at, v)| Grain::with_mass(0.5, 1.0).at(place(at)).moving(v);
        Ok(even.zip(self.velocities::<D>()).map(grain).collect())
    }

    fn velocities<const D: usize>(&self) -> Vec<[f64; D]> {
        let mut rng = Pcg64::seed_from_u64(self.seed);
        let mut draw = || std::array::from_fn(|_| StandardNormal.sample(&mut rng));
        let mut all: Vec<[f64; D]> = (0..self.grains).map(|_| draw()).collect();
        let count = self.grains as f64;
        let mean: [f64; D] = std::array::from_fn(|a| all.iter().map(|v| v[a]).sum::<f64>() / count);
        all.iter_mut().for_each(|v| (0..D).for_each(|a| v[a] -= mean[a]));
        let square: f64 = all.iter().flatten().map(|v| v * v).sum();
        let scale = (D as f64 * (count - 1.0) / square).sqrt();
        all.iter_mut().flatten().for_each(|v| *v *= scale);
        all
    }

    /// A world of these grains, wherever they come from.
    ///
    /// # Errors
    /// What the engine says.
    pub fn world<'m, const D: usize>(
        &self,
        storage: &'m mut Storage<f64, D>,
        grains: impl IntoIterator<Item = Grain<f64, D>>,
    ) -> Result<Spheres<'m, D>> {
        let half = self.length::<D>() / 2.0;
        let sides = [self.middle - half, self.middle + half];
        let setup = World::setup(storage).periodic([sides; D]);
        let rule = HardSphere { restitution: self.restitution };
        Ok(setup.rule(rule).grains(grains)?.start()?)
    }

    /// Grains of this fluid after so many elastic collisions a grain, from the lattice: equilibrium.
    ///
    /// # Errors
    /// What the engine says.
    pub fn equilibrium<const D: usize>(&self, per_grain: u64) -> Result<Vec<Grain<f64, D>>> {
        let mut storage = Storage::new(self.grains);
        let elastic = Self { restitution: 1.0, ..*self };
        let mut world = elastic.world(&mut storage, self.lattice()?)?;
        while world.counters().collisions < per_grain * self.grains as u64 / 2 {
            world.step()?;
        }
        Ok(grains(&world))
    }
}

/// All grains as they are now.
pub fn grains<const D: usize>(world: &Spheres<'_, D>) -> Vec<Grain<f64, D>> {
    (0..world.view().len()).filter_map(|i| world.grain(i)).collect()
}

fn coordinates<const D: usize>(mut site: usize, side: usize) -> [usize; D] {
    std::array::from_fn(|_| {
        let c = site % side;
        site /= side;
        c
    })
}
