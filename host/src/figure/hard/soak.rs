//! Does a dissipative gas run on for ever? Runs collisions by the million; writes what was seen on the way.
//!
//! A cooling gas slows down without end: after some ten collisions a grain its unit of time is too
//! short for it. Then all velocities are multiplied by a power of two, which is exact, and the unit of time
//! is so much longer from there on; hard spheres have no time of their own, so nothing else changes.

use super::{Fluid, Overlaps, Spheres, grains};
use crate::storage::Storage;
use anyhow::{Context, Result};
use carom::event::Deed;
use carom::world::Happening;
use carom::{Counters, Grain, Instant, View, Watch};

/// The kinetic energy a grain below which the unit of time is changed.
const SLOW: f64 = 9.094_947_017_729_282e-13;
/// What velocities are multiplied by: 2^20.
const FASTER: f64 = 1_048_576.0;

/// A gas that runs.
pub struct Soak {
    fluid: Fluid,
    storage: Storage<f64, 3>,
    grains: Vec<Grain<f64, 3>>,
    /// Everything that was seen.
    pub state: State,
}

/// What was seen of a run.
#[derive(Clone, Debug, Default)]
pub struct State {
    /// Overlapping pairs.
    pub overlaps: Overlaps,
    /// The engine's counters, summed over all units of time.
    pub counters: Counters,
    /// Time, in the present unit.
    pub time: f64,
    /// How often the unit of time was made 2^20 times longer.
    pub units: u32,
    /// Kinetic energy a grain, in the present unit.
    pub energy: f64,
    /// Collisions, of all units of time.
    pub collisions: u64,
    /// Events that were before the one before them.
    pub backward: u64,
    /// The longest sequence of collisions at one instant.
    pub at_once: u64,
    run: u64,
    last: Option<Instant>,
}

impl Soak {
    /// A gas in equilibrium, about to cool.
    ///
    /// # Errors
    /// What the engine says.
    pub fn new(fluid: Fluid) -> Result<Self> {
        let state = State { overlaps: Overlaps::new(fluid.grains), ..State::default() };
        let grains = fluid.equilibrium::<3>(20)?;
        Ok(Self { storage: Storage::new(fluid.grains), fluid, grains, state })
    }

    /// Runs until so many collisions have happened since the start; `each` looks
    /// whenever every grain has had some 64 of them.
    ///
    /// # Errors
    /// What the engine says, with the number of collisions until then.
    pub fn run(
        &mut self,
        collisions: u64,
        mut each: impl FnMut(&State) -> Result<()>,
    ) -> Result<()> {
        loop {
            let mut world = self.fluid.world(&mut self.storage, self.grains.iter().copied())?;
            self.state.last = None;
            let done = one_unit(&mut world, &mut self.state, collisions, &mut each);
            self.grains = grains(&world);
            sum(&mut self.state.counters, world.counters());
            let count = self.state.collisions;
            done.with_context(|| format!("after {count} collisions"))?;
            if self.state.collisions >= collisions {
                return Ok(());
            }
            self.grains.iter_mut().for_each(|grain| grain.velocity *= FASTER);
            self.state.units += 1;
            self.state.time /= FASTER;
        }
    }
}

/// Runs until the gas is too slow for its unit of time, or the collisions have happened.
fn one_unit(
    world: &mut Spheres<'_, 3>,
    state: &mut State,
    collisions: u64,
    each: &mut impl FnMut(&State) -> Result<()>,
) -> Result<()> {
    let before = state.time;
    let look = 32 * world.view().len() as u64;
    loop {
        let until = (state.collisions + look).min(collisions);
        while state.collisions < until {
            if world.step_watched(state)?.is_none() {
                anyhow::bail!("nothing will ever happen again");
            }
        }
        state.time = before + world.now().as_f64();
        state.energy = world.view().kinetic_energy() / world.view().len() as f64;
        each(state)?;
        if state.energy < SLOW || state.collisions >= collisions {
            return Ok(());
        }
    }
}

impl Watch<f64, 3> for State {
    fn before(&mut self, happening: &Happening<f64>, view: View<'_, f64, 3>) {
        self.overlaps.before(happening, view);
        self.backward += u64::from(self.last.is_some_and(|last| happening.at < last));
        if self.last != Some(happening.at) {
            self.run = 0;
        }
        self.last = Some(happening.at);
    }

    fn after(&mut self, happening: &Happening<f64>, view: View<'_, f64, 3>) {
        self.overlaps.after(happening, view);
        if matches!(happening.deed, Some(Deed::Collision { .. })) {
            self.collisions += 1;
            self.run += 1;
            self.at_once = self.at_once.max(self.run);
        }
    }
}

/// Adds counters of one unit of time.
fn sum(total: &mut Counters, more: &Counters) {
    total.collisions += more.collisions;
    total.stale += more.stale;
    total.wanderings += more.wanderings;
    total.epochs += more.epochs;
}
