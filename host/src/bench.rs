//! How fast is the engine? Reads a case; runs it on one core, returns collisions per second and bytes per grain.
//!
//! A gas starts on a lattice, is equilibrated for eight collisions a grain, and is then timed for a
//! fixed number of collisions, so that two builds do the same work. What counts is user CPU time;
//! crossings into another cell and ends of contacts are work, but no collisions.

use anyhow::{Context, Result};
use carom::HeapMemory;
use carom::law::{Central, HardSphere, Outside, Rule, Soft, Viscoelastic};
use carom::{Grain, Storage, World};
use rand::{RngExt, SeedableRng};
use rand_distr::{Distribution, Normal};
use rand_pcg::Pcg64;
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
    let mut storage = HeapMemory::<f64, D>::with_capacity(case.count);
    let bytes_per_grain = bytes(&mut storage) as f64 / case.count as f64;
    let builder = World::builder(&mut storage).periodic([[0.0, case.edge()]; D]).rule(rule);
    let mut world = builder.grains(grains::<D>(case))?.start()?;
    collide(&mut world, effort.equilibration)?;
    let (from, begin, before) = (world.now(), user_seconds(), *world.statistics());
    let events = timed(&mut world, effort.collisions)?;
    let seconds = user_seconds() - begin;
    let joins = world.statistics().joins - before.joins;
    Ok(Row {
        case: case.name,
        n: case.count,
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

/// All that a world of this storage borrows.
fn bytes<const D: usize>(storage: &mut HeapMemory<f64, D>) -> usize {
    let buffers = storage.buffers();
    size_of_val(buffers.bodies)
        + size_of_val(buffers.events)
        + size_of_val(buffers.tree)
        + size_of_val(buffers.links)
        + size_of_val(buffers.heads)
        + size_of_val(buffers.accelerations)
        + size_of_val(buffers.calendar)
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

/// What happens when two grains of a case touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Contact {
    /// Hard spheres of diameter 1, mass 1 and k T = 1 at this number density, with this ε.
    Hard {
        /// Grains per unit of volume, area or length.
        density: f64,
        /// ε.
        restitution: f64,
    },
    /// MP13's elastic viscoelastic grains (Y = 1 GPa, ν = 0.4, R = 0.1 m, ρ = 1140 kg/m³, thermal
    /// speed 2 m/s, Sec. VI B 6) at this packing fraction.
    Viscoelastic {
        /// Fraction of the box that the grains fill.
        packing: f64,
        /// With the matrix of restitution (eMD*), or as hard spheres with the law's ε(v) (eMD).
        star: bool,
    },
}

/// One gas in a periodic box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Case {
    /// As the command line and the JSON call it.
    pub name: &'static str,
    /// 1, 2 or 3.
    pub dimension: usize,
    /// How many grains.
    pub count: usize,
    /// What they do.
    pub contact: Contact,
    /// How many collisions are timed.
    pub collisions: u64,
    /// What others reach on a quiet core of this kind (collisions/s), and who.
    pub others: &'static [(&'static str, f64)],
}

/// Number density of the hard-sphere cases: packing fraction 0.2618 in three dimensions, 0.3927 in two.
const DENSITY: f64 = 0.5;
/// Packing fraction 0.01 as a number density.
const DILUTE: f64 = 0.01 * 6.0 / std::f64::consts::PI;

const C_CODE: &str = "C code (arXiv:2201.01100)";
const DYNAMO: &str = "DynamO";

const fn hard(
    name: &'static str,
    dimension: usize,
    count: usize,
    collisions: u64,
    others: &'static [(&'static str, f64)],
) -> Case {
    let contact = Contact::Hard { density: DENSITY, restitution: 1.0 };
    Case { name, dimension, count, contact, collisions, others }
}

const fn soft(name: &'static str, packing: f64, star: bool) -> Case {
    let contact = Contact::Viscoelastic { packing, star };
    Case { name, dimension: 3, count: 10_000, contact, collisions: 100_000, others: &[] }
}

