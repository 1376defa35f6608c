//! What do the longest step and the longest frame take, and a collision of a dilute gas? Reads SysTick under `-icount`; writes lines over semihosting.
#![no_std]
#![no_main]

use carom_cortex_m::{Chip, M4F, MPS2, Number, SHARE, frames, table};
use cortex_m_rt::entry;
use semihosting::process;

/// The most disks that heap up, and beads: where arithmetic is calls, more take minutes here; 32 beads `measure` has.
const MOST: [usize; 2] = if M4F { [32, 16] } else { [8, 16] };

#[entry]
fn main() -> ! {
    let Some(peripherals) = cortex_m::Peripherals::take() else { process::exit(2) };
    let mut chip = Chip::start(peripherals.SYST, MPS2);
    frames::all::<Number>(MOST, table(), SHARE.1, &mut chip);
    if M4F {
        frames::gases::<Number>(table(), &mut chip);
    }
    process::exit(0)
}
