//! What does the tilt box do on this machine? Reads the script; shows frames and the last digest, and the statistics in each number type.

use std::io::Write;

use carom::Error;
use carom::law::embedded::read::Table;
use carom::scalar::I32F32;
use carom_scenes::Number;
use carom_scenes::tilt::{self, Board};

/// A terminal: it never sleeps, and counts nothing.
struct Terminal {
    shown: bool,
}

impl Board for Terminal {
    fn write(&mut self, text: &[u8]) {
        if self.shown {
            // Nothing can be done if the terminal is gone.
            let _ = std::io::stdout().write_all(text);
        }
    }
    fn sleep_until(&mut self, _: carom::Instant) {}
    fn instructions(&mut self) -> u64 {
        0
    }
}

fn run<S: Number>(table: &'static Table<S::Stored>, shown: bool) -> Result<(), Error> {
    let mut memory = tilt::memory::<S>();
    let mut world = tilt::tilt_box(&mut memory, table)?;
    // A workstation has the time.
    tilt::run_script(&mut world, u32::MAX, &mut Terminal { shown })?;
    println!("{} {:016x} {:?}", S::NAME, world.digest(), world.statistics());
    Ok(())
}

fn main() -> Result<(), Error> {
    run::<f32>(<f32 as Number>::standard(), true)?;
    run::<f32>(f32::compact(), false)?;
    run::<f64>(<f64 as Number>::standard(), false)?;
    run::<I32F32>(<I32F32 as Number>::standard(), false)?;
    run::<I32F32>(I32F32::compact(), false)
}
