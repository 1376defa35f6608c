//! What do the largest step and the largest frame of a heap take? Reads SysTick under `-icount`; writes lines over semihosting.
#![no_std]
#![no_main]

use carom_cortex_m::{Chip, MPS2, Number, SHARE, app};
use cortex_m_rt::entry;
use semihosting::process;

#[entry]
fn main() -> ! {
    let Some(peripherals) = cortex_m::Peripherals::take() else { process::exit(2) };
    app::measure_heap::<Number>(SHARE.1, &mut Chip::start(peripherals.SYST, MPS2));
    process::exit(0)
}