/// All cases, in the order in which they run.
pub const ALL: [Case; 13] = [
    hard("hs3d-1372", 3, 1_372, 1_000_000, &[(C_CODE, 589e3), (DYNAMO, 140e3)]),
    hard("hs3d-13500", 3, 13_500, 1_000_000, &[(C_CODE, 516e3), (DYNAMO, 119e3)]),
    hard("hs3d-108000", 3, 108_000, 1_000_000, &[(C_CODE, 313e3), (DYNAMO, 70e3)]),
    hard("hs3d-1000000", 3, 1_000_000, 2_000_000, &[]),
    Case {
        contact: Contact::Hard { density: DILUTE, restitution: 1.0 },
        ..hard("hs3d-dilute", 3, 13_500, 500_000, &[(C_CODE, 206e3)])
    },
    Case {
        contact: Contact::Hard { density: DENSITY, restitution: 0.9 },
        ..hard("ihs3d-13500", 3, 13_500, 500_000, &[])
    },
    hard("hd2d-1024", 2, 1_024, 1_000_000, &[(DYNAMO, 201e3)]),
    hard("rod1d-1000", 1, 1_000, 1_000_000, &[(DYNAMO, 361e3)]),
    hard("small-32", 3, 32, 1_000_000, &[(DYNAMO, 181e3)]),
    soft("emdstar-10000-0.001", 0.001, true),
    soft("emdstar-10000-0.01", 0.01, true),
    soft("emd-10000-0.001", 0.001, false),
    soft("emd-10000-0.01", 0.01, false),
];

/// The case of this name, or all whose names continue it after a dash.
pub fn named(name: &str) -> Vec<Case> {
    let exact: Vec<Case> = ALL.into_iter().filter(|case| case.name == name).collect();
    if !exact.is_empty() {
        return exact;
    }
    let begins = |case: &Case| case.name.strip_prefix(name).is_some_and(|r| r.starts_with('-'));
    ALL.into_iter().filter(begins).collect()
}

impl Case {
    /// The radius of a grain.
    pub const fn radius(&self) -> f64 {
        match self.contact {
            Contact::Hard { .. } => 0.5,
            Contact::Viscoelastic { .. } => 0.1,
        }
    }

    /// The mass of a grain.
    pub fn mass(&self) -> f64 {
        match self.contact {
            Contact::Hard { .. } => 1.0,
            Contact::Viscoelastic { .. } => 1140.0 * sphere(0.1),
        }
    }

    /// The standard deviation of a component of the velocity.
    pub fn speed(&self) -> f64 {
        match self.contact {
            Contact::Hard { .. } => 1.0,
            Contact::Viscoelastic { .. } => 2f64.sqrt(),
        }
    }

    /// The edge of the box.
    pub fn edge(&self) -> f64 {
        let density = match self.contact {
            Contact::Hard { density, .. } => density,
            Contact::Viscoelastic { packing, .. } => packing / sphere(0.1),
        };
        (self.count as f64 / density).powf(1.0 / self.dimension as f64)
    }
}

fn sphere(radius: f64) -> f64 {
    4.0 / 3.0 * std::f64::consts::PI * radius.powi(3)
}

/// Sites of one cubic unit cell: one in one dimension, two of a centred square, four of a face-centred cube.
const BASIS: [&[[f64; 3]]; 3] = [
    &[[0.0, 0.0, 0.0]],
    &[[0.0, 0.0, 0.0], [0.5, 0.5, 0.0]],
    &[[0.0, 0.0, 0.0], [0.5, 0.5, 0.0], [0.5, 0.0, 0.5], [0.0, 0.5, 0.5]],
];

/// The grains of a case: on sites drawn at random from the smallest lattice that has enough, numbered
/// along it, with normal velocities and no total momentum. The same ones every time.
fn grains<const D: usize>(case: &Case) -> Vec<Grain<f64, D>> {
    let mut rng = Pcg64::seed_from_u64(case.count as u64);
    let mut sites = sites::<D>(case.count, case.edge());
    while sites.len() > case.count {
        sites.remove(rng.random_range(0..sites.len()));
    }
    let normal = Normal::new(0.0, case.speed()).unwrap_or_else(|_| unreachable!("speed() > 0"));
    let mut velocities: Vec<[f64; D]> =
        sites.iter().map(|_| std::array::from_fn(|_| normal.sample(&mut rng))).collect();
    for axis in 0..D {
        let mean = velocities.iter().map(|v| v[axis]).sum::<f64>() / case.count as f64;
        velocities.iter_mut().for_each(|v| v[axis] -= mean);
    }
    let grain = Grain::with_mass(case.radius(), case.mass());
    sites.into_iter().zip(velocities).map(|(at, v)| grain.at(at).moving(v)).collect()
}

fn sites<const D: usize>(count: usize, edge: f64) -> Vec<[f64; D]> {
    let basis = BASIS[D - 1];
    let side = (1..).find(|side: &usize| basis.len() * side.pow(D as u32) >= count).unwrap_or(1);
    let cell = edge / side as f64;
    (0..side.pow(D as u32))
        .flat_map(|number| {
            let corner: [f64; D] =
                std::array::from_fn(|axis| ((number / side.pow(axis as u32)) % side) as f64);
            let site = move |point: &[f64; 3]| {
                std::array::from_fn(|axis| cell * (corner[axis] + point[axis]))
            };
            basis.iter().map(site)
        })
        .collect()
}
