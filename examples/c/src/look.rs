//! What do the functions that C calls to look at a world do? Reads the world; writes nothing.

use crate::calls::Told;
use crate::error::carom_error;
use crate::held::{Held, State};
use crate::law::Number;
use crate::types::carom_statistics;
use carom::{Error, Grain, View};
use core::ffi::c_char;
use core::fmt::{self, Write};

impl<S: Number, const D: usize> Held<S, D> {
    fn view(&mut self) -> Told<View<'_, S, D>> {
        self.world().map(|world| world.view())
    }

    /// How many grains there are.
    pub fn count(&self) -> Told<u32> {
        let count = match &self.state {
            State::Described(builder) => builder.count(),
            State::Started(world) => world.view().len(),
            State::Lost => return Err(carom_error::CAROM_ERROR_NOT_STARTED),
        };
        u32::try_from(count).map_err(|_| carom_error::CAROM_ERROR_LENGTH)
    }

    /// A grain as it is now.
    pub fn grain(&mut self, index: u32) -> Told<Grain<S, D>> {
        self.view()?.grain(index as usize).ok_or(carom_error::CAROM_ERROR_INDEX)
    }

    /// Something of all grains, one number after the other.
    pub fn all(
        &mut self,
        part: impl Fn(&Grain<S, D>) -> [S; D],
    ) -> Told<impl ExactSizeIterator<Item = S>> {
        let view = self.view()?;
        let numbers = 0..view.len().saturating_mul(D);
        Ok(numbers.map(move |k| {
            let grain = view.grain(k / D);
            grain.map_or(S::zero(), |grain| part(&grain)[k % D])
        }))
    }

    /// The present.
    pub fn time(&mut self) -> Told<f64> {
        self.world().map(|world| world.now().as_f64())
    }

    /// When something happens next; infinite if nothing ever will.
    pub fn next_event_time(&mut self) -> Told<f64> {
        self.world().map(|world| world.next_event_time().map_or(f64::INFINITY, |at| at.as_f64()))
    }

    /// The kinetic energy.
    pub fn kinetic_energy(&mut self) -> Told<S> {
        self.view().map(|view| view.kinetic_energy())
    }

    /// The momentum.
    pub fn momentum(&mut self) -> Told<[S; D]> {
        self.view().map(|view| view.momentum().into())
    }

    /// The digest of the whole state.
    pub fn digest(&mut self) -> Told<u64> {
        self.world().map(|world| world.digest())
    }

    /// How often what happened.
    pub fn statistics(&mut self) -> Told<carom_statistics> {
        self.world().map(|world| world.statistics().into())
    }
}

/// Writes the text of an error and a zero behind it; what does not fit is left out.
///
/// # Safety
/// `text` can be written, `bytes` long, at least one.
pub unsafe fn write_text(text: *mut c_char, bytes: usize, error: Option<Error>) {
    let mut cut = Cut { next: text.cast(), left: bytes.saturating_sub(1) };
    if let Some(error) = error {
        // What does not fit is left out, which is all that can go wrong.
        let _ = write!(cut, "{error}");
    }
    // SAFETY: there was one byte more than `left` said.
    unsafe { cut.next.write(0) };
}

/// Text that is cut off where the memory ends.
struct Cut {
    next: *mut u8,
    left: usize,
}

impl Write for Cut {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        for &byte in text.as_bytes() {
            if self.left == 0 {
                return Err(fmt::Error);
            }
            // SAFETY: so many bytes are left from `next` on.
            unsafe {
                self.next.write(byte);
                self.next = self.next.add(1);
            }
            self.left -= 1;
        }
        Ok(())
    }
}
