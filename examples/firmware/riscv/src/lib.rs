//! What does a RISC-V board offer? Reads minstret; writes over semihosting.
#![no_std]

#[path = "../../app.rs"]
pub mod app;
#[path = "../../frames.rs"]
pub mod frames;
#[cfg(all(feature = "plates", feature = "obstacles"))]
#[path = "../../replay.rs"]
pub mod replay;
#[path = "../../stack.rs"]
pub mod stack;

use carom::Instant;
use carom::law::embedded::read::Table;
use carom_scenes::Number as _;
use carom_scenes::tilt::Board;
use carom_soft_float as _;
use semihosting::sys::arm_compat::sys_writec;

/// Above this address RAM is the stack's: these images have no static data.
pub const STACK: usize = 0x8040_0040;

/// The number of this board's tilt box: in software, too, `f32` is faster and smaller than fixed point (../README.md).
pub type Number = f32;

/// Events that the tilt box may take in a frame, and instructions: 15 ms of 25 at 160 MHz.
pub const SHARE: (u32, u64) = (40, 2_400_000);

/// The table of this board's tilt box: the compact one.
#[must_use]
pub fn table() -> &'static Table<<Number as carom_scenes::Number>::Stored> {
    Number::compact()
}

/// The board: its counter of instructions.
pub struct Chip;

impl Chip {
    /// There is nothing to start.
    #[must_use]
    pub fn start() -> Self {
        Self
    }
}

impl Board for Chip {
    /// A byte at a time: the console's `write` could panic, and nothing in the image shall.
    fn write(&mut self, text: &[u8]) {
        text.iter().for_each(|&byte| sys_writec(byte));
    }

    /// Waits: with `-icount shift=0` one instruction takes one virtual nanosecond. A board with a
    /// timer of its own would set it and execute `wfi`, as the Cortex-M package does.
    fn sleep_until(&mut self, instant: Instant) {
        let end = instant.counts(1_000_000);
        while self.instructions() < end {
            core::hint::spin_loop();
        }
    }

    fn instructions(&mut self) -> u64 {
        riscv::register::minstret::read64()
    }
}
