//! What does the tilt box do on this machine? Reads the script; shows frames, the last digest and what a run takes.

use std::io::Write;

use carom::law::tables;
use carom::{Fault, Memory};
use carom_scenes::measure;
use carom_scenes::tilt::{self, Board, GRAINS, READINGS};

/// A terminal: it never sleeps, and counts nothing.
struct Terminal;

impl Board for Terminal {
    fn write(&mut self, text: &[u8]) {
        // There is nobody to tell if the terminal is gone.
        let _ = std::io::stdout().write_all(text);
    }
    fn sleep_until(&mut self, _milliseconds: f64) {}
    fn instructions(&mut self) -> u64 {
        0
    }
}

fn main() -> Result<(), Fault> {
    let mut memory = Memory::<f32, 2, GRAINS>::new();
    let mut world = tilt::tilt_box(&mut memory, tables::viscoelastic())?;
    tilt::play(&mut world, &mut Terminal)?;
    println!("{:016x} {:?}", world.digest(), world.counters());
    let cost = measure::event_driven(&mut memory, tables::viscoelastic(), READINGS, &mut Terminal)?;
    println!("{cost:?}");
    Ok(())
}
