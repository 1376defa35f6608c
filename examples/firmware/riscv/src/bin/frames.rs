//! What do the longest step and the longest frame take? Reads minstret under `-icount`; writes lines over semihosting.
#![no_std]
#![no_main]

use carom_riscv::{Chip, Number, SHARE, frames, table};
use riscv_rt::entry;
use semihosting::process;

#[entry]
fn main() -> ! {
    frames::all::<Number>([8, 16], table(), SHARE.1, &mut Chip::start());
    process::exit(0)
}
