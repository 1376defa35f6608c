//! What does a RISC-V board offer? Reads minstret; writes over semihosting.
#![no_std]

#[path = "../../app.rs"]
pub mod app;
#[path = "../../replay.rs"]
pub mod replay;
#[path = "../../stack.rs"]
pub mod stack;

use carom_scenes::tilt::{Board, Table};
use semihosting::io::{self, Write};

/// How much of the stack is painted.
pub const PAINT: usize = 32 * 1024;

/// The table of this board's tilt box.
#[must_use]
pub fn table() -> &'static Table {
    &carom::law::tables::compact::VISCOELASTIC
}

/// The board: its counter of instructions, and a console.
pub struct Chip {
    console: Option<io::Stdout>,
}

impl Chip {
    /// Opens the console.
    #[must_use]
    pub fn start() -> Self {
        Self { console: io::stdout().ok() }
    }
}

impl Board for Chip {
    fn write(&mut self, text: &[u8]) {
        if let Some(console) = &mut self.console {
            // There is nobody to tell if the console is gone.
            let _ = console.write_all(text);
        }
    }

    /// Waits: with `-icount shift=0` one instruction takes one virtual nanosecond. A board with a
    /// timer of its own would set it and execute `wfi`, as the Cortex-M package does.
    fn sleep_until(&mut self, milliseconds: f64) {
        let end = (milliseconds * 1.0e6) as u64;
        while self.instructions() < end {
            core::hint::spin_loop();
        }
    }

    fn instructions(&mut self) -> u64 {
        riscv::register::minstret::read64()
    }
}
