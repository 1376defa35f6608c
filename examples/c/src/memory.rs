//! Where does everything lie in the caller's memory? Reads how many grains and planes; writes empty arrays.

use crate::law::Number;
use carom::particle::{Body, Index, Partner};
use carom::space::{Link, MAX_PLANES, Plane};
use carom::world::{Buffers, ObstacleBuffers, RotationBuffers, ScheduledEvent, Storage as _};
use carom::{Memory, Vector};
use core::slice;

/// Where each array begins, in bytes from the start of the memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    bodies: usize,
    events: usize,
    links: usize,
    accelerations: usize,
    planes: usize,
    tree: usize,
    heads: usize,
    /// How many grains there are places for.
    pub grains: usize,
    /// How many planes there are places for.
    pub plane_places: usize,
    /// How long all of it is.
    pub bytes: usize,
}

/// Where so many of them begin, not before `end`, and where they end; the largest number if that is too far.
const fn after<T>(end: usize, count: usize) -> [usize; 2] {
    let last = align_of::<T>() - 1;
    let start = end.saturating_add(last) & !last;
    [start, start.saturating_add(size_of::<T>().saturating_mul(count))]
}

impl Layout {
    /// Of a world of so many grains and planes behind an `H`. What follows from too many is longer than any memory.
    #[must_use]
    pub const fn of<H, S: Number, const D: usize>(grains: usize, plane_places: usize) -> Self {
        let [_, end] = after::<H>(0, 1);
        let [bodies, end] = after::<Body<S, D>>(end, grains);
        let [events, end] = after::<ScheduledEvent<S>>(end, grains);
        let [accelerations, end] = after::<Vector<S, D>>(end, grains);
        let [planes, end] = after::<Plane<S, D>>(end, plane_places);
        let [links, end] = after::<Link>(end, grains);
        let [tree, end] = after::<Index>(end, grains);
        let [heads, bytes] = after::<Index>(end, grains);
        Self {
            bodies,
            events,
            links,
            accelerations,
            planes,
            tree,
            heads,
            grains,
            plane_places,
            bytes,
        }
    }

    /// Whether there can be such a world at all.
    #[must_use]
    pub fn is_possible(&self) -> bool {
        self.bytes <= isize::MAX as usize
            && self.grains <= Partner::MAX_GRAINS
            && self.plane_places <= MAX_PLANES
    }

    /// The arrays, empty.
    ///
    /// # Safety
    /// From `start` on `self.bytes` bytes can be written, `start` has the alignment of the layout's `H`, which is the
    /// largest of all, and nobody else uses what lies behind the `H` as long as the arrays are used.
    pub unsafe fn arrays<S: Number, const D: usize>(
        &self,
        start: *mut u8,
    ) -> Buffers<'static, S, D> {
        let mut one = Memory::<S, D, 1, 1>::new();
        let vacant = one.buffers();
        let grains = self.grains;
        // SAFETY: each array begins where the layout says, aligned for what it holds as `start` has the
        // largest alignment of all; the layout puts them one behind the other, and behind the `H`.
        unsafe {
            Buffers {
                bodies: filled(start.add(self.bodies), grains, vacant.bodies),
                events: filled(start.add(self.events), grains, vacant.events),
                tree: filled(start.add(self.tree), grains, vacant.tree),
                links: filled(start.add(self.links), grains, vacant.links),
                heads: filled(start.add(self.heads), grains, vacant.heads),
                planes: filled(start.add(self.planes), self.plane_places, vacant.planes),
                accelerations: filled(start.add(self.accelerations), grains, vacant.accelerations),
                calendar: &mut [],
                rotation: RotationBuffers::default(),
                contacts: &mut [],
                obstacles: ObstacleBuffers::default(),
            }
        }
    }
}

/// An array of so many copies of the one that is vacant.
///
/// # Safety
/// `at` is aligned for `T`, and `count` of them can be written there, which nobody else uses.
unsafe fn filled<T: Copy>(at: *mut u8, count: usize, vacant: &[T]) -> &'static mut [T] {
    let Some(&vacant) = vacant.first() else { return &mut [] };
    let first = at.cast::<T>();
    for i in 0..count {
        // SAFETY: i < count, and the caller's promise.
        unsafe { first.add(i).write(vacant) };
    }
    // SAFETY: all of them are written, and the caller's promise.
    unsafe { slice::from_raw_parts_mut(first, count) }
}

/// The alignment that the memory of a world must have.
pub const ALIGNMENT: usize = if size_of::<usize>() == 8 { 64 } else { 8 };

/// Whether the alignment of an `H` is enough for everything, and [`ALIGNMENT`] for that.
#[must_use]
pub const fn is_aligned<H, S: Number, const D: usize>() -> bool {
    let largest = align_of::<H>();
    let arrays = [
        align_of::<Body<S, D>>(),
        align_of::<ScheduledEvent<S>>(),
        align_of::<Vector<S, D>>(),
        align_of::<Plane<S, D>>(),
        align_of::<Link>(),
        align_of::<Index>(),
    ];
    let mut i = 0;
    while i < arrays.len() {
        if arrays[i] > largest {
            return false;
        }
        i += 1;
    }
    largest <= ALIGNMENT
}

/// What the header's macro says: so many bytes, and so many for each grain and each plane.
#[derive(Clone, Copy, Debug)]
pub struct Promised {
    /// For all of it.
    pub fixed: usize,
    /// For each grain.
    pub grain: usize,
    /// For each plane.
    pub plane: usize,
}

impl Promised {
    /// Whether a world fits into what is promised, whatever it holds.
    #[must_use]
    pub const fn is_enough<H, S: Number, const D: usize>(self) -> bool {
        let [none, one] = [Layout::of::<H, S, D>(0, 0), Layout::of::<H, S, D>(1, 1)];
        let grain = size_of::<Body<S, D>>()
            + size_of::<ScheduledEvent<S>>()
            + size_of::<Vector<S, D>>()
            + size_of::<Link>()
            + 2 * size_of::<Index>();
        // Bodies follow an `H`, which is a multiple of their alignment; between the other arrays there are less than
        // eight bytes of nothing.
        let padding = 32;
        none.bytes + padding <= self.fixed
            && one.bytes <= self.fixed + self.grain + self.plane
            && grain <= self.grain
            && size_of::<Plane<S, D>>() <= self.plane
    }
}
