//! Who is near whom? Linked lists of grains in the cells of a grid, in borrowed memory; reads cells, writes lists.

use super::grid::{CellFace, Grid};
use super::if_sheared::IfSheared;
#[cfg(feature = "alloc")]
use super::levels::Levels;
use super::link::{END, Link, MORE};
#[cfg(feature = "alloc")]
use super::look_in_levels::From;
#[cfg(not(feature = "alloc"))]
use super::neighbour_lists::NeighbourBatch;
#[cfg(feature = "alloc")]
use super::neighbours::{BATCH, NeighbourBatch, put};
#[cfg(not(feature = "alloc"))]
use super::one_level::Levels;
use super::shear::Shear;
use crate::particle::{Body, Index};
use crate::scalar::Scalar;
#[cfg(feature = "alloc")]
use crate::scalar::Vector;

/// The lists of grains in cells, in borrowed memory.
pub(crate) struct Cells<'m, S: Scalar, const D: usize> {
    /// None: all pairs are neighbours.
    pub grid: Option<Grid<S, D>>,
    pub levels: Levels<D>,
    /// Whether images move, and along which axes.
    pub(super) sheared: IfSheared<Shear<S>>,
    pub(super) heads: &'m mut [Index],
    pub(super) links: &'m mut [Link],
    /// Whether there have been empty places: without, all grains are visited without a look at their links.
    #[cfg(feature = "alloc")]
    pub(super) has_empty: bool,
}

impl<'m, S: Scalar, const D: usize> Cells<'m, S, D> {
    /// Empty lists; `links` has one entry for each grain.
    pub fn new(
        (grid, levels): (Option<Grid<S, D>>, Levels<D>),
        sheared: Option<Shear<S>>,
        heads: &'m mut [Index],
        links: &'m mut [Link],
    ) -> Self {
        let sheared = IfSheared::new(sheared);
        let mut cells = Self {
            grid: None,
            levels,
            sheared,
            heads,
            links,
            #[cfg(feature = "alloc")]
            has_empty: false,
        };
        cells.reset(grid);
        cells
    }

    /// Empties all lists and takes this grid; false if it has more cells than there is room for, or is none.
    pub fn reset(&mut self, grid: Option<Grid<S, D>>) -> bool {
        self.heads.fill(Index::new(END));
        self.links.fill(Link::default());
        let fits = grid.as_ref().is_none_or(|g| g.is_valid() && g.cells() <= self.heads.len());
        self.grid = grid.filter(|_| fits);
        #[cfg(feature = "alloc")]
        {
            self.has_empty = false;
        }
        #[cfg(not(feature = "alloc"))]
        self.chain();
        fits
    }

    /// Takes the levels that grains need over this grid; false if they do not fit.
    pub fn choose_levels(&mut self, grid: &Grid<S, D>, bodies: &[Body<S, D>]) -> bool {
        let levels = Levels::over(grid, bodies, self.levels.sight(), self.heads.len());
        levels.map(|levels| self.levels = levels).is_some()
    }

    /// How many cells there is room for.
    pub fn capacity(&self) -> usize {
        self.heads.len()
    }

    /// The list of a grain of this radius in a cell.
    #[inline]
    pub fn list(&self, cell: u32, radius: S) -> u32 {
        self.grid.as_ref().map_or(cell, |grid| self.levels.list(grid, cell, radius))
    }

    /// Puts a grain into a list.
    #[expect(clippy::cast_possible_truncation, reason = "the builder refuses more than MAX_GRAINS")]
    pub fn insert(&mut self, grain: usize, list: u32) {
        let Some(head) = self.heads.get_mut(list as usize) else { return };
        let (grain, next) = (grain as u32, head.get() & !MORE);
        *head = Index::new(grain | if next == END { 0 } else { MORE });
        if let Some(link) = self.links.get_mut(next as usize) {
            link.previous = Index::new(grain);
        }
        if let Some(link) = self.links.get_mut(grain as usize) {
            *link = Link { next: Index::new(next), previous: Index::new(END) };
        }
    }

    /// Takes a grain out of its list.
    pub fn remove(&mut self, grain: usize, list: u32) {
        let Some(Link { next, previous }) = self.links.get(grain).copied() else { return };
        if let Some(link) = self.links.get_mut(next.get() as usize) {
            link.previous = previous;
        }
        if let Some(link) = self.links.get_mut(previous.get() as usize) {
            link.next = next;
        }
        if let Some(head) = self.heads.get_mut(list as usize) {
            let first = if previous.get() == END { next.get() } else { head.get() & !MORE };
            let after = self.links.get(first as usize).map_or(END, |link| link.next.get());
            *head = Index::new(first | if after == END { 0 } else { MORE });
        }
    }

