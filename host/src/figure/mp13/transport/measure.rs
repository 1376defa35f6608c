//! What are pressure and self-diffusion of an elastic gas of soft spheres? Runs it by eMD, eMD* or MD; writes both.

use super::flux::Flux;
use super::tracks::Tracks;
use crate::figure::hard::theory;
use crate::figure::mp13::gas::{POISSON, RADIUS, SPEED, SoftGas, mass};
use crate::storage::Storage;
use anyhow::Result;
use carom::World;
use carom::law::{Central, Rule};
use carom_reference::{Boundary, End, ForceLaw, Grain, System, Verlet, VerletOptions};
use std::f64::consts::PI;

/// How contacts are dealt with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// As instantaneous collisions.
    Emd,
    /// With the matrix of restitution.
    EmdStar,
    /// By the force, velocity Verlet.
    Md,
}

impl Way {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Emd, Self::EmdStar, Self::Md];

    /// As the figures call it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Emd => "eMD",
            Self::EmdStar => "eMD*",
            Self::Md => "MD",
        }
    }
}

/// How long a gas runs, in mean free times of hard spheres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effort {
    /// Before measuring.
    pub settle: f64,
    /// While measuring.
    pub measure: f64,
    /// Steps of MD per contact.
    pub steps: f64,
}

/// Samples of the positions in a mean free time.
const SAMPLES: usize = 2;
/// Between these ages, in mean free times, the spread of the grains is taken to grow steadily.
const AGES: [usize; 2] = [6, 16];

/// What was measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// D (m²/s).
    pub diffusion: f64,
    /// P V/(2 E/3) with the energy E of the gas: P V/(N k T) where no energy is in contacts.
    pub pressure: f64,
    /// Exceptions of eMD*, of both kinds, per collision.
    pub exceptions: f64,
}

/// Mean free time of hard spheres with this packing fraction, and Enskog's coefficient of
/// self-diffusion in the first Sonine approximation times 1.019 (Chapman and Cowling's fourth).
pub fn enskog(packing: f64) -> [f64; 2] {
    let density = 6.0 * packing / PI;
    let z = theory::carnahan_starling(packing);
    let chi = (z - 1.0) / (4.0 * packing);
    let free = theory::mean_free_time(density, z) * 2.0 * RADIUS / SPEED;
    let diffusion = 1.019 * 3.0 / 8.0 / (density * chi * PI.sqrt()) * 2.0 * RADIUS * SPEED;
    [free, diffusion]
}

/// Times at which a gas is looked at.
struct Clock {
    settle: f64,
    /// Between two looks, in none of which a grain flies through half the box.
    look: f64,
    looks: usize,
    samples: usize,
}

impl Clock {
    fn new(gas: &SoftGas, effort: Effort) -> Self {
        let [free, _] = enskog(gas.packing);
        let interval = free / SAMPLES as f64;
        let looks = (interval * 16.0 * SPEED / gas.edge()).ceil().max(1.0);
        let samples = (effort.measure * SAMPLES as f64) as usize;
        let [settle, look] = [effort.settle * free, interval / looks];
        Self { settle, look, looks: looks as usize, samples }
    }

    /// Runs through all looks; `advance` goes to a time and returns where the grains are then.
    fn run(
        &self,
        edge: f64,
        mut advance: impl FnMut(f64) -> Result<Vec<[f64; 3]>>,
    ) -> Result<Tracks> {
        let mut tracks = Tracks::new(edge, advance(self.settle)?);
        for look in 1..=self.samples * self.looks {
            tracks.follow(advance(self.settle + look as f64 * self.look)?);
            if look % self.looks == 0 {
                tracks.keep();
            }
        }
        Ok(tracks)
    }

    fn measured(&self) -> f64 {
        (self.samples * self.looks) as f64 * self.look
    }

    fn diffusion(&self, tracks: &Tracks) -> f64 {
        tracks.diffusion(AGES.map(|age| age * SAMPLES), self.looks as f64 * self.look)
    }
}

/// Measures an elastic gas.
///
/// # Errors
/// What the engine or the reference says.
pub fn measure(gas: &SoftGas, way: Way, effort: Effort) -> Result<Measured> {
    let gas = SoftGas { dissipation: 0.0, ..*gas };
    match way {
        Way::Emd => by_events(&gas, Central(gas.rule()), effort),
        Way::EmdStar => by_events(&gas, gas.rule(), effort),
        Way::Md => by_force(&gas, effort),
    }
}

fn by_events(gas: &SoftGas, rule: impl Rule<f64>, effort: Effort) -> Result<Measured> {
    let (half, clock) = (0.5 * gas.edge(), Clock::new(gas, effort));
    let mut storage = Storage::<f64, 3>::new(gas.grains);
    let setup = World::setup(&mut storage).periodic([[-half, half]; 3]).rule(rule);
    let mut world = setup.grains(gas.start()?)?.start()?;
    let energy = world.view().kinetic_energy();
    let mut flux = Flux::default();
    let tracks = clock.run(gas.edge(), |t| {
        if t <= clock.settle {
            world.advance_to(t)?;
        } else {
            world.advance_watched(t, &mut flux)?;
        }
        let view = world.view();
        let all = (0..view.len()).filter_map(|i| view.grain(i));
        Ok(all.map(|grain| grain.position.into()).collect())
    })?;
    let counters = world.counters();
    let exceptions = (counters.rotation_refused + counters.interrupted) as f64;
    Ok(Measured {
        diffusion: clock.diffusion(&tracks),
        pressure: 1.0 + flux.sum() / (2.0 * energy * clock.measured()),
        exceptions: exceptions / counters.collisions.max(1) as f64,
    })
}

fn by_force(gas: &SoftGas, effort: Effort) -> Result<Measured> {
    let (half, clock) = (0.5 * gas.edge(), Clock::new(gas, effort));
    let soft = |grain: &carom::Grain<f64, 3>| Grain {
        radius: grain.radius,
        mass: grain.mass,
        position: grain.position.into(),
        velocity: grain.velocity.into(),
    };
    let grains: Vec<Grain<3>> = gas.start()?.iter().map(soft).collect();
    let energy = kinetic(grains.iter().map(|grain| grain.velocity));
    let system = System::new(grains, [Boundary::Periodic { lo: -half, hi: half }; 3], [0.0; 3])?;
    let law = ForceLaw::Viscoelastic { young: gas.young, poisson: POISSON, dissipation: 0.0 };
    let options = VerletOptions { steps_per_contact: effort.steps, ..VerletOptions::default() };
    let mut run = Verlet::new(&system, law, End::Force, options)?;
    let (mut moving, mut before) = (0.0, 0.0);
    let tracks = clock.run(gas.edge(), |t| {
        run.advance_to(t)?;
        if t <= clock.settle {
            before = run.virial();
        } else {
            moving += clock.look * kinetic((0..gas.grains).map(|i| run.velocity(i)));
        }
        Ok((0..gas.grains).map(|i| run.position(i)).collect())
    })?;
    Ok(Measured {
        diffusion: clock.diffusion(&tracks),
        pressure: (2.0 * moving + run.virial() - before) / (2.0 * energy * clock.measured()),
        exceptions: 0.0,
    })
}

fn kinetic(velocities: impl Iterator<Item = [f64; 3]>) -> f64 {
    velocities.flatten().map(|v| 0.5 * mass() * v * v).sum()
}
