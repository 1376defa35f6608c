//! How are neighbours handed on without the feature `alloc`? All of a look at once, list by list; reads lists, writes nothing.
//!
//! On small machines nothing is gained by gathering first: they neither guess branches nor read ahead.

use super::cells::{Cells, Link};
use super::grid::{CellBlock, MAX_AXES, NOWHERE};
use crate::particle::Index;
use crate::scalar::{Scalar, Vector};

/// The end of a cell's list.
pub(super) const END: u32 = u16::MAX as u32;

/// No bit of a head says how long its list is.
pub(super) const MORE: u32 = 0;

/// Those in the cells around one; without cells all grains.
pub(crate) struct NeighbourBatch<'a> {
    cells: &'a CellBlock,
    heads: &'a [Index],
    links: &'a [Link],
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

impl<S: Scalar, const D: usize> Cells<'_, S, D> {
    /// Visits the grains of these cells.
    #[inline]
    pub(super) fn within(
        &self,
        around: &CellBlock,
        _: u32,
        visit: &mut dyn FnMut(&NeighbourBatch<'_>),
    ) {
        let same_image = around.same_image;
        let (heads, links) = (&*self.heads, &*self.links);
        visit(&NeighbourBatch { cells: around, heads, links, same_image });
    }

    /// Visits all grains that one in this cell can see; all grains, if there is no grid.
    pub fn for_each_near(&self, cell: u32, radius: S, mut visit: impl FnMut(usize)) {
        self.all_near(cell, radius, &mut visit);
    }

    /// The same: one function for all who ask.
    #[inline(never)]
    fn all_near(&self, cell: u32, radius: S, visit: &mut dyn FnMut(usize)) {
        self.batches((&self.coordinates(cell), radius), END, &mut |batch| {
            batch.for_each(|grain| visit(grain as usize));
        });
    }

    /// Visits all grains that one of this radius touches or overlaps if it is put here, and others; all, if there is
    /// no grid. `largest` is the largest radius of all.
    pub fn for_each_touching(
        &self,
        position: &Vector<S, D>,
        [radius, largest]: [S; 2],
        mut visit: impl FnMut(usize),
    ) {
        let Some(grid) = &self.grid else { return self.all_near(0, radius, &mut visit) };
        // A grain may be beside its cell by rounding.
        let reach = (radius + largest) * S::from_f32(1.0 + 1.0 / 64.0);
        let cells = &grid.touching(&grid.coordinates(grid.locate(position)), position, reach);
        let (heads, links) = (&*self.heads, &*self.links);
        NeighbourBatch { cells, heads, links, same_image: false }
            .for_each(|grain| visit(grain as usize));
    }

    /// Visits all grains: without a grid they are one list, as if in one cell.
    pub(super) fn everyone(&self, _: u32, visit: &mut dyn FnMut(&NeighbourBatch<'_>)) {
        let first = (0..).zip(&*self.links).find(|(grain, link)| link.is_of(*grain));
        let heads = &[Index::new(first.map_or(END, |(grain, _)| grain))];
        let cells = &CellBlock { steps: [[0, NOWHERE, NOWHERE]; MAX_AXES], same_image: false };
        visit(&NeighbourBatch { cells, heads, links: self.links, same_image: false });
    }

    /// Without a grid all grains are one list.
    pub(super) fn chain(&mut self) {
        if self.grid.is_some() {
            return;
        }
        let mut next = END;
        let links = self.links.iter_mut().enumerate().rev();
        #[expect(clippy::cast_possible_truncation, reason = "the builder refuses more than fit")]
        for (grain, link) in links.map(|(grain, link)| (grain as u32, link)) {
            if link.is_of(grain) {
                link.next = Index::new(next);
                next = grain;
            }
        }
    }
}

impl Link {
    /// Whether there is a grain in this place: in an empty one a link names itself.
    fn is_of(&self, grain: u32) -> bool {
        self.previous.get() != grain
    }
}
