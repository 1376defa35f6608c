//! Which digests does this board get in I32F32? Reads the command line; writes lines over semihosting.
#![no_std]
#![no_main]

use carom::number::I32F32;
use riscv_rt::entry;
use semihosting::process;

#[entry]
fn main() -> ! {
    process::exit(carom_riscv::replay::main::<I32F32>())
}
