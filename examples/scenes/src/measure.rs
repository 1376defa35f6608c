//! How many instructions does the tilt box take? Reads a board's instruction counter; writes what each method took.

use carom::law::Rule;
use carom::law::embedded::read::{Groups, Table};
use carom::{Error, Grain, Scalar, Storage, World};

use crate::scene::{Number, elastic, gas32, n};
use crate::tilt::{self, BETWEEN_READINGS, Board, GRAINS, READINGS, tilt_box, tilt_box_begun};
use crate::time_stepped::TimeStepped;

/// What a run took.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cost {
    /// Instructions.
    pub instructions: u64,
    /// Collisions of grains with grains and with walls.
    pub collisions: u64,
    /// Contacts outside the table's domain.
    pub outside: u64,
    /// The digest of the last state; 0 where there is none.
    pub digest: u64,
}

/// How many times as fast the grains begin in each of the measured runs. A few hundred collisions of one trajectory
/// say by 5 % more or less what a collision takes; four trajectories say it by 1 %.
const BEGUN: [f64; 4] = [1.0, 1.01, 1.02, 1.04];

/// The tilt box event by event, that many readings of the script, without sleep and without pictures: the mean of so
/// many runs (at most four) that begin a little apart. The digest is the first one's.
///
/// # Errors
/// Any error of the engine.
pub fn event_driven<S: Number>(
    memory: &mut impl Storage<S, 2>,
    table: &'static Table<S::Stored>,
    readings: u32,
    runs: usize,
    board: &mut impl Board,
) -> Result<Cost, Error> {
    let mut mean = run(memory, table, readings, 1.0, board)?;
    let mut all = 1;
    for faster in BEGUN.iter().take(runs).skip(1) {
        let cost = run(memory, table, readings, *faster, board)?;
        mean.instructions += cost.instructions;
        mean.collisions += cost.collisions;
        mean.outside += cost.outside;
        all += 1;
    }
    mean.instructions /= all;
    mean.collisions /= all;
    Ok(mean)
}

/// One of these runs. Not inlined: what it needs of the stack is needed once.
#[inline(never)]
fn run<S: Number>(
    memory: &mut impl Storage<S, 2>,
    table: &'static Table<S::Stored>,
    readings: u32,
    faster: f64,
    board: &mut impl Board,
) -> Result<Cost, Error> {
    let mut world = tilt_box_begun(memory, table, (GRAINS as u32, n(faster)))?;
    let start = board.instructions();
    for reading in 0..readings {
        world.set_gravity(tilt::accelerometer(reading))?;
        world.advance_to(tilt::instant(reading + 1))?;
        board.instructions();
    }
    let instructions = board.instructions() - start;
    let statistics = world.statistics();
    let collisions = statistics.collisions + statistics.plane_collisions;
    Ok(Cost { instructions, collisions, outside: statistics.hard_sphere, digest: world.digest() })
}

/// A gas of 32 elastic spheres in a periodic box of so many millimetres, from a lattice: a thousand collisions after
/// the first two hundred.
///
/// # Errors
/// Any error of the engine.
#[inline(never)]
pub fn gas<S: Number>(side: u32, board: &mut impl Board) -> Result<Cost, Error> {
    let mut memory = carom::Memory::<S, 3, 32, 0, 0, 128>::default();
    thousand(&mut gas32(&mut memory, elastic(), side)?, board)
}

/// The beads of the tilt box without weight: a gas in two dimensions and four walls, of which they fill a seventh.
///
/// # Errors
/// Any error of the engine.
#[inline(never)]
pub fn weightless<S: Number>(
    table: &'static Table<S::Stored>,
    board: &mut impl Board,
) -> Result<Cost, Error> {
    let mut memory = tilt::memory::<S>();
    let mut world = tilt_box(&mut memory, table)?;
    world.set_gravity([S::zero(); 2])?;
    thousand(&mut world, board)
}

/// A thousand collisions after the first two hundred.
fn thousand<S: Scalar, const D: usize, R: Rule<S>>(
    world: &mut World<'_, S, D, R>,
    board: &mut impl Board,
) -> Result<Cost, Error> {
    let count = |world: &World<'_, S, D, R>| {
        world.statistics().collisions + world.statistics().plane_collisions
    };
    let mut slice = 0;
    // In slices: the counter is to be asked now and then.
    let mut collide = |world: &mut World<'_, S, D, R>, most, board: &mut dyn FnMut()| {
        while count(world) < most {
            slice += 1;
            world.advance_to(tilt::instant(slice))?;
            board();
        }
        Ok::<(), Error>(())
    };
    collide(world, 200, &mut || ())?;
    let begun = count(world);
    let start = board.instructions();
    collide(world, begun + 1000, &mut || {
        board.instructions();
    })?;
    let instructions = board.instructions() - start;
    let (collisions, outside) = (count(world) - begun, world.statistics().hard_sphere);
    Ok(Cost { instructions, collisions, outside, digest: world.digest() })
}

/// The time steps of MD in a millisecond: 20 to 50 for the contact of two beads. Velocity Verlet then has
/// ε to 2·10⁻⁴, about as the compact table.
const STEPS: u32 = 5000;

/// The instructions of the whole script by time steps, extrapolated from so many of them.
///
/// They begin with the box as the event-driven run has it after so many readings, so that the
/// grains lie as they usually do.
///
/// # Errors
/// Any error of the engine.
#[inline(never)]
pub fn time_stepped<S: Number>(
    table: &'static Table<S::Stored>,
    readings: u32,
    steps: u32,
    board: &mut impl Board,
) -> Result<u64, Error> {
    let mut run = TimeStepped::<S>::new(&after(table, readings, board)?, n(1.0 / f64::from(STEPS)));
    run.tilt(readings);
    let start = board.instructions();
    for _ in 0..steps {
        run.advance();
        board.instructions();
    }
    core::hint::black_box(run.position(0));
    let all = u64::from(STEPS * BETWEEN_READINGS * READINGS);
    Ok((board.instructions() - start) * all / u64::from(steps))
}

/// The grains of the tilt box after so many readings. Not inlined: the world is gone from the stack afterwards.
#[inline(never)]
fn after<S: Number>(
    table: &'static Table<S::Stored>,
    readings: u32,
    board: &mut impl Board,
) -> Result<[Grain<S, 2>; GRAINS], Error> {
    let mut memory = tilt::memory::<S>();
    let mut world = tilt_box(&mut memory, table)?;
    for reading in 0..readings {
        world.set_gravity(tilt::accelerometer(reading))?;
        world.advance_to(tilt::instant(reading + 1))?;
        board.instructions();
    }
    Ok(core::array::from_fn(|k| world.grain(k).unwrap_or_else(|| tilt::site(k as u32))))
}

/// One lookup in a table, the mean over 64 places in its domain.
#[inline(never)]
pub fn lookup<S: Number>(table: &'static Table<S::Stored>, board: &mut impl Board) -> u64 {
    let places: [Groups<S>; 64] = core::array::from_fn(|k| {
        let part = |prime: usize| (k * prime % 64) as f64 / 64.0;
        let (eta, c_dis, sin) = (n(0.1 * part(5)), n(0.9 * part(11)), n::<S>(part(23)));
        Groups { sin, cos: (S::one() - sin * sin).sqrt(), eta, c_dis }
    });
    let start = board.instructions();
    for place in &places {
        core::hint::black_box(table.read(core::hint::black_box(place)));
    }
    (board.instructions() - start) / 64
}
