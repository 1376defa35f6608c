//! Which digests does this board get in I32F32? Reads the command line; writes lines over semihosting.
#![no_std]
#![no_main]

use carom::number::I32F32;
use cortex_m_rt::entry;
use semihosting::process;

#[entry]
fn main() -> ! {
    process::exit(carom_cortex_m::replay::main::<I32F32>())
}
