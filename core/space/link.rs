//! What does a list of grains consist of? Links, and marks for its end; reads and writes nothing else.

use crate::particle::Index;

/// The end of a cell's list.
#[cfg(feature = "alloc")]
pub(super) const END: u32 = u32::MAX >> 1;
#[cfg(not(feature = "alloc"))]
pub(super) const END: u32 = u16::MAX as u32;

/// A bit of the head of a list with more than one grain; without the feature `alloc` nobody asks for it.
#[cfg(feature = "alloc")]
pub(super) const MORE: u32 = 1 << 31;
#[cfg(not(feature = "alloc"))]
pub(super) const MORE: u32 = 0;

/// Before and after in the list of a grain's cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Link {
    pub(super) next: Index,
    pub(super) previous: Index,
}

impl Link {
    /// A place in memory that no grain has: all bits zero.
    pub(crate) const VACANT: Self = Self { next: Index::ZERO, previous: Index::ZERO };

    /// Whether there is a grain in this place: in an empty one a link names itself.
    pub(super) fn is_of(&self, grain: u32) -> bool {
        self.previous.get() != grain
    }
}

impl Default for Link {
    fn default() -> Self {
        Self { next: Index::new(END), previous: Index::new(END) }
    }
}
