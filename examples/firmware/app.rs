//! What does the firmware of every family do? The tilt box and its measurements; reads a chip, writes text.

use carom::law::tables::{Embedded, Table};
use carom::number::I32F32;
use carom::{Fault, Memory, World};
use carom_scenes::Number;
use carom_scenes::measure::{self, Cost};
use carom_scenes::scene::Rubber;
use carom_scenes::tilt::{self, Board, GRAINS, READINGS};
use semihosting::println;

use crate::stack::Painted;

/// Plays the tilt box and shows the digest of its last state.
///
/// # Errors
/// Any fault of the engine.
pub fn tilt_box<S: Number>(
    table: &'static Table<S::Stored>,
    board: &mut impl Board,
) -> Result<(), Fault> {
    let mut memory = Memory::<S, 2, GRAINS>::new();
    let mut world = tilt::tilt_box(&mut memory, table)?;
    tilt::play(&mut world, board)?;
    board.write(&tilt::hexadecimal(world.digest()));
    board.write(b"\n");
    Ok(())
}

/// The steps of the force-based run in a millisecond.
const STEPS: u32 = 100;
/// How many readings of the accelerometer it runs for.
const STEPPED: u32 = 4;

/// Measures everything, one line for each number.
pub fn measure_all(paint: usize, board: &mut impl Board) {
    measure::<f32>("f32 standard", f32::viscoelastic(), paint, board);
    measure::<f32>("f32 compact", f32::compact(), paint, board);
    measure::<I32F32>("I32F32 standard", I32F32::viscoelastic(), paint, board);
    measure::<I32F32>("I32F32 compact", I32F32::compact(), paint, board);
    let md = measure::stepped::<f32>(STEPS, STEPPED, board);
    println!("f32 md instructions {}", md * u64::from(READINGS / STEPPED));
}

/// Measures the tilt box with one table in one number type.
fn measure<S: Number>(
    name: &str,
    table: &'static Table<S::Stored>,
    paint: usize,
    board: &mut impl Board,
) {
    let mut memory = Memory::<S, 2, GRAINS>::new();
    println!("{name} memory {}", size_of_val(&memory));
    println!("{name} world {}", size_of::<World<'_, S, 2, Rubber<S>>>());
    let painted = Painted::new(paint);
    let run = measure::event_driven::<S>(&mut memory, table, READINGS, board);
    match painted.used() {
        Some(bytes) => println!("{name} stack {bytes}"),
        None => println!("{name} stack more than {paint}"),
    }
    match run {
        Ok(Cost { instructions, collisions, digest }) => {
            println!("{name} collisions {collisions}");
            println!("{name} instructions {instructions}");
            println!("{name} digest {digest:016x}");
        }
        Err(fault) => println!("{name} fault {fault}"),
    }
    println!("{name} lookup {}", measure::lookup::<S>(table, board));
}
