//! What does the tilt box take on this board? Reads minstret under `-icount`; writes lines over semihosting.
#![no_std]
#![no_main]

use carom_riscv::{Chip, Number, SHARE, STACK, app};
use carom_scenes::Number as _;
use riscv_rt::entry;
use semihosting::process;

#[entry]
fn main() -> ! {
    app::measure_all::<Number>(
        &[("compact", Number::compact())],
        1,
        STACK,
        SHARE,
        &mut Chip::start(),
    );
    process::exit(0)
}
