//! How many instructions does the tilt box take? Reads a board's counter; writes what each method took.

use carom::law::tables::{Groups, Table};
use carom::{Fault, Lend, Scalar};

use crate::scene::{Number, n};
use crate::stepped::Stepped;
use crate::tilt::{self, BETWEEN_READINGS, Board, tilt_box};

/// What a run took.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cost {
    /// Instructions.
    pub instructions: u64,
    /// Collisions of grains with grains and with walls.
    pub collisions: u64,
    /// The digest of the last state; 0 where there is none.
    pub digest: u64,
}

/// The tilt box event by event, that many readings of the script, without sleep and without pictures.
///
/// # Errors
/// Any fault of the engine.
pub fn event_driven<S: Number>(
    memory: &mut impl Lend<S, 2>,
    table: &'static Table<S::Stored>,
    readings: u32,
    board: &mut impl Board,
) -> Result<Cost, Fault> {
    let mut world = tilt_box(memory, table)?;
    let start = board.instructions();
    for reading in 0..readings {
        world.set_gravity(tilt::accelerometer(reading))?;
        world.advance_to(tilt::instant(reading + 1))?;
        board.instructions();
    }
    let instructions = board.instructions() - start;
    let collisions = world.counters().collisions + world.counters().plane_collisions;
    Ok(Cost { instructions, collisions, digest: world.digest() })
}

/// The same by time steps: that many in each millisecond, for that many readings.
pub fn stepped<S: Scalar>(steps: u32, readings: u32, board: &mut impl Board) -> u64 {
    let mut run = Stepped::<S>::new(n(1.0 / f64::from(steps)));
    let start = board.instructions();
    for reading in 0..readings {
        run.tilt(reading);
        for _ in 0..steps * BETWEEN_READINGS {
            run.advance();
        }
        board.instructions();
    }
    core::hint::black_box(run.position(0));
    board.instructions() - start
}

/// One reading of a table, the mean over 64 places in its domain.
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
