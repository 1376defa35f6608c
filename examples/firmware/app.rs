//! What does the firmware of every family do? The tilt box and its measurements; reads a chip, writes text.

use carom::law::embedded::read::Table;
use carom::law::{HardSphere, IntegratedMode, PaperMode};
use carom::{Error, Instant, World};
use carom_scenes::Number;
use carom_scenes::heap::{GRAINS, Heap, heap};
use carom_scenes::largest::{Largest, Shared, largest, shared};
use carom_scenes::measure::{self, Cost};
use carom_scenes::scene::Rubber;
use carom_scenes::tilt::{self, Board, READINGS};
use semihosting::println;

use crate::stack::Painted;

/// Runs the tilt box, so many events a frame at most; shows in how many frames it went slower for that, and the
/// digest of its last state.
///
/// # Errors
/// Any error of the engine.
pub fn tilt_box<S: Number>(
    table: &'static Table<S::Stored>,
    events: u32,
    board: &mut impl Board,
) -> Result<(), Error> {
    let mut memory = tilt::memory::<S>();
    let mut world = tilt::tilt_box(&mut memory, table)?;
    let late = tilt::run_script(&mut world, events, board)?;
    board.write(b"slower in so many frames: ");
    board.write(&tilt::hexadecimal(late.into()));
    board.write(b"\n");
    board.write(&tilt::hexadecimal(world.digest()));
    board.write(b"\n");
    Ok(())
}

/// Steps of the force-based run, and the reading after which it begins.
const STEPS: u32 = 10_000;
const BEGIN: u32 = 8;

/// Measures the tilt box with each of these tables, the mean of so many runs, and by MD, one line for each number.
pub fn measure_all<S: Number>(
    tables: &[(&str, &'static Table<S::Stored>)],
    runs: usize,
    stack: usize,
    (events, share): (u32, u64),
    board: &mut impl Board,
) {
    println!("memory {}", size_of::<tilt::Box32<S>>());
    println!("world {}", size_of::<World<'_, S, 2, PaperMode<Rubber<S>>>>());
    for (name, table) in tables {
        measure::<S>(name, table, runs, stack, board);
        println!("{name}.lookup {}", measure::lookup::<S>(table, board));
        measure_largest::<S>(name, table, board);
        measure_frames::<S>(name, table, (events, share), board);
    }
    match measure::time_stepped::<S>(S::compact(), BEGIN, STEPS, board) {
        Ok(instructions) => println!("md {instructions}"),
        Err(error) => println!("md.error {}", error.brief().as_str()),
    }
}

/// The largest step and the largest frame of the tilt box with one table: another run, event by event.
#[inline(never)]
fn measure_largest<S: Number>(
    name: &str,
    table: &'static Table<S::Stored>,
    board: &mut impl Board,
) {
    let mut memory = tilt::memory::<S>();
    let run = tilt::tilt_box(&mut memory, table)
        .and_then(|mut world| largest(&mut world, 0..READINGS, tilt::accelerometer, board));
    match run {
        Ok(most) => show(name, &most),
        Err(error) => println!("{name}.error {}", error.brief().as_str()),
    }
}

/// The frames of the tilt box when physics has a share of them: of events, as in the image `tilt_box`, and of time.
#[inline(never)]
fn measure_frames<S: Number>(
    name: &str,
    table: &'static Table<S::Stored>,
    (events, share): (u32, u64),
    board: &mut impl Board,
) {
    let mut memory = tilt::memory::<S>();
    let run = tilt::tilt_box(&mut memory, table).and_then(|mut world| {
        let late = tilt::run_script(&mut world, events, &mut Silent)?;
        println!("{name}.events.late {late}");
        println!("{name}.events.digest {:016x}", world.digest());
        Ok(())
    });
    let run = run.and_then(|()| tilt::tilt_box(&mut memory, table));
    match run.and_then(|mut world| shared(&mut world, share, board)) {
        Ok(Shared { frame, late }) => {
            println!("{name}.share {share}");
            println!("{name}.share.frame {frame}");
            println!("{name}.share.late {late}");
        }
        Err(error) => println!("{name}.error {}", error.brief().as_str()),
    }
}

/// A board that shows nothing and has no time to lose.
struct Silent;

impl Board for Silent {
    fn write(&mut self, _: &[u8]) {}
    fn sleep_until(&mut self, _: Instant) {}
    fn instructions(&mut self) -> u64 {
        0
    }
}

/// The box of 16 is held still after the script until all sleep, but not longer than that many readings.
const HELD: u32 = 400;

/// Measures the box of 16 that heaps up in the default mode, one line for each number.
pub fn measure_heap<S: Number>(share: u64, board: &mut impl Board) {
    let mut memory = Heap::<S, GRAINS>::default();
    println!("memory {}", size_of::<Heap<S, GRAINS>>());
    println!("world {}", size_of::<World<'_, S, 2, IntegratedMode<HardSphere<S>>>>());
    let run = heap(&mut memory, GRAINS as u32).and_then(|mut world| {
        let swung = largest(&mut world, 0..READINGS, tilt::accelerometer, board)?;
        show("swung", &swung);
        println!("swung.clustered {}", world.statistics().steps);
        let down = |_| tilt::accelerometer(0);
        show("held", &largest(&mut world, READINGS..READINGS + HELD, down, board)?);
        println!("held.clustered {}", world.statistics().steps);
        println!("digest {:016x}", world.digest());
        Ok(())
    });
    if let Err(error) = run {
        println!("heap.error {}", error.brief().as_str());
    }
    match heap(&mut memory, GRAINS as u32).and_then(|mut world| shared(&mut world, share, board)) {
        Ok(Shared { frame, late }) => {
            println!("share {share}");
            println!("share.frame {frame}");
            println!("share.late {late}");
        }
        Err(error) => println!("heap.error {}", error.brief().as_str()),
    }
}

/// One line for each number.
fn show(name: &str, most: &Largest) {
    println!("{name}.step {}", most.step);
    println!("{name}.turn {}", most.turn);
    println!("{name}.frame {}", most.frame);
    println!("{name}.all {}", most.all);
    println!("{name}.events {}", most.events);
    println!("{name}.last {}", most.last);
    println!("{name}.asleep {}", most.asleep);
}

/// Measures the tilt box with one table.
#[inline(never)]
fn measure<S: Number>(
    name: &str,
    table: &'static Table<S::Stored>,
    runs: usize,
    stack: usize,
    board: &mut impl Board,
) {
    let mut memory = tilt::memory::<S>();
    let painted = Painted::new(stack);
    let run = measure::event_driven::<S>(&mut memory, table, READINGS, runs, board);
    match painted.used() {
        Some(bytes) => println!("{name}.stack {bytes}"),
        None => println!("{name}.stack null"),
    }
    match run {
        Ok(Cost { instructions, collisions, outside, digest }) => {
            println!("{name}.collisions {collisions}");
            println!("{name}.instructions {instructions}");
            println!("{name}.outside {outside}");
            println!("{name}.digest {digest:016x}");
        }
        Err(error) => println!("{name}.error {}", error.brief().as_str()),
    }
}
