//! What does the tilt box take on this board? Reads SysTick under `-icount`; writes lines over semihosting.
#![no_std]
#![no_main]

use carom_cortex_m::{Chip, M4F, MPS2, Number, SHARE, STACK, app};
use carom_scenes::Number as _;
use cortex_m_rt::entry;
use semihosting::process;

#[entry]
fn main() -> ! {
    let Some(peripherals) = cortex_m::Peripherals::take() else { process::exit(2) };
    let tables = [("compact", Number::compact()), ("standard", Number::standard())];
    // A soft multiplication takes hundreds of instructions: one table and one run say enough there.
    let (tables, runs) = if M4F { (&tables[..], 4) } else { (&tables[..1], 1) };
    app::measure_all::<Number>(
        tables,
        runs,
        STACK,
        SHARE,
        &mut Chip::start(peripherals.SYST, MPS2),
    );
    process::exit(0)
}
