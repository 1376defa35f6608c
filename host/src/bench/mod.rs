//! How fast is the engine? Reads a case; runs it on one core, returns collisions per second and bytes per grain.
//!
//! A gas starts on a lattice, is equilibrated for eight collisions a grain, and is then timed for a
//! fixed number of collisions, so that two builds do the same work. What counts is user CPU time;
//! crossings into another cell and ends of contacts are work, but no collisions.

mod case;
mod start;

pub use case::{ALL, Case, Contact, named};

use crate::machine::borrowed;
use anyhow::{Context, Result, bail};
use carom::HeapMemory;
use carom::World;
use carom::law::{Central, HardSphere, Outside, Rule, Soft, Viscoelastic};
use serde::Serialize;
use start::grains;

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
    /// Of all touches of two grains those by which they were clustered.
    pub clustered: f64,
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
/// An error of the engine.
pub fn measure(case: &Case) -> Result<Row> {
    let equilibration = EQUILIBRATION * case.total() as u64;
    measure_with(case, Effort { equilibration, collisions: case.collisions })
}

/// As [`measure`], with another effort.
///
/// # Errors
/// As [`measure`].
pub fn measure_with(case: &Case, effort: Effort) -> Result<Row> {
    match case.dimension {
        1 => hard::<1>(case, effort),
        2 => hard::<2>(case, effort),
        _ => match case.contact {
            Contact::Hard { .. } => hard::<3>(case, effort),
            Contact::Viscoelastic { star, .. } => soft(case, star, effort),
        },
    }
    .context(case.name)
}

fn hard<const D: usize>(case: &Case, effort: Effort) -> Result<Row> {
    let Contact::Hard { restitution, .. } = case.contact else {
        bail!("soft grains are timed in three dimensions only");
    };
    run::<D>(case, HardSphere { restitution }, effort)
}

fn soft(case: &Case, star: bool, effort: Effort) -> Result<Row> {
    let rubber = Viscoelastic { young: 1.0e9, poisson: 0.4, dissipation: 0.0 };
    let soft = Soft::viscoelastic(rubber, Outside::HardSphere);
    if star { run::<3>(case, soft, effort) } else { run::<3>(case, Central(soft), effort) }
}

fn run<const D: usize>(case: &Case, rule: impl Rule<f64>, effort: Effort) -> Result<Row> {
    let mut storage = HeapMemory::<f64, D>::with_capacity(case.total());
    let bytes_per_grain = borrowed(&mut storage) as f64 / case.total() as f64;
    let builder = World::builder(&mut storage).periodic([[0.0, case.edge()]; D]).rule(rule);
    let mut world = builder.grains(grains::<D>(case))?.start()?;
    collide(&mut world, effort.equilibration)?;
    let (from, begin, before) = (world.now(), user_seconds(), *world.statistics());
    let events = timed(&mut world, effort.collisions)?;
    let seconds = user_seconds() - begin;
    let joins = world.statistics().joins - before.joins;
    Ok(Row {
        case: case.name,
        n: case.total(),
        collisions_per_s: events as f64 / seconds,
        bytes_per_grain,
        clustered: joins as f64 / (events + joins).max(1) as f64,
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
    let before = world.statistics().collisions;
    while world.statistics().collisions - before < collisions {
        world.step()?.context("no grain will ever collide")?;
    }
    Ok(world.statistics().collisions - before)
}

/// The same under a name of its own, by which a profiler finds what is timed.
#[inline(never)]
fn timed<const D: usize, R: Rule<f64>>(
    world: &mut World<'_, f64, D, R>,
    collisions: u64,
) -> Result<u64> {
    collide(world, collisions)
}

/// User CPU time of this process (s): what others do on the machine is left out as far as it can be.
#[cfg(unix)]
fn user_seconds() -> f64 {
    use nix::sys::resource::{UsageWho, getrusage};
    use nix::sys::time::TimeValLike;
    getrusage(UsageWho::RUSAGE_SELF)
        .map_or(0.0, |usage| usage.user_time().num_microseconds() as f64 * 1e-6)
}

/// Seconds since the first call, where there is no CPU time to be had.
#[cfg(not(unix))]
fn user_seconds() -> f64 {
    use std::sync::OnceLock;
    use std::time::Instant;
    static START: OnceLock<Instant> = OnceLock::new();
    START.get_or_init(Instant::now).elapsed().as_secs_f64()
}
