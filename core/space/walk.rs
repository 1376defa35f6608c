//! How are neighbours handed on without the feature `alloc`? All of a look at once, list by list; reads lists, writes nothing.

use super::cells::Cells;
use super::grid::{CellBlock, MAX_AXES, NOWHERE};
use super::link::END;
use super::neighbour_lists::NeighbourBatch;
use crate::particle::Index;
use crate::scalar::{Scalar, Vector};

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
        let at = &self.coordinates(cell);
        self.batches((at, radius), END, &mut |batch| {
            batch.for_each(|grain| visit(grain as usize));
        });
        self.and_across(at, visit);
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
        let reach = (radius + largest) * S::from_f32(1.0 + 1.0 / 32.0);
        let at = &grid.coordinates(grid.locate(position));
        let cells = &grid.touching(at, position, reach);
        let (heads, links) = (&*self.heads, &*self.links);
        NeighbourBatch { cells, heads, links, same_image: false }
            .for_each(|grain| visit(grain as usize));
        self.and_across(at, &mut visit);
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
