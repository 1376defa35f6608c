//! Who is near whom? Linked lists of grains in the cells of a grid, in borrowed memory; reads cells, writes lists.

use super::grid::{CellBlock, CellFace, Grid, NOWHERE, Steps};
#[cfg(feature = "alloc")]
use super::levels::Levels;
#[cfg(feature = "alloc")]
use super::look_in_levels::From;
use super::neighbours::{BATCH, END, MORE, NeighbourBatch, put};
#[cfg(not(feature = "alloc"))]
use super::one_level::Levels;
use crate::particle::Body;
use crate::scalar::Scalar;

/// Before and after in the list of a grain's cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Link {
    next: u32,
    previous: u32,
}

impl Link {
    /// A place in memory that no grain has: all bits zero.
    pub(crate) const VACANT: Self = Self { next: 0, previous: 0 };
}

impl Default for Link {
    fn default() -> Self {
        Self { next: END, previous: END }
    }
}

/// The lists of grains in cells, in borrowed memory.
pub(crate) struct Cells<'m, S: Scalar, const D: usize> {
    /// None: all pairs are neighbours.
    pub grid: Option<Grid<S, D>>,
    pub levels: Levels<D>,
    heads: &'m mut [u32],
    links: &'m mut [Link],
}

impl<'m, S: Scalar, const D: usize> Cells<'m, S, D> {
    /// Empty lists; `links` has one entry for each grain.
    pub fn new(
        (grid, levels): (Option<Grid<S, D>>, Levels<D>),
        heads: &'m mut [u32],
        links: &'m mut [Link],
    ) -> Self {
        let mut cells = Self { grid: None, levels, heads, links };
        cells.reset(grid);
        cells
    }

    /// Empties all lists and takes this grid; false if it has more cells than there is room for, or is none.
    pub fn reset(&mut self, grid: Option<Grid<S, D>>) -> bool {
        self.heads.fill(END);
        self.links.fill(Link::default());
        let fits = grid.as_ref().is_none_or(|g| g.is_valid() && g.cells() <= self.heads.len());
        self.grid = grid.filter(|_| fits);
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
        let next = *head & !MORE;
        *head = grain as u32 | if next == END { 0 } else { MORE };
        if let Some(link) = self.links.get_mut(next as usize) {
            link.previous = grain as u32;
        }
        if let Some(link) = self.links.get_mut(grain) {
            *link = Link { next, previous: END };
        }
    }

    /// Takes a grain out of its list.
    pub fn remove(&mut self, grain: usize, list: u32) {
        let Some(Link { next, previous }) = self.links.get(grain).copied() else { return };
        if let Some(link) = self.links.get_mut(next as usize) {
            link.previous = previous;
        }
        if let Some(link) = self.links.get_mut(previous as usize) {
            link.next = next;
        }
        if let Some(head) = self.heads.get_mut(list as usize) {
            let first = if previous == END { next } else { *head & !MORE };
            let after = self.links.get(first as usize).map_or(END, |link| link.next);
            *head = first | if after == END { 0 } else { MORE };
        }
    }

    /// An empty place is visited by nobody. What is in it has been taken out of its list.
    #[expect(clippy::cast_possible_truncation, reason = "the builder refuses more than MAX_GRAINS")]
    pub fn vacate(&mut self, grain: usize) {
        if let Some(link) = self.links.get_mut(grain) {
            *link = Link { next: END, previous: grain as u32 };
        }
    }

    /// The place is a grain's again.
    pub fn occupy(&mut self, grain: usize) {
        if let Some(link) = self.links.get_mut(grain) {
            *link = Link::default();
        }
    }

    /// Visits all grains that one of this radius in this cell can see; all grains, if there is no grid.
    pub fn for_each_near(&self, cell: u32, radius: S, mut visit: impl FnMut(usize)) {
        self.batches((&self.coordinates(cell), radius), END, &mut |batch: &NeighbourBatch| {
            batch.all().iter().for_each(|&grain| visit(grain as usize));
        });
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
        let Some(grid) = &self.grid else { return everyone(self.links, filler, visit) };
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
            let head = self.heads.get(list as usize).copied().unwrap_or(END);
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
                grain = link.next;
            }
        });
        batch.flush(filler, visit);
    }

    /// Visits the grains of these cells.
    ///
    /// They are gathered first, without a branch on whether there is one in a cell, and those behind the first in
    /// their lists after that: a chase from grain to grain and computations with them go badly together.
    #[inline(never)]
    fn within(&self, around: &CellBlock, filler: u32, visit: &mut dyn FnMut(&NeighbourBatch)) {
        let mut batch = NeighbourBatch::new(filler, around.same_image);
        self.gather_firsts(around, &mut batch);
        while batch.lists > 0 {
            // Nobody's list is longer than there are places for the next of all.
            if batch.count + batch.lists > BATCH {
                batch.flush(filler, visit);
            }
            self.gather_next(&mut batch);
        }
        batch.flush(filler, visit);
    }

    /// Gathers the first of each list. The loops have a fixed length where no face of the world is near.
    #[inline(always)]
    fn gather_firsts(&self, around: &CellBlock, batch: &mut NeighbourBatch) {
        let [one, near, far] = &around.steps;
        // In a register: what is counted in memory must be there before the next can be put.
        let mut counts = (0, 0);
        let mut take = |cell: u32| {
            let head = self.heads.get(cell as usize).copied().unwrap_or(END);
            counts = batch.put_list(head, counts);
        };
        let all = |steps: &Steps| steps.iter().fold(0, |bits, step| bits | step) < NOWHERE;
        let is_single = one[1] >= NOWHERE;
        match (all(near) & all(far), is_single) {
            (true, true) => {
                far.iter().for_each(|far| near.iter().for_each(|near| take(far + near + one[0])));
            }
            _ => far.iter().for_each(|far| {
                let rows = near.iter().map(|near| far + near).filter(|row| *row < NOWHERE);
                rows.for_each(|row| one.iter().for_each(|step| take(row + step)));
            }),
        }
        (batch.count, batch.lists) = counts;
    }

    /// Gathers the next of each list that goes on.
    #[inline(always)]
    fn gather_next(&self, batch: &mut NeighbourBatch) {
        let next = |grain: u32| self.links.get(grain as usize).map_or(END, |link| link.next);
        let (mut count, mut lists) = (batch.count, 0);
        for list in 0..batch.lists {
            let grain = next(batch.more.get(list).copied().unwrap_or(END));
            put(&mut batch.grains, count, grain);
            put(&mut batch.more, lists, grain);
            count += 1;
            lists += usize::from(next(grain) != END);
        }
        (batch.count, batch.lists) = (count, lists);
    }
}

/// Visits all grains.
fn everyone(links: &[Link], filler: u32, visit: &mut dyn FnMut(&NeighbourBatch)) {
    let mut grain = 0;
    for some in links.chunks(BATCH) {
        let mut batch = NeighbourBatch::new(filler, false);
        for link in some {
            // In an empty place a link names itself.
            put(&mut batch.grains, batch.count, grain);
            batch.count += usize::from(link.previous != grain);
            grain += 1;
        }
        batch.flush(filler, visit);
    }
}
