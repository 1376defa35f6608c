//! What does the tilt box take on this board? Reads SysTick under `-icount`; writes lines over semihosting.
#![no_std]
#![no_main]

use carom_cortex_m::{Chip, PAINT, app};
use cortex_m_rt::entry;
use semihosting::process;

#[entry]
fn main() -> ! {
    let Some(peripherals) = cortex_m::Peripherals::take() else { process::exit(2) };
    app::measure_all(PAINT, &mut Chip::start(peripherals.SYST));
    process::exit(0)
}
