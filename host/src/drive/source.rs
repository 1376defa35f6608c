//! What drives a run, and what does each source do when it acts? Reads a generator; writes a world between events.

use super::gravity::{Gravity, Vector};
use super::sample;
use anyhow::{Result, bail};
use carom::World;
use carom::law::Rule;
use rand::RngExt;
use rand_pcg::Pcg64;
use serde::{Deserialize, Serialize};

/// Something that gives grains energy, or changes them at a time.
///
/// # Units
/// Temperatures are k T (J), times s, velocities m/s.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(bound = "", rename_all = "snake_case")]
#[non_exhaustive]
pub enum Source<const D: usize> {
    /// A plane, best a hard one, from which grains come as from a gas of this temperature behind it: along the normal
    /// from Maxwell's flux, across it from his distribution.
    ThermalWall {
        /// The plane's number, in the order of the world.
        plane: usize,
        /// k T > 0.
        temperature: f64,
    },
    /// Andersen's thermostat: so often each grain gets a new velocity from Maxwell's distribution
    /// (Andersen, J. Chem. Phys. 72, 2384, 1980).
    Andersen {
        /// k T > 0.
        temperature: f64,
        /// How often a grain is met, per unit of time.
        rate: f64,
    },
    /// White noise, as in gases that are heated throughout (van Noije & Ernst, Granul. Matter 1, 57, 1998): so often
    /// each component of every velocity gets a kick of variance ξ² Δt; their total momentum is taken off.
    WhiteNoise {
        /// ξ²: what a component's variance grows by per unit of time.
        strength: f64,
        /// Δt, short against the mean free time.
        interval: f64,
    },
    /// Gravity over time.
    Gravity(Gravity<D>),
    /// Something at one time.
    At {
        /// When.
        time: f64,
        /// What.
        action: Action<D>,
    },
}

/// What happens to a grain at a time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(bound = "", rename_all = "snake_case")]
#[non_exhaustive]
pub enum Action<const D: usize> {
    /// This is added to its velocity.
    Kick(usize, Vector<D>),
    /// It gets this velocity.
    SetVelocity(usize, Vector<D>),
    /// It is taken out.
    Remove(usize),
}

impl<const D: usize> Source<D> {
    /// What makes no sense in it.
    pub(super) fn check(&self, grains: usize) -> Result<()> {
        let positive = |name: &str, x: f64| match x > 0.0 && x.is_finite() {
            true => Ok(()),
            false => bail!("{name} is {x}, must be finite and above 0"),
        };
        match self {
            Self::ThermalWall { temperature, .. } => positive("temperature", *temperature),
            Self::Andersen { temperature, rate } => {
                positive("temperature", *temperature)?;
                positive("rate", *rate)
            }
            Self::WhiteNoise { strength, interval } => {
                positive("strength", *strength)?;
                positive("interval", *interval)
            }
            Self::Gravity(gravity) => gravity.check(),
            Self::At { time, .. } if !(*time >= 0.0 && time.is_finite()) => {
                bail!("time is {time}, must be finite and at least 0")
            }
            Self::At { action, .. } if action.grain() >= grains => {
                bail!("there is no grain {}, must be below {grains}", action.grain())
            }
            Self::At { .. } => Ok(()),
        }
    }

    /// When it acts first.
    pub(super) fn first_time(&self, grains: usize, rng: &mut Pcg64) -> Option<f64> {
        match self {
            Self::Gravity(gravity) => gravity.first_time(),
            Self::At { time, .. } => Some(*time),
            _ => self.time_after(0.0, grains, rng),
        }
    }

    /// When it acts again on one of so many grains.
    pub(super) fn time_after(&self, now: f64, grains: usize, rng: &mut Pcg64) -> Option<f64> {
        match self {
            Self::ThermalWall { .. } | Self::At { .. } => None,
            Self::Andersen { rate, .. } => Some(now + sample::waiting(rng, rate * grains as f64)),
            Self::WhiteNoise { interval, .. } => Some(((now / interval).round() + 1.0) * interval),
            Self::Gravity(gravity) => gravity.time_after(now),
        }
    }

    /// It acts.
    pub(super) fn act<R: Rule<f64>>(
        &self,
        world: &mut World<'_, f64, D, R>,
        now: f64,
        rng: &mut Pcg64,
    ) -> Result<()> {
        match self {
            Self::ThermalWall { .. } => Ok(()),
            Self::Andersen { temperature, .. } => meet(world, *temperature, rng),
            Self::WhiteNoise { strength, interval } => {
                heat(world, (strength * interval).sqrt(), rng)
            }
            Self::Gravity(gravity) => Ok(world.set_gravity(gravity.at(now))?),
            Self::At { action, .. } => action.happen(world),
        }
    }
}

impl<const D: usize> Action<D> {
    /// Whom it concerns.
    const fn grain(&self) -> usize {
        match self {
            Self::Kick(grain, _) | Self::SetVelocity(grain, _) | Self::Remove(grain) => *grain,
        }
    }

    fn happen<R: Rule<f64>>(&self, world: &mut World<'_, f64, D, R>) -> Result<()> {
        match *self {
            Self::Kick(grain, Vector(change)) => {
                let Some(before) = world.grain(grain) else {
                    bail!("there is no grain {grain} to be kicked");
                };
                let velocity = std::array::from_fn(|axis| before.velocity[axis] + change[axis]);
                Ok(world.set_velocity(grain, velocity)?)
            }
            Self::SetVelocity(grain, Vector(velocity)) => Ok(world.set_velocity(grain, velocity)?),
            Self::Remove(grain) => Ok(world.remove(grain).map(drop)?),
        }
    }
}

/// One grain, drawn at random, meets a particle of the heat bath.
fn meet<const D: usize, R: Rule<f64>>(
    world: &mut World<'_, f64, D, R>,
    temperature: f64,
    rng: &mut Pcg64,
) -> Result<()> {
    let index = rng.random_range(0..world.view().len().max(1));
    let Some(grain) = world.grain(index) else { return Ok(()) };
    let velocity: [f64; D] = sample::maxwell(rng, (temperature / grain.mass).sqrt());
    // The bath of a sheared box flows along.
    let flow = world.view().boundary().flow_at(&grain.position);
    let velocity = std::array::from_fn(|axis| velocity[axis] + flow[axis]);
    Ok(world.set_velocity(index, velocity)?)
}

/// Every grain gets a kick whose components have this standard deviation; together they get no momentum.
fn heat<const D: usize, R: Rule<f64>>(
    world: &mut World<'_, f64, D, R>,
    deviation: f64,
    rng: &mut Pcg64,
) -> Result<()> {
    let grains: Vec<_> = (0..world.view().len())
        .filter_map(|index| world.grain(index).map(|grain| (index, grain)))
        .collect();
    let kicks: Vec<[f64; D]> = grains.iter().map(|_| sample::maxwell(rng, deviation)).collect();
    let mass: f64 = grains.iter().map(|(_, grain)| grain.mass).sum();
    let mean: [f64; D] = std::array::from_fn(|axis| {
        let momentum = grains.iter().zip(&kicks).map(|((_, grain), kick)| grain.mass * kick[axis]);
        momentum.sum::<f64>() / mass
    });
    for ((index, grain), kick) in grains.iter().zip(&kicks) {
        let velocity = std::array::from_fn(|axis| grain.velocity[axis] + kick[axis] - mean[axis]);
        world.set_velocity(*index, velocity)?;
    }
    Ok(())
}
