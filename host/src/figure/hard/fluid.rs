//! How does a fluid of equal hard spheres start, and does it run on for ever? Reads number, density and seed; writes how far it got.
//!
//! A cooling gas slows down without end, and after some hundred collisions a grain its unit of time is
//! too short for it. Then all velocities are multiplied by a power of two, which is exact, and the unit of time
//! is so much longer from there on; hard spheres have no time of their own, so nothing else changes.
//!
//! A strongly dissipative one ends in bands that stream past each other and hardly collide. Then
//! velocities are drawn anew, of grains where they are: a dense cluster is heated, and cools again.

use anyhow::{Context, Result, bail, ensure};
use carom::HeapMemory;
use carom::law::HardSphere;
use carom::world::{Event, EventOutcome};
use carom::{Enduring, Grain, Instant, Observer, Statistics, World};
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
        libm::pow(self.grains as f64 / self.density, 1.0 / D as f64)
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
    /// An error of the engine.
    pub fn world<'m, const D: usize>(
        &self,
        storage: &'m mut HeapMemory<f64, D>,
        grains: impl IntoIterator<Item = Grain<f64, D>>,
    ) -> Result<Spheres<'m, D>> {
        let half = self.length::<D>() / 2.0;
        let sides = [self.middle - half, self.middle + half];
        let builder = World::builder(storage).enduring(Enduring::Paper).periodic([sides; D]);
        let rule = HardSphere { restitution: self.restitution };
        Ok(builder.rule(rule).grains(grains)?.start()?)
    }

    /// Grains of this fluid after so many elastic collisions a grain, from the lattice: equilibrium.
    ///
    /// # Errors
    /// An error of the engine.
    pub fn equilibrium<const D: usize>(&self, per_grain: u64) -> Result<Vec<Grain<f64, D>>> {
        let mut storage = HeapMemory::with_capacity(self.grains);
        let elastic = Self { restitution: 1.0, ..*self };
        let mut world = elastic.world(&mut storage, self.lattice()?)?;
        while world.statistics().collisions < per_grain * self.grains as u64 / 2 {
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

/// The kinetic energy a grain below which the unit of time is changed: 2^−40.
const SLOW: f64 = 9.094_947_017_729_282e-13;
/// What velocities are multiplied by: 2^20.
const FASTER: f64 = 1_048_576.0;

/// A gas streams if it has more other events than that a collision.
const STREAMING: u64 = 20;

/// A gas that runs.
pub struct Run {
    fluid: Fluid,
    storage: HeapMemory<f64, 3>,
    grains: Vec<Grain<f64, 3>>,
    /// How far it got.
    pub state: RunState,
}

/// How far a gas got.
#[derive(Clone, Debug, Default)]
pub struct RunState {
    /// Collisions of two grains.
    pub collisions: u64,
    /// Time, in the present unit.
    pub time: f64,
    /// How often the unit of time was made 2^20 times longer.
    pub units: u32,
    /// How often velocities were drawn anew.
    pub redrawn: u64,
    /// Kinetic energy a grain, in the present unit.
    pub energy: f64,
    /// The largest change of the energy since the start of a unit of time, relative to it.
    pub energy_change: f64,
    /// The largest change of the total momentum since then, relative to √(2 E m) of all.
    pub momentum_change: f64,
    /// The engine's statistics, summed over all units of time.
    pub statistics: Vec<(&'static str, u64)>,
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
        Self {
            storage: HeapMemory::with_capacity(fluid.grains),
            fluid,
            grains,
            state: RunState::default(),
        }
    }

    /// Runs until so many collisions have happened since the start; `each` is called whenever every grain
    /// has had some 16 of them.
    ///
    /// # Errors
    /// An error of the engine or of `each`, with the number of collisions until then.
    pub fn run<W: Observer<f64, 3>>(
        &mut self,
        collisions: u64,
        observer: &mut W,
        mut each: impl FnMut(&RunState) -> Result<()>,
    ) -> Result<()> {
        loop {
            let mut world = self.fluid.world(&mut self.storage, self.grains.iter().copied())?;
            self.state.last = None;
            let done = one_unit(&mut world, &mut self.state, collisions, observer, &mut each);
            self.grains = grains(&world);
            let count = self.state.collisions;
            done.with_context(|| format!("after {count} collisions"))?;
            if count >= collisions {
                return Ok(());
            }
            if self.state.energy < SLOW {
                self.grains.iter_mut().for_each(|grain| grain.velocity *= FASTER);
                self.state.units += 1;
                self.state.time /= FASTER;
            } else {
                self.redraw_velocities();
            }
        }
    }

    /// Gives the grains the velocities of a gas in equilibrium.
    fn redraw_velocities(&mut self) {
        self.state.redrawn += 1;
        let fluid = Fluid { seed: self.fluid.seed + self.state.redrawn, ..self.fluid };
        for (grain, velocity) in self.grains.iter_mut().zip(fluid.velocities::<3>()) {
            *grain = grain.moving(velocity);
        }
    }
}

/// Runs until the gas is too slow for its unit of time, or streams, or the collisions have happened.
fn one_unit<W: Observer<f64, 3>>(
    world: &mut Spheres<'_, 3>,
    state: &mut RunState,
    collisions: u64,
    observer: &mut W,
    each: &mut impl FnMut(&RunState) -> Result<()>,
) -> Result<()> {
    let before = state.clone();
    let (energy, momentum) = (world.view().kinetic_energy(), world.view().momentum());
    let interval = 8 * world.view().len() as u64;
    loop {
        let until = (state.collisions + interval).min(collisions);
        let mut ended = Ok(());
        let mut events = 0;
        while state.collisions < until && ended.is_ok() && events < STREAMING * interval {
            ended = step(world, state, observer);
            events += 1;
        }
        state.time = before.time + world.now().as_f64();
        let (now, count) = (world.view().kinetic_energy(), world.view().len() as f64);
        let pushed = (world.view().momentum() - momentum).norm() / (2.0 * energy * count).sqrt();
        state.energy = now / count;
        state.energy_change = state.energy_change.max((now / energy - 1.0).abs());
        state.momentum_change = state.momentum_change.max(pushed);
        state.statistics = sum(&before.statistics, world.statistics());
        each(state)?;
        let enough = state.energy < SLOW || state.collisions >= collisions;
        if ended.is_err() || enough || events >= STREAMING * interval {
            return ended;
        }
    }
}

fn step<W: Observer<f64, 3>>(
    world: &mut Spheres<'_, 3>,
    state: &mut RunState,
    observer: &mut W,
) -> Result<()> {
    match world.step_observed(observer)? {
        Some(event) => state.count(&event),
        None => bail!("nothing will ever happen again"),
    }
    Ok(())
}

impl RunState {
    fn count(&mut self, event: &Event<f64>) {
        self.backward += u64::from(self.last.is_some_and(|last| event.at < last));
        if self.last != Some(event.at) {
            self.run = 0;
        }
        self.last = Some(event.at);
        if matches!(event.outcome, Some(EventOutcome::Collision { .. })) {
            self.collisions += 1;
            self.run += 1;
            self.at_once = self.at_once.max(self.run);
        }
    }
}

/// Statistics of an earlier unit of time and of this one.
fn sum(total: &[(&'static str, u64)], more: &Statistics) -> Vec<(&'static str, u64)> {
    let more = [
        ("collisions", more.collisions),
        ("collapses", more.collapses),
        ("reordered", more.reordered),
        ("stale", more.stale),
        ("cell_crossings", more.cell_crossings),
        ("rechecks", more.rechecks),
        ("epochs", more.epochs),
    ];
    let before = |name: &str| total.iter().find(|(other, _)| *other == name).map_or(0, |(_, n)| *n);
    more.iter().map(|(name, count)| (*name, before(name) + count)).collect()
}
