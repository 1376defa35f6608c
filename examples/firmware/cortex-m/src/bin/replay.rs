//! Which digests does this board get? Reads the command line; writes lines over semihosting.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use semihosting::process;

#[entry]
fn main() -> ! {
    process::exit(carom_cortex_m::replay::main())
}
