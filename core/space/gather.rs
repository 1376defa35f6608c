//! How are the neighbours of a cell gathered? List by list, first the first of all, then the next; reads lists, writes batches.

use super::cells::Cells;
use super::grid::{CellBlock, NOWHERE, Steps};
use super::link::{END, Link};
use super::neighbours::{BATCH, NeighbourBatch, put};
use crate::scalar::Scalar;

impl<S: Scalar, const D: usize> Cells<'_, S, D> {
    /// Visits the grains of these cells.
    ///
    /// They are gathered first, without a branch on whether there is one in a cell, and those behind the first in
    /// their lists after that: a chase from grain to grain and computations with them go badly together.
    #[inline(never)]
    pub(super) fn within(
        &self,
        around: &CellBlock,
        filler: u32,
        visit: &mut dyn FnMut(&NeighbourBatch),
    ) {
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
            let head = self.heads.get(cell as usize).map_or(END, |head| head.get());
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
        let next = |grain: u32| self.links.get(grain as usize).map_or(END, |link| link.next.get());
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

    /// Visits all grains.
    pub(super) fn everyone(&self, filler: u32, visit: &mut dyn FnMut(&NeighbourBatch)) {
        let mut first = 0;
        for some in self.links.chunks(BATCH) {
            let mut batch = NeighbourBatch::new(filler, false);
            match self.has_empty {
                true => batch.put_those_there(first, some),
                false => batch.put_row(first, some.len()),
            }
            first += BATCH as u32;
            batch.flush(filler, visit);
        }
    }
}

impl NeighbourBatch {
    /// Takes these places in, from the first on, but not the empty ones.
    fn put_those_there(&mut self, first: u32, links: &[Link]) {
        for (grain, link) in (first..).zip(links) {
            put(&mut self.grains, self.count, grain);
            self.count += usize::from(link.is_of(grain));
        }
    }

    /// Takes so many places in, from the first on.
    #[inline(always)]
    fn put_row(&mut self, first: u32, count: usize) {
        (0..).zip(&mut self.grains).for_each(|(step, place)| *place = first + step);
        self.count = count;
    }
}
