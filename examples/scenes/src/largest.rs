//! How many instructions do the largest step and the largest frame take? Reads a board's instruction counter; advances a world event by event.

use carom::law::Rule;
use carom::{Error, Scalar, World};

use crate::tilt::{self, Board};

/// The most that anything took, in instructions; less what the counting takes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Largest {
    /// One event of any kind; a step of all clustered grains is one.
    pub step: u64,
    /// One change of gravity.
    pub turn: u64,
    /// One reading and everything until the next, 25 ms later.
    pub frame: u64,
    /// All frames together.
    pub all: u64,
    /// The last frame.
    pub last: u64,
    /// How many events there were.
    pub events: u64,
    /// The reading after which all slept; 0 where they did not.
    pub asleep: u32,
}

/// These readings of an accelerometer, one frame each.
///
/// # Errors
/// Any error of the engine.
#[inline(never)]
pub fn largest<S: Scalar, R: Rule<S>>(
    world: &mut World<'_, S, 2, R>,
    readings: core::ops::Range<u32>,
    accelerometer: fn(u32) -> [S; 2],
    board: &mut impl Board,
) -> Result<Largest, Error> {
    let mut largest = Largest::default();
    for reading in readings {
        let (turn, turned) = counted(board, || world.set_gravity(accelerometer(reading)));
        turned?;
        let rest = frame(world, reading, board, &mut largest)?;
        largest.turn = largest.turn.max(turn);
        largest.last = turn + rest;
        largest.frame = largest.frame.max(largest.last);
        largest.all += largest.last;
        if world.next_event_time().is_none() {
            largest.asleep = reading + 1;
            break;
        }
    }
    Ok(largest)
}

/// Everything up to the next reading, one event at a time; returns what it took.
fn frame<S: Scalar, R: Rule<S>>(
    world: &mut World<'_, S, 2, R>,
    reading: u32,
    board: &mut impl Board,
    largest: &mut Largest,
) -> Result<u64, Error> {
    let end = tilt::instant(reading + 1);
    let mut all = 0;
    loop {
        let (instructions, arrived) = counted(board, || world.advance_with_budget(end, 1));
        all += instructions;
        largest.step = largest.step.max(instructions);
        if arrived? {
            return Ok(all);
        }
        largest.events += 1;
    }
}

/// What something takes. The counter is asked three times, so that its own work is known.
fn counted<T>(board: &mut impl Board, action: impl FnOnce() -> T) -> (u64, T) {
    let before = board.instructions();
    let start = board.instructions();
    let done = action();
    let end = board.instructions();
    ((end - start).saturating_sub(start - before), done)
}

/// What frames take whose physics has a share of time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Shared {
    /// The most that a frame took, in instructions.
    pub frame: u64,
    /// In how many frames the box went slower.
    pub late: u32,
}

/// The script with so many instructions for the physics of a frame: what is under way when they are used up is the most
/// that a frame takes longer.
///
/// # Errors
/// Any error of the engine.
#[inline(never)]
pub fn shared<S: Scalar, R: Rule<S>>(
    world: &mut World<'_, S, 2, R>,
    share: u64,
    board: &mut impl Board,
) -> Result<Shared, Error> {
    let (mut shared, mut done) = (Shared::default(), 0);
    for reading in 0..tilt::READINGS {
        let start = board.instructions();
        let in_time = || board.instructions() - start < share;
        let arrived = tilt::frame(world, [reading, done], tilt::accelerometer, in_time)?;
        done += u32::from(arrived);
        shared.late += u32::from(!arrived);
        shared.frame = shared.frame.max(board.instructions() - start);
    }
    Ok(shared)
}
