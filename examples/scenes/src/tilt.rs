//! What is in the tilt box? 32 glass beads of different size under a turning gravity; reads a script, writes frames to a board.

use carom::law::embedded::read::Table;
use carom::law::{Outside, PaperMode, Rule, Soft, Viscoelastic};
use carom::{Error, Grain, Instant, Memory, Scalar, Storage, World};

use crate::scene::{GRAVITY, Number, Rubber, n};

/// Young's modulus of glass, 63 GPa, in these units (10.472 kPa: the mass of a bead of 1 mm and 2.5 g/cm³,
/// by mm and ms²).
pub const YOUNG: f64 = 6.016e6;
/// Poisson's ratio of glass.
pub const POISSON: f64 = 0.24;
/// A = 0.1 µs, with which two beads part at 94 % of the 0.1 m/s at which they collided.
pub const DISSIPATION: f64 = 1.0e-4;

/// How many grains.
pub const GRAINS: usize = 32;
/// The side of the box in millimetres.
pub const SIDE: u32 = 24;
/// The side of the LED matrix in lamps.
const LAMPS: usize = 16;
/// How long the script goes on: that many readings of the accelerometer, 1.4 seconds.
pub const READINGS: u32 = 56;
/// Milliseconds between two readings: 40 Hz.
pub const BETWEEN_READINGS: u32 = 25;
/// Readings between two frames of the LED matrix.
const READINGS_A_FRAME: u32 = 4;

/// What the tilt box needs of a microcontroller board.
pub trait Board {
    /// Shows text.
    fn write(&mut self, text: &[u8]);
    /// Sleeps until that instant, in milliseconds after the start; returns at once if that is over.
    fn sleep_until(&mut self, instant: Instant);
    /// How many instructions have been executed since the start. To be asked now and then.
    fn instructions(&mut self) -> u64;
}

/// The grain at one of the 36 sites of a lattice in the box; radii from 0.6 to 1.2 mm.
#[must_use]
pub fn site<S: Scalar>(k: u32) -> Grain<S, 2> {
    let (odd, part) = (S::from_count(k * 11 % 32), n::<S>(0.01));
    let radius = n::<S>(0.6) + n::<S>(0.6 / 31.0) * odd;
    Grain::with_mass(radius, radius * radius * radius)
        .at([k % 6, k / 6].map(|place| S::from_count(2 + 4 * place)))
        .moving([part * (odd - n(15.5)), part * (n::<S>(16.0) - S::from_count(k))])
}

/// Glass, read from this table.
fn glass<S: Number>(table: &'static Table<S::Stored>) -> Rubber<S> {
    let law = Viscoelastic { young: n(YOUNG), poisson: n(POISSON), dissipation: n(DISSIPATION) };
    Soft::with_table(law, table, Outside::HardSphere)
}

/// The memory of the tilt box: its grains, its four walls, and three times as many cells: nearly as fine as the beads.
pub type Box32<S> = Memory<S, 2, GRAINS, 4, 0, { 3 * GRAINS }>;

/// Memory for the tilt box.
///
/// Not inlined, as [`tilt_box`]: the copy that is made of it does not stay on the stack.
#[inline(never)]
#[must_use]
pub fn memory<S: Scalar>() -> Box32<S> {
    Memory::default()
}

/// The tilt box.
///
/// Not inlined: the stack that building needs is free again before the first event.
///
/// # Errors
/// None unless the memory is too small.
#[inline(never)]
pub fn tilt_box<'m, S: Number>(
    memory: &'m mut impl Storage<S, 2>,
    table: &'static Table<S::Stored>,
) -> Result<World<'m, S, 2, PaperMode<Rubber<S>>>, Error> {
    tilt_box_begun(memory, table, (GRAINS as u32, S::one()))
}

/// The tilt box of so many beads, as high as they need, that begin so many times as fast: another trajectory of the
/// same box.
///
/// # Errors
/// As [`tilt_box`].
#[inline(never)]
pub fn tilt_box_begun<'m, S: Number>(
    memory: &'m mut impl Storage<S, 2>,
    table: &'static Table<S::Stored>,
    (beads, faster): (u32, S),
) -> Result<World<'m, S, 2, PaperMode<Rubber<S>>>, Error> {
    let begun = |k| {
        let mut grain = site::<S>(k);
        grain.velocity *= faster;
        grain
    };
    World::builder(memory)
        .walls([SIDE, 4 * beads.div_ceil(6)].map(|side| [S::zero(), S::from_count(side)]))
        .gravity(accelerometer(0))
        .rule(PaperMode(glass(table)))
        .grains((0..beads).map(begun))?
        .start()
}

