//! Whom does a look find without the feature `alloc`? The lists of the cells around; reads them, writes nothing.
//!
//! On small machines nothing is gained by gathering first: they neither guess branches nor read ahead.

use super::grid::{CellBlock, NOWHERE};
use super::link::{END, Link};
use crate::particle::Index;

/// Those in the cells around one; without cells all grains.
pub(crate) struct NeighbourBatch<'a> {
    pub(super) cells: &'a CellBlock,
    pub(super) heads: &'a [Index],
    pub(super) links: &'a [Link],
    /// Whether they are the nearest images of those in the cell looked from.
    pub same_image: bool,
}

impl NeighbourBatch<'_> {
    /// Visits the grains.
    #[inline(always)]
    pub fn for_each(&self, mut visit: impl FnMut(u32)) {
        let [one, near, far] = &self.cells.steps;
        for far in far.iter().filter(|far| **far < NOWHERE) {
            for row in near.iter().map(|near| far + near).filter(|row| *row < NOWHERE) {
                for step in one {
                    // There is no list beyond the last cell, so none where there is no step.
                    let head = self.heads.get((row + step) as usize);
                    let mut grain = head.map_or(END, |head| head.get());
                    while let Some(link) = self.links.get(grain as usize) {
                        visit(grain);
                        grain = link.next.get();
                    }
                }
            }
        }
    }
}
