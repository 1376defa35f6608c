//! What happens in a box that is tilted? Reads a scripted accelerometer; shows an LED matrix over semihosting.
#![no_std]
#![no_main]

use carom_cortex_m::{CLOCK, Chip, Number, SHARE, app, table};
use carom_scenes::tilt::Board;
use cortex_m_rt::entry;
use semihosting::process;

#[entry]
fn main() -> ! {
    let Some(peripherals) = cortex_m::Peripherals::take() else { process::exit(2) };
    let mut chip = Chip::start(peripherals.SYST, CLOCK);
    if let Err(error) = app::tilt_box::<Number>(table(), SHARE.0, &mut chip) {
        chip.write(error.brief().as_bytes());
        chip.write(b"\n");
        process::exit(error.code().into())
    }
    process::exit(0)
}
