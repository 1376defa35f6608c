//! How is a world kept and brought back? Reads its whole state; writes it into memory that the caller gives.

use crate::calls::Told;
use crate::error::carom_error;
use crate::held::{Held, State};
use crate::law::{AnyRule, Number};
use crate::memory::ALIGNMENT;
use crate::pointer::check;
use carom::World;
use carom::particle::Body;
use carom::world::{ScheduledEvent, Snapshot};
use core::{ptr, slice};

/// A snapshot in the caller's memory. Bodies and scheduled events follow it.
#[cfg_attr(target_pointer_width = "64", repr(align(64)))]
#[cfg_attr(not(target_pointer_width = "64"), repr(align(8)))]
pub struct Saved<S: Number, const D: usize> {
    sign: u32,
    rule: AnyRule<S>,
    grains: usize,
    planes: usize,
    state: Snapshot<S, D, (), ()>,
}

impl<S: Number, const D: usize> Saved<S, D> {
    /// What the memory of a snapshot of this kind begins with.
    const SIGN: u32 = 0x5A7E_0000 | ((D as u32) << 8) | size_of::<S>() as u32;

    /// Where bodies and events of so many grains begin, and where they end.
    const fn places(grains: usize) -> [usize; 3] {
        let last = align_of::<ScheduledEvent<S>>() - 1;
        let bodies = size_of::<Self>();
        let end = bodies.saturating_add(size_of::<Body<S, D>>().saturating_mul(grains));
        let events = end.saturating_add(last) & !last;
        [
            bodies,
            events,
            events.saturating_add(size_of::<ScheduledEvent<S>>().saturating_mul(grains)),
        ]
    }

    /// The snapshot behind a pointer.
    ///
    /// # Safety
    /// If it is not null and aligned, it points to memory of the size of a `Saved` that can be read and that nobody
    /// writes at the same time.
    unsafe fn at<'a>(saved: *const u8) -> Told<&'a Self> {
        check(saved)?;
        check(saved.cast::<Self>())?;
        let saved = saved.cast::<Self>();
        // SAFETY: the memory can be read, and a sign of any bits is one.
        if unsafe { (&raw const (*saved).sign).read() } != Self::SIGN {
            return Err(carom_error::CAROM_ERROR_NO_WORLD);
        }
        // SAFETY: `save` has written a snapshot there, and the caller's promise.
        Ok(unsafe { &*saved })
    }
}

impl<S: Number, const D: usize> Held<S, D> {
    /// How long a snapshot is now.
    pub fn saved_bytes(&mut self) -> Told<usize> {
        let [_, _, bytes] = Saved::<S, D>::places(self.world()?.view().len());
        Ok(bytes)
    }

    /// Writes a snapshot.
    ///
    /// # Safety
    /// If `memory` is not null and aligned, `bytes` bytes can be written there; the world is not among them.
    pub unsafe fn save(&mut self, memory: *mut u8, bytes: usize) -> Told {
        check(memory)?;
        if memory.addr() % ALIGNMENT != 0 {
            return Err(carom_error::CAROM_ERROR_MISALIGNED);
        }
        let rule = self.rule;
        let world = self.world()?;
        let (grains, planes) = (world.view().len(), world.view().boundary().planes().len());
        let [bodies, events, end] = Saved::<S, D>::places(grains);
        if end > bytes {
            return Err(carom_error::CAROM_ERROR_MEMORY);
        }
        let saved = world.save();
        let (from_bodies, from_events) = saved.arrays();
        // SAFETY: both arrays are as long as there are grains, and the places lie behind each other, aligned, within
        // the bytes that can be written.
        unsafe {
            let to = memory.add(bodies).cast();
            ptr::copy_nonoverlapping(from_bodies.as_ptr(), to, grains);
            let to = memory.add(events).cast();
            ptr::copy_nonoverlapping(from_events.as_ptr(), to, grains);
        }
        let state = saved.kept_in((), ());
        let saved = Saved { sign: Saved::<S, D>::SIGN, rule, grains, planes, state };
        // SAFETY: the places begin with one for it.
        unsafe { memory.cast::<Saved<S, D>>().write(saved) };
        Ok(())
    }

    /// Takes the state of a snapshot.
    ///
    /// # Safety
    /// `start` is where this world's memory begins, from the pointer that `create` was given. What `saved` points to
    /// is not being written, and if it is a snapshot, all of it can be read.
    pub unsafe fn restore(&mut self, start: *mut u8, saved: *const u8) -> Told {
        // SAFETY: the caller's promise.
        let kept = unsafe { Saved::<S, D>::at(saved) }?;
        if kept.grains > self.layout.grains || kept.planes > self.layout.plane_places {
            return Err(carom_error::CAROM_ERROR_MEMORY);
        }
        let [bodies, events, _] = Saved::<S, D>::places(kept.grains);
        // SAFETY: `save` has written as many bodies and events there.
        let (bodies, events) = unsafe {
            let bodies = saved.add(bodies).cast::<Body<S, D>>();
            let events = saved.add(events).cast::<ScheduledEvent<S>>();
            (slice::from_raw_parts(bodies, kept.grains), slice::from_raw_parts(events, kept.grains))
        };
        let snapshot = kept.state.clone().kept_in(bodies, events);
        // Who used the arrays uses them no longer.
        self.state = State::Lost;
        // SAFETY: `create` has laid out the memory so.
        let arrays = unsafe { self.layout.arrays(start) };
        let restored = World::restore_with(arrays, kept.rule, &snapshot);
        self.state = State::Started(self.note(restored)?);
        self.rule = kept.rule;
        Ok(())
    }
}
