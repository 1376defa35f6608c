//! How many instructions have been executed? Reads a counter of the machine, which QEMU drives by `-icount shift=0`.

/// Counts instructions from the start on.
#[cfg(target_arch = "riscv32")]
pub struct Counter;

#[cfg(target_arch = "riscv32")]
impl Counter {
    /// The counter; there is always one.
    pub fn start() -> Option<Self> {
        Some(Self)
    }

    /// Instructions since the start of the machine.
    pub fn instructions(&mut self) -> u64 {
        riscv::register::minstret::read64()
    }
}

/// Counts instructions from the start on: with `-icount shift=0` one takes one virtual nanosecond, and MPS2 runs at 25 MHz.
#[cfg(target_arch = "arm")]
pub struct Counter {
    ticks: u64,
    last: u32,
}

#[cfg(target_arch = "arm")]
impl Counter {
    const LONGEST: u32 = 0x00FF_FFFF;
    const INSTRUCTIONS_A_TICK: u64 = 40;

    /// Starts SysTick; none if somebody else has it.
    pub fn start() -> Option<Self> {
        let mut clock = cortex_m::Peripherals::take()?.SYST;
        clock.set_clock_source(cortex_m::peripheral::syst::SystClkSource::Core);
        clock.set_reload(Self::LONGEST);
        clock.clear_current();
        clock.enable_counter();
        Some(Self { ticks: 0, last: Self::LONGEST })
    }

    /// Instructions since the start. To be asked before SysTick has counted around: every 600 million.
    pub fn instructions(&mut self) -> u64 {
        let now = cortex_m::peripheral::SYST::get_current();
        self.ticks += u64::from(self.last.wrapping_sub(now) & Self::LONGEST);
        self.last = now;
        self.ticks * Self::INSTRUCTIONS_A_TICK
    }
}
