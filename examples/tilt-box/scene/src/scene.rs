//! What is in the box? Disks that gravity rolls about; reads nothing, builds a world.
//!
//! The box is a tray of 26 cm by 13 with disks of 2 to 3 cm; a display of 128 × 64 pixels shows 2 mm by each. In a box as
//! small as the display itself everything would happen in a third of the time, as (length/g)^½ does: it would look frantic,
//! and cost three times as much.
//!
//! # Units
//! Millimetre, millisecond, and the mass of a disk of 10 mm radius. Numbers near one suit `f32`.

use carom::law::{HardSphere, IntegratedMode};
use carom::{Error, Grain, World};

/// The number of the simulation. In `f32` the box has the same bits on every processor, with a floating-point unit or without.
pub type Number = f32;
/// The rule of the collisions.
pub type Rule = IntegratedMode<HardSphere<Number>>;
/// The world of the box, in memory that lives for `'m`.
pub type Disks<'m> = World<'m, Number, 2, Rule>;
/// Memory for so many disks and the four walls of the box. All its bits are zero: a `static` of it takes no flash.
pub type Memory<const N: usize> = carom::Memory<Number, 2, N, 4>;

/// More disks have no sites.
pub const MOST: usize = COLUMNS * ROWS;
const COLUMNS: usize = 8;
const ROWS: usize = 3;
/// The distance of two sites, in mm.
const SPACING: Number = 32.0;
/// Width and height of the box, in mm.
pub const SIDES: [Number; 2] = [256.0, 128.0];
/// Of the speed at which two disks meet, so much is left when they part.
pub const RESTITUTION: Number = 0.8;
/// How long a slow contact lasts, in ms: an eighth of (R/g)^½ for the smallest disk, twice as long as carom would choose.
/// Disks at rest overlap by less than 1 % of their radius for each that lies on them, which no pixel shows.
pub const CONTACT_TIME: Number = 4.0;
/// Steps in such a contact: as few as carom takes.
pub const STEPS: u32 = 8;
/// The acceleration that an accelerometer calls 1 g, in mm/ms².
pub const G: Number = 9.806_65e-3;

/// The disk with this number, at its site of a lattice. Radii are 10, 12 and 14 mm: equal ones would lie in a crystal.
#[must_use]
pub fn disk(number: usize) -> Grain<Number, 2> {
    const RADII: [Number; 3] = [10.0, 12.0, 14.0];
    let radius = RADII.get(number % RADII.len()).copied().unwrap_or(12.0);
    let site = |k: usize| SPACING * (k as Number + 0.5);
    Grain::with_mass(radius, radius * radius / 100.0)
        .at([site(number % COLUMNS), SPACING + site(number / COLUMNS)])
}

/// The disks, let go: as many as the memory holds.
///
/// Not inlined: the stack that building needs is free again before the first frame.
///
/// # Errors
/// None unless the constants above contradict each other.
#[inline(never)]
pub fn disks<const N: usize>(memory: &mut Memory<N>) -> Result<Disks<'_>, Error> {
    const { assert!(N <= MOST, "the box has no sites for so many disks") };
    let [width, height] = SIDES;
    World::builder(memory)
        .hard_walls([[0.0, width], [0.0, height]], RESTITUTION)
        .gravity([0.0, -G])
        .contact_time(CONTACT_TIME)
        .steps_per_contact(STEPS)
        .rule(IntegratedMode(HardSphere { restitution: RESTITUTION }))
        .grains((0..N).map(disk))?
        .start()
}
