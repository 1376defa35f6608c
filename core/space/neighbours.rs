//! How are neighbours handed on? In batches of a fixed size, gathered from the lists of cells; reads lists, writes batches.

use super::link::{END, MORE};
use crate::scalar::LANES;

/// How many neighbours are visited at a time: a multiple of the lanes, and more than cells are visited at a time.
pub(crate) const BATCH: usize = 32;

/// Neighbours that have been gathered.
pub(crate) struct NeighbourBatch {
    pub(super) grains: [u32; BATCH],
    pub(super) count: usize,
    /// The first grains of lists with more than one.
    pub(super) more: [u32; BATCH],
    pub(super) lists: usize,
    /// Whether they are the nearest images of those in the cell looked from.
    pub same_image: bool,
}

/// Writes a place that is always there: no check is left of it.
#[inline(always)]
pub(crate) fn put(places: &mut [u32; BATCH], place: usize, grain: u32) {
    if let Some(place) = places.get_mut(place % BATCH) {
        *place = grain;
    }
}

impl NeighbourBatch {
    /// Nobody yet.
    #[inline(always)]
    pub(super) fn new(filler: u32, same_image: bool) -> Self {
        Self { grains: [filler; BATCH], count: 0, more: [0; BATCH], lists: 0, same_image }
    }

    /// Takes the head of a list in; that of an empty one gives way to the next. Counts grains, and lists with more.
    #[inline(always)]
    #[must_use]
    pub(super) fn put_list(&mut self, head: u32, (count, lists): (usize, usize)) -> (usize, usize) {
        let grain = head & !MORE;
        put(&mut self.grains, count, grain);
        put(&mut self.more, lists, grain);
        (count + usize::from(head != END), lists + (head / MORE) as usize)
    }

    /// The grains.
    pub fn all(&self) -> &[u32] {
        self.grains.get(..self.count).unwrap_or_default()
    }

    /// Visits the grains.
    #[inline]
    pub fn for_each(&self, visit: impl FnMut(u32)) {
        self.all().iter().copied().for_each(visit);
    }

    /// The grains, as many at a time as are computed with side by side; at the end the filler.
    #[inline]
    pub fn groups(&self) -> impl Iterator<Item = &[u32; LANES]> {
        const { assert!(BATCH % LANES == 0 && LANES <= 2) };
        let filled = self.grains.get(..self.count.next_multiple_of(LANES)).unwrap_or(&self.grains);
        filled.chunks_exact(LANES).filter_map(|group| group.first_chunk())
    }

    /// Some of them.
    pub fn only(&self, filler: u32, mut which: impl FnMut(u32) -> bool) -> Self {
        let mut few = Self::new(filler, self.same_image);
        for &grain in self.all() {
            put(&mut few.grains, few.count, grain);
            few.count += usize::from(which(grain));
        }
        few.end(filler);
        few
    }

    /// Puts the filler at the end.
    fn end(&mut self, filler: u32) {
        if let Some(end) = self.grains.get_mut(self.count) {
            *end = filler;
        }
    }

    /// Lets all be visited.
    #[inline(never)]
    pub(super) fn flush(&mut self, filler: u32, visit: &mut dyn FnMut(&Self)) {
        self.end(filler);
        visit(self);
        self.count = 0;
    }
}
