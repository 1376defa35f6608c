//! What does a Cortex-M board offer? Reads SysTick; writes over semihosting, sleeps.
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
#[cfg(not(target_abi = "eabihf"))]
use carom_soft_float as _;
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m::peripheral::{SCB, SYST};
use semihosting::sys::arm_compat::sys_writec;

/// A Cortex-M4F (it has the hard-float ABI), or a Cortex-M0?
pub const M4F: bool = cfg!(target_abi = "eabihf");

/// The core clock of MPS2 as QEMU runs it, in ticks a millisecond.
pub const MPS2: u32 = 25_000;
/// The core clock of the tilt box's board: MPS2 with AN386, or the micro:bit.
pub const CLOCK: u32 = if M4F { MPS2 } else { 16_000 };

/// Events that the tilt box may take in a frame, and instructions: 13.5 ms of 25 at 100 MHz, and 20 at 48 MHz.
pub const SHARE: (u32, u64) = if M4F { (160, 1_350_000) } else { (6, 960_000) };

/// With `-icount shift=0` one instruction takes one virtual nanosecond.
const NANOSECONDS_PER_MILLISECOND: u64 = 1_000_000;

/// The longest that SysTick can count.
const LONGEST: u32 = 0x00FF_FFFF;

/// Above this address RAM is the stack's: these images have a few bytes of static data.
pub const STACK: usize = 0x2000_0040;

/// The number of this board's tilt box: in software, too, `f32` is faster and smaller than fixed point (../README.md).
pub type Number = f32;

/// The table of this board's tilt box: the compact one where flash is short.
#[must_use]
pub fn table() -> &'static Table<<Number as carom_scenes::Number>::Stored> {
    if M4F { Number::standard() } else { Number::compact() }
}

/// The board: its clock.
pub struct Chip {
    clock: SYST,
    /// Ticks before the present count.
    before: u64,
    /// The length of the present count, less one.
    reload: u32,
    ticks_per_millisecond: u32,
}

impl Chip {
    /// Starts the clock, which ticks so often in a millisecond.
    ///
    /// Interrupts stay masked: SysTick's becomes pending at the end of a count, which ends a sleep and
    /// needs no handler.
    #[must_use]
    pub fn start(mut clock: SYST, ticks_per_millisecond: u32) -> Self {
        cortex_m::interrupt::disable();
        clock.set_clock_source(SystClkSource::Core);
        clock.set_reload(LONGEST);
        clock.clear_current();
        clock.enable_interrupt();
        clock.enable_counter();
        Self { clock, before: 0, reload: LONGEST, ticks_per_millisecond }
    }

    /// Ticks since the start.
    fn ticks(&mut self) -> u64 {
        let mut left = SYST::get_current();
        if SCB::is_pendst_pending() {
            SCB::clear_pendst();
            self.before += u64::from(self.reload) + 1;
            left = SYST::get_current();
        }
        // The count begins with one tick at zero.
        let counted = if left == 0 { 0 } else { self.reload - left + 1 };
        self.before + u64::from(counted)
    }

    /// Counts anew from this number.
    fn count_from(&mut self, reload: u32) {
        self.before = self.ticks();
        self.reload = reload;
        self.clock.set_reload(reload);
        self.clock.clear_current();
    }
}

impl Board for Chip {
    /// A byte at a time: the console's `write` could panic, and nothing in the image shall.
    fn write(&mut self, text: &[u8]) {
        text.iter().for_each(|&byte| sys_writec(byte));
    }

    fn sleep_until(&mut self, instant: Instant) {
        let end = instant.counts(self.ticks_per_millisecond);
        loop {
            let rest = end.saturating_sub(self.ticks());
            if rest < 64 {
                return;
            }
            self.count_from(rest.min(u64::from(LONGEST)) as u32);
            cortex_m::asm::wfi();
            self.count_from(LONGEST);
        }
    }

    fn instructions(&mut self) -> u64 {
        let nanoseconds = self.ticks() * NANOSECONDS_PER_MILLISECOND;
        nanoseconds.checked_div(u64::from(self.ticks_per_millisecond)).unwrap_or(0)
    }
}
