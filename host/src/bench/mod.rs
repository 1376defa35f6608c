//! How fast is the engine? Reads a case; runs it on one core, returns collisions per second and bytes per grain.
//!
//! A gas starts on a lattice, is equilibrated for eight collisions a grain, and is then timed for a
//! fixed number of collisions, so that two builds do the same work. What counts is user CPU time;
//! crossings into another cell and ends of contacts are work, but no collisions.

mod case;
pub mod clock;
mod lattice;

pub use case::{ALL, Case, Contact, named};

use crate::storage::Storage;
use anyhow::{Context, Result};
use carom::law::{Central, HardSphere, Outside, Rule, Soft, Viscoelastic};
use carom::{Lend, World};
use serde::Serialize;

/// Collisions before the clock starts, in units of the number of grains: two grains share one.
const EQUILIBRATION: u64 = 4;

/// What was measured.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Row {
    /// The case.
    pub case: &'static str,
    /// Its number of grains.
    pub n: usize,
    /// `events` / `seconds`.
    pub collisions_per_s: f64,
    /// All the memory that the world borrows, by grain.
    pub bytes_per_grain: f64,
    /// Collisions that were timed.
    pub events: u64,
    /// User CPU time that they took (s).
    pub seconds: f64,
    /// The time that went by in the world.
    #[serde(skip)]
    pub simulated: f64,
}

/// How much of a case is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Collisions before the clock starts.
    pub equilibration: u64,
    /// Collisions that are timed.
    pub collisions: u64,
}

/// Equilibrates a case and times its collisions.
///
/// # Errors
/// A fault of the engine.
pub fn measure(case: &Case) -> Result<Row> {
    let equilibration = EQUILIBRATION * case.count as u64;
    measure_with(case, Effort { equilibration, collisions: case.collisions })
}

/// As [`measure`], with another effort.
///
/// # Errors
/// As [`measure`].
pub fn measure_with(case: &Case, effort: Effort) -> Result<Row> {
    match case.dimension {
        1 => with_rule::<1>(case, effort),
        2 => with_rule::<2>(case, effort),
        _ => with_rule::<3>(case, effort),
    }
    .context(case.name)
}

fn with_rule<const D: usize>(case: &Case, effort: Effort) -> Result<Row> {
    let rubber = Viscoelastic { young: 1.0e9, poisson: 0.4, dissipation: 0.0 };
    let soft = Soft::viscoelastic(rubber, Outside::HardSphere);
    match case.contact {
        Contact::Hard { restitution, .. } => run::<D>(case, HardSphere { restitution }, effort),
        Contact::Viscoelastic { star: true, .. } => run::<D>(case, soft, effort),
        Contact::Viscoelastic { star: false, .. } => run::<D>(case, Central(soft), effort),
    }
}

fn run<const D: usize>(case: &Case, rule: impl Rule<f64>, effort: Effort) -> Result<Row> {
    let mut storage = Storage::<f64, D>::new(case.count);
    let bytes_per_grain = bytes(&mut storage) as f64 / case.count as f64;
    let setup = World::setup(&mut storage).periodic([[0.0, case.edge()]; D]).rule(rule);
    let mut world = setup.grains(lattice::grains::<D>(case))?.start()?;
    collide(&mut world, effort.equilibration)?;
    let (from, begin) = (world.now(), clock::user_seconds());
    let events = timed(&mut world, effort.collisions)?;
    let seconds = clock::user_seconds() - begin;
    Ok(Row {
        case: case.name,
        n: case.count,
        collisions_per_s: events as f64 / seconds,
        bytes_per_grain,
        events,
        seconds,
        simulated: world.now().since(from),
    })
}

/// Steps until so many collisions have happened; returns how many have.
fn collide<const D: usize, R: Rule<f64>>(
    world: &mut World<'_, f64, D, R>,
    collisions: u64,
) -> Result<u64> {
    let before = world.counters().collisions;
    while world.counters().collisions - before < collisions {
        world.step()?.context("no grain will ever meet another")?;
    }
    Ok(world.counters().collisions - before)
}

/// The same under a name of its own, by which a profiler finds what is timed.
#[inline(never)]
fn timed<const D: usize, R: Rule<f64>>(
    world: &mut World<'_, f64, D, R>,
    collisions: u64,
) -> Result<u64> {
    collide(world, collisions)
}

/// All that a world of this storage borrows.
fn bytes<const D: usize>(storage: &mut Storage<f64, D>) -> usize {
    let room = storage.lend();
    size_of_val(room.bodies)
        + size_of_val(room.slots)
        + size_of_val(room.tree)
        + size_of_val(room.links)
        + size_of_val(room.heads)
}
