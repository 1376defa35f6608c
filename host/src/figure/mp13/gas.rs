//! What is MP13's gas of soft spheres? Reads packing fraction and material; runs it by eMD*, writes how often it makes exceptions (MP13 Sec. VI B 6).

use crate::figure::hard::Fluid;
use crate::storage::Storage;
use crate::tables::{Size, embedded};
use anyhow::{Context, Result};
use carom::law::{Outside, Soft, Viscoelastic};
use carom::{Counters, Grain, World};
use carom_tables::read::Law;
use std::f64::consts::{PI, SQRT_2};

/// R.
pub const RADIUS: f64 = 0.1;
const MATERIAL_DENSITY: f64 = 1140.0;
/// ν.
pub const POISSON: f64 = 0.4;
/// Of each component of the velocity: a thermal velocity √(2 kT/m) of 2 m/s.
pub const SPEED: f64 = SQRT_2;
/// Elastic collisions of each grain, as hard spheres, before the gas is made soft.
const EQUILIBRATION: u64 = 4;

/// The paper's gas of viscoelastic spheres in a periodic box.
///
/// # Units
/// SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SoftGas {
    /// N.
    pub grains: usize,
    /// Packing fraction η (MP13 Eq. 66).
    pub packing: f64,
    /// Young's modulus Y.
    pub young: f64,
    /// Dissipative parameter A.
    pub dissipation: f64,
    /// Of the velocities at the start.
    pub seed: u64,
}

/// What was counted.
#[derive(Clone, Copy, Debug)]
pub struct Counted {
    /// By the engine.
    pub counters: Counters,
    /// The thermal velocity at the end, √(2 kT/m).
    pub thermal_velocity: f64,
}

impl Counted {
    /// Of every thousand collisions, how many were such, with Poisson's error; that of one where none was.
    pub fn per_thousand(&self, exceptions: u64) -> [f64; 2] {
        let thousands = self.counters.collisions.max(1) as f64 / 1000.0;
        [exceptions as f64 / thousands, (exceptions.max(1) as f64).sqrt() / thousands]
    }
}

/// The mass of a grain.
pub fn mass() -> f64 {
    MATERIAL_DENSITY * 4.0 / 3.0 * PI * RADIUS.powi(3)
}

impl SoftGas {
    fn fluid(&self) -> Fluid {
        let fluid = Fluid::elastic(self.grains, 6.0 * self.packing / PI);
        Fluid { seed: self.seed, ..fluid }
    }

    /// The edge of the box, which is centred at 0.
    pub fn edge(&self) -> f64 {
        2.0 * RADIUS * self.fluid().length::<3>()
    }

    /// The force law.
    pub const fn law(&self) -> Viscoelastic<f64> {
        let Self { young, dissipation, .. } = *self;
        Viscoelastic { young, poisson: POISSON, dissipation }
    }

    /// What grains do by eMD*: the wide table, and hard spheres outside of it.
    pub fn rule(&self) -> Soft<Viscoelastic<f64>> {
        let table = embedded(Size::Wide, Law::Viscoelastic);
        Soft::with_table(self.law(), table, Outside::HardSphere)
    }

    /// Grains in equilibrium, as hard spheres.
    ///
    /// # Errors
    /// What the engine says.
    pub fn start(&self) -> Result<Vec<Grain<f64, 3>>> {
        let soft = |grain: &Grain<f64, 3>| {
            let (at, v) = (grain.position * (2.0 * RADIUS), grain.velocity * SPEED);
            Grain::with_mass(RADIUS, mass()).at([at[0], at[1], at[2]]).moving([v[0], v[1], v[2]])
        };
        Ok(self.fluid().equilibrium::<3>(EQUILIBRATION)?.iter().map(soft).collect())
    }

    /// Counts the exceptions in so many collisions.
    ///
    /// # Errors
    /// What the engine says.
    pub fn count(&self, collisions: u64) -> Result<Counted> {
        let half = 0.5 * self.edge();
        let mut storage = Storage::<f64, 3>::new(self.grains);
        let setup = World::setup(&mut storage).periodic([[-half, half]; 3]).rule(self.rule());
        let mut world = setup.grains(self.start()?)?.start()?;
        while world.counters().collisions < collisions {
            world.step()?.context("no grain will ever meet another")?;
        }
        let energy = world.view().kinetic_energy() / (self.grains as f64 * mass());
        Ok(Counted { counters: *world.counters(), thermal_velocity: (4.0 / 3.0 * energy).sqrt() })
    }
}
