//! What does the rough tilt box do on a board, and what does it take? Reads a scripted accelerometer and a chip's counter; shows an LED matrix, writes a line for each number.

use carom::{Error, World};
use carom_scenes::Number;
use carom_scenes::rough::{self, RoughBox32};
use carom_scenes::scene::Rough16;
use carom_scenes::tilt::{self, Board, READINGS, accelerometer};

use crate::turned::{free, line, shared};

/// Readings between two pictures.
const READINGS_A_PICTURE: u32 = 8;

/// Runs the rough tilt box twice: as fast as its events come, and in frames of 25 ms.
///
/// # Errors
/// Any error of the engine.
pub fn run<S: Number>(board: &mut impl Board) -> Result<(), Error> {
    line(board, b"memory", size_of::<RoughBox32<S>>() as u64);
    line(board, b"world", size_of::<World<'_, S, 2, Rough16<S>>>() as u64);
    let mut memory = rough::memory::<S>();
    let mut world = rough::rough_box(&mut memory)?;
    free(&mut world, (READINGS, accelerometer), board)?;
    line(board, b"free.steps", world.statistics().steps);
    framed::<S>(board)
}

/// In frames.
#[inline(never)]
fn framed<S: Number>(board: &mut impl Board) -> Result<(), Error> {
    let mut memory = rough::memory::<S>();
    let mut world = rough::rough_box(&mut memory)?;
    shared(&mut world, (READINGS, accelerometer), board, |reading, world, board| {
        if reading % READINGS_A_PICTURE == 0 {
            tilt::show(world, board);
        }
    })
}