    /// An empty place is visited by nobody. What is in it has been taken out of its list.
    #[expect(clippy::cast_possible_truncation, reason = "the builder refuses more than MAX_GRAINS")]
    pub fn vacate(&mut self, grain: usize) {
        if let Some(link) = self.links.get_mut(grain) {
            *link = Link { next: Index::new(END), previous: Index::new(grain as u32) };
        }
        #[cfg(feature = "alloc")]
        {
            self.has_empty = true;
        }
        #[cfg(not(feature = "alloc"))]
        self.chain();
    }

    /// The place is a grain's again.
    pub fn occupy(&mut self, grain: usize) {
        if let Some(link) = self.links.get_mut(grain) {
            *link = Link::default();
        }
        #[cfg(not(feature = "alloc"))]
        self.chain();
    }

    /// Visits all grains that one of this radius in this cell can see; all grains, if there is no grid.
    #[cfg(feature = "alloc")]
    pub fn for_each_near(&self, cell: u32, radius: S, mut visit: impl FnMut(usize)) {
        let at = &self.coordinates(cell);
        self.batches((at, radius), END, &mut |batch: &NeighbourBatch| {
            batch.for_each(|grain| visit(grain as usize));
        });
        self.and_across(at, &mut visit);
    }

    /// Visits all grains that one of this radius touches or overlaps if it is put here, and others; all, if there is
    /// no grid. `largest` is the largest radius of all.
    #[cfg(feature = "alloc")]
    pub fn for_each_touching(
        &self,
        position: &Vector<S, D>,
        [radius, _]: [S; 2],
        visit: impl FnMut(usize),
    ) {
        let cell = self.grid.as_ref().map_or(0, |grid| grid.locate(position));
        self.for_each_near(cell, radius, visit);
    }

    /// A cell's numbers along the axes; zeros without a grid.
    #[inline]
    pub fn coordinates(&self, cell: u32) -> [u32; D] {
        self.grid.as_ref().map_or([0; D], |grid| grid.coordinates(cell))
    }

    /// The same for the cell with these numbers along the axes, in batches, filled up with a number of one's choice.
    #[inline]
    pub fn batches(
        &self,
        (at, radius): (&[u32; D], S),
        filler: u32,
        visit: &mut dyn FnMut(&NeighbourBatch),
    ) {
        let Some(grid) = &self.grid else { return self.everyone(filler, visit) };
        if self.in_levels(grid, (at, radius, None), filler, visit) {
            self.within(&grid.around(at), filler, visit);
        }
    }

    /// The same after a grain has come into this cell: only those that were not near before.
    #[inline]
    pub fn ahead(
        &self,
        (at, radius): (&[u32; D], S),
        face: CellFace,
        filler: u32,
        visit: &mut dyn FnMut(&NeighbourBatch),
    ) {
        let Some(grid) = &self.grid else { return };
        if self.in_levels(grid, (at, radius, Some(face)), filler, visit) {
            self.within(&grid.ahead(at, face), filler, visit);
        }
    }

    /// Visits those that are listed in wider cells; and all, where a large grain looks. Whether those in the cells
    /// around are left.
    #[cfg(feature = "alloc")]
    #[inline(always)]
    fn in_levels(
        &self,
        grid: &Grid<S, D>,
        (at, radius, through): (&[u32; D], S, Option<CellFace>),
        filler: u32,
        visit: &mut dyn FnMut(&NeighbourBatch),
    ) -> bool {
        if self.levels.is_one() {
            return true;
        }
        self.look(grid, &From { at: *at, radius: radius.to_f64(), through }, filler, visit);
        self.levels.is_fine(radius)
    }

    /// Without levels those around are all.
    #[cfg(not(feature = "alloc"))]
    #[inline(always)]
    fn in_levels(
        &self,
        _: &Grid<S, D>,
        _: (&[u32; D], S, Option<CellFace>),
        _: u32,
        _: &mut dyn FnMut(&NeighbourBatch),
    ) -> bool {
        true
    }

    /// Visits the grains of all lists that a look into levels finds.
    #[cfg(feature = "alloc")]
    #[inline(never)]
    fn look(
        &self,
        grid: &Grid<S, D>,
        from: &From<D>,
        filler: u32,
        visit: &mut dyn FnMut(&NeighbourBatch),
    ) {
        let mut batch = NeighbourBatch::new(filler, false);
        self.levels.look(grid, from, &mut |list, same_image| {
            let head = self.heads.get(list as usize).map_or(END, |head| head.get());
            let mut grain = head & !MORE;
            if grain != END && same_image != batch.same_image {
                batch.flush(filler, visit);
                batch.same_image = same_image;
            }
            while let Some(link) = self.links.get(grain as usize) {
                if batch.count == BATCH {
                    batch.flush(filler, visit);
                }
                put(&mut batch.grains, batch.count, grain);
                batch.count += 1;
                grain = link.next.get();
            }
        });
        batch.flush(filler, visit);
    }
}
