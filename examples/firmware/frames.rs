//! What do the longest step and the longest frame take, by scene and number of grains? Reads a chip, writes a line for each.

use carom::law::Rule;
use carom::law::embedded::read::Table;
use carom::{Error, Memory, World};
use carom_scenes::heap::heap;
use carom_scenes::largest::{Shared, largest, shared};
use carom_scenes::tilt::{self, Board, READINGS, tilt_box_begun};
use carom_scenes::{Number, measure};
use semihosting::println;

/// Both scenes with 8, 16 and 32 grains (of 32 beads the image `measure` tells), but not more than these: a line `scene N step turn frame mean shared late` of
/// instructions. The last two: the longest frame where physics has this share of each, and in how many it went slower.
pub fn all<S: Number>(
    [heaps, boxes]: [usize; 2],
    table: &'static Table<S::Stored>,
    share: u64,
    board: &mut impl Board,
) {
    println!("share {share}");
    heaped::<S, 8>(heaps, share, board);
    heaped::<S, 16>(heaps, share, board);
    heaped::<S, 32>(heaps, share, board);
    tilted::<S, 8>(boxes, table, share, board);
    tilted::<S, 16>(boxes, table, share, board);
}

/// Disks that heap up, in the default mode.
#[inline(never)]
fn heaped<S: Number, const N: usize>(most: usize, share: u64, board: &mut impl Board) {
    if N > most {
        return;
    }
    let mut memory = Memory::<S, 2, N, 4>::default();
    let free = heap(&mut memory, N as u32).and_then(|world| longest(world, board));
    let held = heap(&mut memory, N as u32).and_then(|mut world| shared(&mut world, share, board));
    show(("heap", N), free, held);
}

/// Glass beads, in the papers' mode.
#[inline(never)]
fn tilted<S: Number, const N: usize>(
    most: usize,
    table: &'static Table<S::Stored>,
    share: u64,
    board: &mut impl Board,
) {
    if N > most {
        return;
    }
    let mut memory = Memory::<S, 2, N, 4, 0, 96>::default();
    let begun = (N as u32, S::one());
    let free = tilt_box_begun(&mut memory, table, begun).and_then(|world| longest(world, board));
    let held = tilt_box_begun(&mut memory, table, begun)
        .and_then(|mut world| shared(&mut world, share, board));
    show(("beads", N), free, held);
}

/// The longest step, change of gravity and frame of the script, and the mean frame.
fn longest<S: Number, R: Rule<S>>(
    mut world: World<'_, S, 2, R>,
    board: &mut impl Board,
) -> Result<[u64; 4], Error> {
    let most = largest(&mut world, 0..READINGS, tilt::accelerometer, board)?;
    Ok([most.step, most.turn, most.frame, most.all / u64::from(READINGS)])
}

fn show(
    (scene, grains): (&str, usize),
    longest: Result<[u64; 4], Error>,
    shared: Result<Shared, Error>,
) {
    match longest.and_then(|longest| Ok((longest, shared?))) {
        Ok(([step, turn, frame, mean], Shared { frame: most, late })) => {
            println!("{scene} {grains} {step} {turn} {frame} {mean} {most} {late}");
        }
        Err(error) => println!("{scene} {grains} {}", error.brief().as_str()),
    }
}

/// The gas of 32 spheres in boxes of 16 and 24 mm, and 32 beads without weight: a line `gas which instructions-a-collision`.
pub fn gases<S: Number>(table: &'static Table<S::Stored>, board: &mut impl Board) {
    for (which, side) in [("16", 16), ("24", 24)] {
        show_gas(which, measure::gas::<S>(side, board));
    }
    show_gas("beads", measure::weightless::<S>(table, board));
}

fn show_gas(which: &str, cost: Result<measure::Cost, Error>) {
    match cost {
        Ok(cost) => println!("gas {which} {}", cost.instructions / cost.collisions),
        Err(error) => println!("gas {which} {}", error.brief().as_str()),
    }
}
