//! What happens in a box that is tilted? Reads a scripted accelerometer; shows an LED matrix over semihosting.
#![no_std]
#![no_main]

use carom_riscv::{Chip, Number, SHARE, app, table};
use carom_scenes::tilt::Board;
use riscv_rt::entry;
use semihosting::process;

#[entry]
fn main() -> ! {
    let mut chip = Chip::start();
    if let Err(error) = app::tilt_box::<Number>(table(), SHARE.0, &mut chip) {
        chip.write(error.brief().as_bytes());
        chip.write(b"\n");
        process::exit(error.code().into())
    }
    process::exit(0)
}
