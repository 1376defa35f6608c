//! How small can a program be in the default mode? Reads a script; says by how it ends whether all went well.
#![no_std]
#![no_main]

#[path = "../../../smallest.rs"]
mod smallest;

use carom::law::IntegratedMode;
use carom_cortex_m as _; // where memory is, and arithmetic without a unit
use cortex_m_rt::entry;
use semihosting::process;

#[entry]
fn main() -> ! {
    process::exit(
        smallest::run::<_, 16>(IntegratedMode).map_or_else(|error| error.code().into(), |()| 0),
    )
}
