//! What does the tilt box take on this board? Reads SysTick under `-icount`; writes lines over semihosting.
#![no_std]
#![no_main]

use carom::law::tables::Embedded;
use carom_cortex_m::{Chip, M4F, Number, STACK, app};
use carom_scenes::Number as _;
use cortex_m_rt::entry;
use semihosting::process;

#[entry]
fn main() -> ! {
    let Some(peripherals) = cortex_m::Peripherals::take() else { process::exit(2) };
    let tables = [("compact", Number::compact()), ("standard", Number::viscoelastic())];
    // A micro:bit has no room for the force-based run beside the other, and one table says enough there.
    let tables = if M4F { &tables[..] } else { &tables[..1] };
    app::measure_all::<Number>(tables, M4F, STACK, &mut Chip::start(peripherals.SYST));
    process::exit(0)
}
