//! What happens in an hourglass that is turned over? Reads a scripted accelerometer, SysTick under `-icount`; shows an LED matrix and lines over semihosting.
#![no_std]
#![no_main]

#[path = "../../../hourglass.rs"]
mod hourglass;
#[path = "../../../turned.rs"]
mod turned;

use carom_cortex_m::{Chip, MPS2, Number};
use carom_scenes::tilt::Board;
use cortex_m_rt::entry;
use semihosting::process;

#[entry]
fn main() -> ! {
    let Some(peripherals) = cortex_m::Peripherals::take() else { process::exit(2) };
    let mut chip = Chip::start(peripherals.SYST, MPS2);
    if let Err(error) = hourglass::run::<Number>(&mut chip) {
        chip.write(error.brief().as_bytes());
        chip.write(b"\n");
        process::exit(error.code().into())
    }
    process::exit(0)
}
