//! What does the hourglass do on a board, and what does it take? Reads a scripted accelerometer and a chip's counter; shows an LED matrix, writes a line for each number.

use carom::law::{HardSphere, IntegratedMode};
use carom::{Error, World};
use carom_scenes::Number;
use carom_scenes::hourglass::{self, Hourglass64, READINGS, above, accelerometer};
use carom_scenes::tilt::Board;

use crate::turned::{free, line, shared};

/// Readings between two pictures: one a second.
const READINGS_A_PICTURE: u32 = 40;

/// Runs the hourglass twice: as fast as its events come, and in frames of 25 ms.
///
/// # Errors
/// Any error of the engine.
pub fn run<S: Number>(board: &mut impl Board) -> Result<(), Error> {
    line(board, b"memory", size_of::<Hourglass64<S>>() as u64);
    line(board, b"world", size_of::<World<'_, S, 2, IntegratedMode<HardSphere<S>>>>() as u64);
    let mut memory = hourglass::memory::<S>();
    let mut world = hourglass::hourglass(&mut memory)?;
    free(&mut world, (READINGS, accelerometer), board)?;
    line(board, b"free.above", above(&world).into());
    framed::<S>(board)
}

/// In frames: how many of them the sand takes to run down, and where it is at last.
#[inline(never)]
fn framed<S: Number>(board: &mut impl Board) -> Result<(), Error> {
    let mut memory = hourglass::memory::<S>();
    let mut world = hourglass::hourglass(&mut memory)?;
    let mut down = 0;
    shared(&mut world, (READINGS, accelerometer), board, |reading, world, board| {
        if down == 0 && above(world) == 0 {
            down = u64::from(reading) + 1;
        }
        if reading % READINGS_A_PICTURE == 0 {
            hourglass::show(world, board);
        }
    })?;
    line(board, b"shared.down", down);
    line(board, b"shared.above", above(&world).into());
    Ok(())
}
