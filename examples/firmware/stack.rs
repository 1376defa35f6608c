//! How much stack did that take? Paints the free stack below the caller; reads how far down the paint is gone.
//!
//! The one place with `unsafe` in all of carom's examples: nothing else can look at memory that no
//! value owns. carom itself forbids it.
#![allow(unsafe_code)]

use core::ptr;

const PAINT: u32 = 0xCCCC_CCCC;
/// Below the caller's frame this much is left alone: the frames of these functions.
const MARGIN: usize = 256;

/// More is not painted.
const MAX_PAINTED: usize = 32 * 1024;

/// The painted part of the stack.
pub struct Painted {
    low: usize,
    high: usize,
}

impl Painted {
    /// Paints the free stack below the caller down to this address, but not more than 32 KiB of it.
    ///
    /// There must be nothing else: the linker scripts of this package leave all RAM above static data to
    /// the stack.
    #[inline(never)]
    pub fn new(lowest: usize) -> Self {
        let here = 0_u32;
        let high = ((&raw const here).addr() - MARGIN) & !3;
        let low = high.saturating_sub(MAX_PAINTED).max(lowest).min(high);
        for at in (low..high).step_by(4) {
            // SAFETY: RAM below the stack pointer and this function's frame, which no value owns; aligned.
            unsafe { ptr::with_exposed_provenance_mut::<u32>(at).write_volatile(PAINT) };
        }
        Self { low, high }
    }

    /// How far below its top the stack has been used since; `None` if further than was painted.
    #[inline(never)]
    pub fn used(&self) -> Option<usize> {
        let painted = |at: &usize| {
            // SAFETY: memory painted by `new`, still RAM, aligned; any bits are a u32.
            unsafe { ptr::with_exposed_provenance::<u32>(*at).read_volatile() == PAINT }
        };
        let left = (self.low..self.high).step_by(4).take_while(painted).count() * 4;
        (left > 0).then(|| self.high + MARGIN - self.low - left)
    }
}
