//! What is in the tilt box? 32 polydisperse viscoelastic grains under a turning gravity; reads a script, writes frames to a board.

use carom::law::Rule;
use carom::law::tables::Table;
use carom::{Fault, Instant, Lend, Scalar, World};

use crate::scene::{GRAVITY, Number, Rubber, grain, rubber, v};

/// How many grains.
pub const GRAINS: usize = 32;
/// The side of the box in millimetres.
pub const SIDE: u32 = 24;
/// The side of the LED matrix in lamps.
const LAMPS: usize = 16;
/// How long the script goes on: that many readings of the accelerometer.
pub const READINGS: u32 = 40;
/// Milliseconds between two readings: 40 Hz.
pub const BETWEEN_READINGS: u32 = 25;
/// Readings between two frames of the LED matrix.
const READINGS_A_FRAME: u32 = 4;

/// What the tilt box needs of a microcontroller board.
pub trait Board {
    /// Shows text.
    fn write(&mut self, text: &[u8]);
    /// Sleeps until that many milliseconds after the start; returns at once if that is over.
    fn sleep_until(&mut self, milliseconds: f64);
    /// How many instructions have been executed since the start. To be asked now and then.
    fn instructions(&mut self) -> u64;
}

/// The grain at one of the 36 sites of a lattice in the box; radii from 0.6 to 1.2 mm.
#[must_use]
pub fn site<S: Scalar>(k: u32) -> carom::Grain<S, 2> {
    let odd = f64::from(k * 11 % 32);
    let at = [2.0 + 4.0 * f64::from(k % 6), 2.0 + 4.0 * f64::from(k / 6)];
    grain(0.6 + 0.6 / 31.0 * odd, at, [0.01 * (odd - 15.5), 0.01 * (16.0 - f64::from(k))])
}

/// The tilt box.
///
/// # Errors
/// None unless the memory is too small.
pub fn tilt_box<'m, S: Number>(
    memory: &'m mut impl Lend<S, 2>,
    table: &'static Table<S::Stored>,
) -> Result<World<'m, S, 2, Rubber<S>>, Fault> {
    World::setup(memory)
        .walls([v([0.0, f64::from(SIDE)]); 2])
        .gravity(accelerometer(0))
        .rule(rubber(table))
        .grains((0..GRAINS as u32).map(site))?
        .start()
}

/// The accelerometer's readings: a box that is tilted to and fro, and turned over.
#[must_use]
pub fn accelerometer<S: Scalar>(reading: u32) -> [S; 2] {
    // Sine and cosine of 0, 22.5, 45, 67.5 and 90 degrees.
    const SINE: [f64; 5] = [0.0, 0.382_683_4, 0.707_106_8, 0.923_879_5, 1.0];
    let sine = |sixteenth: u32| {
        let part = (sixteenth % 8) as usize;
        let value = SINE.get(part.min(8 - part)).copied().unwrap_or(0.0);
        if sixteenth % 16 < 8 { value } else { -value }
    };
    let sixteenth = if reading % 20 < 10 { reading % 20 } else { 28 - reading % 20 };
    v([GRAVITY * sine(sixteenth), -GRAVITY * sine(sixteenth + 4)])
}

/// The instant of a reading.
#[must_use]
pub fn instant(reading: u32) -> Instant {
    Instant::from(f64::from(reading * BETWEEN_READINGS))
}

/// Plays the script on a board: sleeps until the next event, and shows the box now and then.
///
/// # Errors
/// Any fault of the engine.
pub fn play<S: Scalar, R: Rule<S>>(
    world: &mut World<'_, S, 2, R>,
    board: &mut impl Board,
) -> Result<(), Fault> {
    for reading in 0..READINGS {
        world.set_gravity(accelerometer(reading))?;
        let end = instant(reading + 1);
        while let Some(next) = world.next_event_time().filter(|next| *next < end) {
            board.sleep_until(next.as_f64());
            world.advance_to(next)?;
        }
        board.sleep_until(end.as_f64());
        world.advance_to(end)?;
        if reading % READINGS_A_FRAME == 0 {
            show(world, board);
        }
    }
    Ok(())
}

/// The LED matrix: a lamp is lit where a grain's centre is, brighter where there are two.
fn show<S: Scalar, R: Rule<S>>(world: &World<'_, S, 2, R>, board: &mut impl Board) {
    let mut lamps = [[b'.'; LAMPS]; LAMPS];
    for grain in (0..GRAINS).filter_map(|k| world.grain(k)) {
        let pitch = f64::from(SIDE) / LAMPS as f64;
        let at = |x: S| ((x.to_f64() / pitch) as usize).min(LAMPS - 1);
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