/// The accelerometer's readings: the box is rocked by 67.5 degrees to either side, then turned over
/// once. From one reading to the next it turns by a 32nd.
#[must_use]
pub fn accelerometer<S: Scalar>(reading: u32) -> [S; 2] {
    turned(match reading % 56 {
        rocked @ 0..6 => rocked,
        rocked @ 6..18 => 32 + 12 - rocked,
        rocked => rocked + 8,
    })
}

/// Gravity in a box that has been turned by so many 32nds.
#[must_use]
pub fn turned<S: Scalar>(turn: u32) -> [S; 2] {
    // Gravity along an axis at 0, 11.25, ... 90 degrees.
    const SINE: [f32; 9] = [
        0.0,
        0.195_090_32,
        0.382_683_43,
        0.555_570_23,
        core::f32::consts::FRAC_1_SQRT_2,
        0.831_469_61,
        0.923_879_53,
        0.980_785_28,
        1.0,
    ];
    let sine = |turn: u32| {
        let part = (turn % 16) as usize;
        let value = SINE.get(part.min(16 - part)).copied().unwrap_or(0.0);
        let value = S::from_f32(value) * n(GRAVITY);
        if turn % 32 < 16 { value } else { -value }
    };
    [sine(turn), -sine(turn + 8)]
}

/// The instant of a reading.
#[must_use]
pub fn instant(reading: u32) -> Instant {
    // Exact: below 2²⁴.
    Instant::from((reading * BETWEEN_READINGS) as f32)
}

/// Runs the script on a board, a frame for each reading: physics up to the frame's end, but no more than so many
/// events, then sleep. Returns in how many frames that was too little: the box goes slower
/// there, and nobody waits for it.
///
/// # Errors
/// Any error of the engine.
#[inline(never)]
pub fn run_script<S: Scalar, R: Rule<S>>(
    world: &mut World<'_, S, 2, R>,
    events: u32,
    board: &mut impl Board,
) -> Result<u32, Error> {
    let mut done = 0;
    for reading in 0..READINGS {
        let mut left = events;
        let share = || {
            left = left.saturating_sub(1);
            left > 0
        };
        done += u32::from(frame(world, [reading, done], accelerometer, share)?);
        board.sleep_until(instant(reading + 1));
        if reading % READINGS_A_FRAME == 0 {
            show(world, board);
        }
    }
    Ok(READINGS - done)
}

/// One frame: the accelerometer is read, and physics goes on to the end of the frame after those that are done, as long
/// as it has a share of time left: asked before each event. Whether it arrived.
///
/// # Errors
/// Any error of the engine.
pub fn frame<S: Scalar, R: Rule<S>>(
    world: &mut World<'_, S, 2, R>,
    [reading, done]: [u32; 2],
    accelerometer: fn(u32) -> [S; 2],
    mut share: impl FnMut() -> bool,
) -> Result<bool, Error> {
    world.set_gravity(accelerometer(reading))?;
    while share() {
        if world.advance_with_budget(instant(done + 1), 1)? {
            return Ok(true);
        }
    }
    Ok(false)
}

/// The LED matrix: a lamp is lit where a grain's centre is, brighter where there are two.
pub fn show<S: Scalar, R: Rule<S>>(world: &World<'_, S, 2, R>, board: &mut impl Board) {
    let mut lamps = [[b'.'; LAMPS]; LAMPS];
    for grain in (0..GRAINS).filter_map(|k| world.grain(k)) {
        let lamps_a_millimetre = n::<S>(LAMPS as f64 / f64::from(SIDE));
        let at = |x: S| ((x * lamps_a_millimetre).to_count() as usize).min(LAMPS - 1);
        let lamp = lamps.get_mut(LAMPS - 1 - at(grain.position.y));
        if let Some(lamp) = lamp.and_then(|row| row.get_mut(at(grain.position.x))) {
            *lamp = if *lamp == b'.' { b'o' } else { b'O' };
        }
    }
    for row in &lamps {
        board.write(row);
        board.write(b"\n");
    }
    board.write(b"\n");
}

/// A number, as sixteen hexadecimal digits. Formatting with `core::fmt` would cost flash and could panic.
#[must_use]
pub fn hexadecimal(number: u64) -> [u8; 16] {
    core::array::from_fn(|k| {
        let digit = (number >> (60 - 4 * k)) as u8 & 15;
        if digit < 10 { b'0' + digit } else { b'a' + digit - 10 }
    })
}
