//! What does the tilt box take on this board? Reads minstret under `-icount`; writes lines over semihosting.
#![no_std]
#![no_main]

use carom_riscv::{Chip, PAINT, app};
use riscv_rt::entry;
use semihosting::process;

#[entry]
fn main() -> ! {
    app::measure_all(PAINT, &mut Chip::start());
    process::exit(0)
}
