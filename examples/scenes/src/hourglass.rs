//! What is in an hourglass? Hard disks in a glass of segments, in the default mode; reads nothing, builds a world.

use carom::law::{HardSphere, IntegratedMode, Rule};
use carom::particle::Index;
use carom::space::{Facet, Surface, chain, polygon};
use carom::world::WithObstacles;
use carom::{Error, Grain, Memory, Scalar, Storage, World};

use crate::heap::STEPS;
use crate::scene::{AnyWorld, GRAVITY, Number, grain, n, v};
use crate::tilt::{self, Board};

/// The glass: 18 mm wide, 48 mm high, with an opening of 4 mm in the middle.
fn glass<S: Scalar>(wall: Surface<S>) -> [Facet<S, 2>; 10] {
    let corners = [
        [-9.0, -24.0],
        [9.0, -24.0],
        [9.0, -10.0],
        [2.0, 0.0],
        [9.0, 10.0],
        [9.0, 24.0],
        [-9.0, 24.0],
        [-9.0, 10.0],
        [-2.0, 0.0],
        [-9.0, -10.0],
    ];
    polygon(corners.map(v), wall)
}

/// Memory for sixteen disks in the glass, and for a roof in it.
pub type Hourglass16<S> = WithObstacles<Memory<S, 2, 16>, [Facet<S, 2>; 12], [Index; 144]>;

/// That memory: no disks yet, but the glass, and below its opening a roof, an open chain, which disks touch from above
/// and, when the glass is turned over, from below.
#[must_use]
pub fn roofed<S: Scalar>() -> Hourglass16<S> {
    let wall = Surface::Hard(n(0.5));
    let roof = [[-2.5, -8.0], [0.0, -6.5], [2.5, -8.0]].map(v);
    let mut facets = [Facet::VACANT; 12];
    let both = glass(wall).into_iter().chain(chain(&roof, wall));
    facets.iter_mut().zip(both).for_each(|(place, facet)| *place = facet);
    WithObstacles::new(Memory::new(), facets, [Index::default(); 144])
}

/// Sixteen disks of 0.5 to 0.8 mm above the opening.
///
/// # Errors
/// None unless the memory is too small.
pub fn hourglass16<'m, S: Number>(
    memory: &'m mut impl Storage<S, 2>,
    rule: &'m dyn Rule<S>,
) -> Result<AnyWorld<'m, S, 2>, Error> {
    World::builder(memory).gravity(v([0.0, -GRAVITY])).rule(rule).grains((0..16).map(sand))?.start()
}

/// One of the sixteen.
fn sand<S: Scalar>(k: u32) -> Grain<S, 2> {
    let (column, row, odd) = (f64::from(k % 4), f64::from(k / 4), f64::from(k * 7 % 16));
    grain(0.5 + 0.02 * odd, [2.0 * column - 3.0, 2.0 * row + 11.0], [0.02 * (odd - 7.5), 0.0])
}

/// Disks in the hourglass that a microcontroller has.
pub const GRAINS: usize = 64;
/// Their radius, 2 mm: the glass is 40 mm wide and 104 mm high.
pub const RADIUS: f64 = 2.0;
/// ε of disks and glass. With less more of them are in contacts that are integrated, and it takes longer.
pub const RESTITUTION: f64 = 0.8;
/// How long a slow contact lasts, in milliseconds: a fourteenth of (R/g)^½. With longer ones the heap, eight layers deep,
/// is pressed so far that its contacts are stiffer again.
pub const CONTACT_TIME: f64 = 1.0;
/// How long the script goes on: so many readings, 8 seconds.
pub const READINGS: u32 = 320;
/// The lamps of its matrix, as wide as a disk: columns and rows.
const LAMPS: [usize; 2] = [10, 26];

/// Memory for these disks and the glass, an eighth of a kilobyte of it for finding its sides.
pub type Hourglass64<S> = WithObstacles<Memory<S, 2, GRAINS, 0>, [Facet<S, 2>; 10], [Index; 64]>;

/// That memory: no disks yet, but the glass.
#[inline(never)]
#[must_use]
pub fn memory<S: Scalar>() -> Hourglass64<S> {
    let glass = [
        [-10.0, -26.0],
        [10.0, -26.0],
        [10.0, -7.0],
        [4.0, 0.0],
        [10.0, 7.0],
        [10.0, 26.0],
        [-10.0, 26.0],
        [-10.0, 7.0],
        [-4.0, 0.0],
        [-10.0, -7.0],
    ];
    let corners = glass.map(|corner| v(corner.map(|radii| RADIUS * radii)));
    let wall = Surface::Hard(n(RESTITUTION));
    WithObstacles::new(Memory::new(), polygon(corners, wall), [Index::default(); 64])
}

/// All disks above the opening.
///
/// Not inlined: the stack that building needs is free again before the first event.
///
/// # Errors
/// None unless the memory is too small.
#[inline(never)]
pub fn hourglass<S: Number>(
    memory: &mut impl Storage<S, 2>,
) -> Result<World<'_, S, 2, IntegratedMode<HardSphere<S>>>, Error> {
    let site = |k: u32| {
        let [column, row] = [k % 8, k / 8].map(f64::from);
        let odd = f64::from(k * 7 % 16) - 7.5;
        let at = [2.2 * column - 7.7, 2.2 * row + 8.5].map(|radii| RADIUS * radii);
        grain(RADIUS, at, [0.002 * odd, 0.0])
    };
    World::builder(memory)
        .gravity(accelerometer(0))
        .contact_time(n(CONTACT_TIME))
        .steps_per_contact(STEPS)
        .rule(IntegratedMode(HardSphere { restitution: n(RESTITUTION) }))
        .grains((0..GRAINS as u32).map(site))?
        .start()
}

/// The accelerometer's readings: the hourglass stands for 3.8 s, is turned over within 0.4 s, and stands again.
#[must_use]
pub fn accelerometer<S: Scalar>(reading: u32) -> [S; 2] {
    tilt::turned(reading.clamp(152, 168) - 152)
}

/// How many disks are above the opening.
#[must_use]
pub fn above<S: Scalar, R: Rule<S>>(world: &World<'_, S, 2, R>) -> u32 {
    let is_above = |k: &usize| world.grain(*k).is_some_and(|disk| disk.position.y > S::zero());
    (0..GRAINS).filter(is_above).count() as u32
}

/// The LED matrix: a lamp is lit where a disk's centre is, brighter where there are two.
pub fn show<S: Scalar, R: Rule<S>>(world: &World<'_, S, 2, R>, board: &mut impl Board) {
    let [columns, rows] = LAMPS;
    let mut lamps = [[b'.'; LAMPS[0]]; LAMPS[1]];
    for disk in (0..GRAINS).filter_map(|k| world.grain(k)) {
        let at = |x: S, lamps: usize| {
            let from_the_side = x / n(2.0 * RADIUS) + n(0.5 * lamps as f64);
            (from_the_side.to_count() as usize).min(lamps - 1)
        };
        let lamp = lamps.get_mut(rows - 1 - at(disk.position.y, rows));
        if let Some(lamp) = lamp.and_then(|row| row.get_mut(at(disk.position.x, columns))) {
            *lamp = if *lamp == b'.' { b'o' } else { b'O' };
        }
    }
    for row in &lamps {
        board.write(row);
        board.write(b"\n");
    }
    board.write(b"\n");
}
