//! Does a dissipative gas run on for ever? Runs collisions by the million, watched; writes how far it got.
//!
//! A cooling gas slows down without end, and after some hundred collisions a grain its unit of time is
//! too short for it. Then all velocities are multiplied by a power of two, which is exact, and the unit of time
//! is so much longer from there on; hard spheres have no time of their own, so nothing else changes.
//!
//! A strongly dissipative one ends in bands that stream past each other and hardly collide. Then
//! velocities are drawn anew, of grains where they are: a dense cluster is heated, and cools again.

use super::{Fluid, Spheres, grains};
use crate::storage::Storage;
use anyhow::{Context, Result, bail};
use carom::event::Deed;
use carom::world::Happening;
use carom::{Counters, Grain, Instant, Watch};

/// The kinetic energy a grain below which the unit of time is changed: 2^−40.
const SLOW: f64 = 9.094_947_017_729_282e-13;
/// What velocities are multiplied by: 2^20.
const FASTER: f64 = 1_048_576.0;

/// A gas streams if it has more other events than that a collision.
const STREAMING: u64 = 20;

/// A gas that runs.
pub struct Run {
    fluid: Fluid,
    storage: Storage<f64, 3>,
    grains: Vec<Grain<f64, 3>>,
    /// How far it got.
    pub pace: Pace,
}

/// How far a gas got.
#[derive(Clone, Debug, Default)]
pub struct Pace {
    /// Collisions of two grains.
    pub collisions: u64,
    /// Time, in the present unit.
    pub time: f64,
    /// How often the unit of time was made 2^20 times longer.
    pub units: u32,
    /// How often velocities were drawn anew.
    pub stirred: u64,
    /// Kinetic energy a grain, in the present unit.
    pub energy: f64,
    /// The engine's counters, summed over all units of time.
    pub counters: Vec<(&'static str, u64)>,
    /// Events that were before the one before them.
    pub backward: u64,
    /// The most collisions at one instant.
    pub at_once: u64,
    run: u64,
    last: Option<Instant>,
}

impl Run {
    /// A gas that starts from these grains.
    pub fn new(fluid: Fluid, grains: Vec<Grain<f64, 3>>) -> Self {
        Self { storage: Storage::new(fluid.grains), fluid, grains, pace: Pace::default() }
    }

    /// Runs until so many collisions have happened since the start; `each` looks whenever every grain
    /// has had some 16 of them.
    ///
    /// # Errors
    /// What the engine or `each` says, with the number of collisions until then.
    pub fn run<W: Watch<f64, 3>>(
        &mut self,
        collisions: u64,
        watch: &mut W,
        mut each: impl FnMut(&Pace) -> Result<()>,
    ) -> Result<()> {
        loop {
            let mut world = self.fluid.world(&mut self.storage, self.grains.iter().copied())?;
            self.pace.last = None;
            let done = one_unit(&mut world, &mut self.pace, collisions, watch, &mut each);
            self.grains = grains(&world);
            let count = self.pace.collisions;
            done.with_context(|| format!("after {count} collisions"))?;
            if count >= collisions {
                return Ok(());
            }
            if self.pace.energy < SLOW {
                self.grains.iter_mut().for_each(|grain| grain.velocity *= FASTER);
                self.pace.units += 1;
                self.pace.time /= FASTER;
            } else {
                self.stir();
            }
        }
    }

    /// Gives the grains the velocities of a gas in equilibrium.
    fn stir(&mut self) {
        self.pace.stirred += 1;
        let fluid = Fluid { seed: self.fluid.seed + self.pace.stirred, ..self.fluid };
        for (grain, velocity) in self.grains.iter_mut().zip(fluid.velocities::<3>()) {
            *grain = grain.moving(velocity);
        }
    }
}

/// Runs until the gas is too slow for its unit of time, or streams, or the collisions have happened.
fn one_unit<W: Watch<f64, 3>>(
    world: &mut Spheres<'_, 3>,
    pace: &mut Pace,
    collisions: u64,
    watch: &mut W,
    each: &mut impl FnMut(&Pace) -> Result<()>,
) -> Result<()> {
    let before = pace.clone();
    let look = 8 * world.view().len() as u64;
    loop {
        let until = (pace.collisions + look).min(collisions);
        let mut ended = Ok(());
        let mut events = 0;
        while pace.collisions < until && ended.is_ok() && events < STREAMING * look {
            ended = step(world, pace, watch);
            events += 1;
        }
        pace.time = before.time + world.now().as_f64();
        pace.energy = world.view().kinetic_energy() / world.view().len() as f64;
        pace.counters = sum(&before.counters, world.counters());
        each(pace)?;
        let enough = pace.energy < SLOW || pace.collisions >= collisions;
        if ended.is_err() || enough || events >= STREAMING * look {
            return ended;
        }
    }
}

fn step<W: Watch<f64, 3>>(
    world: &mut Spheres<'_, 3>,
    pace: &mut Pace,
    watch: &mut W,
) -> Result<()> {
    match world.step_watched(watch)? {
        Some(happening) => pace.see(&happening),
        None => bail!("nothing will ever happen again"),
    }
    Ok(())
}

impl Pace {
    fn see(&mut self, happening: &Happening<f64>) {
        self.backward += u64::from(self.last.is_some_and(|last| happening.at < last));
        if self.last != Some(happening.at) {
            self.run = 0;
        }
        self.last = Some(happening.at);
        if matches!(happening.deed, Some(Deed::Collision { .. })) {
            self.collisions += 1;
            self.run += 1;
            self.at_once = self.at_once.max(self.run);
        }
    }
}

/// Counters of an earlier unit of time and of this one.
fn sum(total: &[(&'static str, u64)], more: &Counters) -> Vec<(&'static str, u64)> {
    let more = [
        ("collisions", more.collisions),
        ("collapses", more.collapses),
        ("reordered", more.reordered),
        ("stale", more.stale),
        ("wanderings", more.wanderings),
        ("epochs", more.epochs),
    ];
    let before = |name: &str| total.iter().find(|(other, _)| *other == name).map_or(0, |(_, n)| *n);
    more.iter().map(|(name, count)| (*name, before(name) + count)).collect()
}
