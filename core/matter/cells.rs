//! Who is near whom? Linked lists of grains in the cells of a grid, in borrowed memory; reads cells, writes lists.

use super::grid::{Grid, MOST_AXES, NOWHERE, Steps, Stride};
use crate::number::Scalar;

/// The end of a list.
const END: u32 = u32::MAX >> 1;

/// A bit of the head of a list with more than one grain.
const MORE: u32 = 1 << 31;

/// Before and after in the list of a grain's cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Link {
    next: u32,
    previous: u32,
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
    heads: &'m mut [u32],
    links: &'m mut [Link],
}

impl<'m, S: Scalar, const D: usize> Cells<'m, S, D> {
    /// Empty lists; `links` has one entry for each grain.
    pub fn new(grid: Option<Grid<S, D>>, heads: &'m mut [u32], links: &'m mut [Link]) -> Self {
        let mut cells = Self { grid: None, heads, links };
        cells.start(grid);
        cells
    }

    /// Empties all lists and takes this grid; false if it has more cells than there is room for, or is none.
    pub fn start(&mut self, grid: Option<Grid<S, D>>) -> bool {
        self.heads.fill(END);
        self.links.fill(Link::default());
        let fits = grid.as_ref().is_none_or(|g| g.is_sound() && g.cells() <= self.heads.len());
        self.grid = grid.filter(|_| fits);
        fits
    }

    /// How many cells there is room for.
    pub fn capacity(&self) -> usize {
        self.heads.len()
    }

    /// Puts a grain into a cell's list.
    #[expect(clippy::cast_possible_truncation, reason = "setup refuses more than MOST_GRAINS")]
    pub fn insert(&mut self, grain: usize, cell: u32) {
        let Some(head) = self.heads.get_mut(cell as usize) else { return };
        let next = *head & !MORE;
        *head = grain as u32 | if next == END { 0 } else { MORE };
        if let Some(link) = self.links.get_mut(next as usize) {
            link.previous = grain as u32;
        }
        if let Some(link) = self.links.get_mut(grain) {
            *link = Link { next, previous: END };
        }
    }

    /// Takes a grain out of its cell's list.
    pub fn remove(&mut self, grain: usize, cell: u32) {
        let Some(Link { next, previous }) = self.links.get(grain).copied() else { return };
        if let Some(link) = self.links.get_mut(next as usize) {
            link.previous = previous;
        }
        if let Some(link) = self.links.get_mut(previous as usize) {
            link.next = next;
        }
        if let Some(head) = self.heads.get_mut(cell as usize) {
            let first = if previous == END { next } else { *head & !MORE };
            let after = self.links.get(first as usize).map_or(END, |link| link.next);
            *head = first | if after == END { 0 } else { MORE };
        }
    }

    /// Visits all grains in this cell and its neighbours; all grains, if there is no grid.
    pub fn near(&self, cell: u32, mut visit: impl FnMut(usize)) {
        self.crowds(cell, &mut |crowd: &[u32], _| {
            crowd.iter().for_each(|&grain| visit(grain as usize));
        });
    }

    /// The same in crowds, and whether their images are the nearest of those in this cell.
    #[inline]
    pub fn crowds(&self, cell: u32, visit: &mut impl FnMut(&[u32], bool)) {
        match &self.grid {
            None => everyone(self.links.len(), visit),
            Some(grid) => self.within(&grid.steps(&grid.coordinates(cell)), visit),
        }
    }

    /// The same after a grain has come into this cell: only those that were not near before.
    #[inline]
    pub fn ahead(&self, cell: u32, stride: Stride, visit: &mut impl FnMut(&[u32], bool)) {
        let Some(grid) = &self.grid else { return };
        let (mut steps, straight) = grid.steps(&grid.coordinates(cell));
        if let Some([below, same, above]) = steps.get_mut(stride.axis) {
            let behind = if stride.up { below } else { above };
            (*behind, *same) = (NOWHERE, NOWHERE);
        }
        self.within(&(steps, straight), visit);
    }

    /// Visits the grains of the cells that these steps lead to: one of the three along each axis.
    ///
    /// They are gathered first: a chase from grain to grain and computations with them go badly together.
    #[inline(never)]
    fn within(&self, (steps, straight): &([Steps; D], bool), visit: &mut impl FnMut(&[u32], bool)) {
        let Some((&along, across)) = steps.split_first() else { return };
        let [first, second, third] = along;
        let side_by_side = first < NOWHERE && second == first + 1 && third == second + 1;
        let (mut crowd, mut count) = (Crowd { grains: [END; CROWD], straight: *straight }, 0);
        let (rows, many) = rows(across);
        for &row in rows.iter().take(many).filter(|&&row| row < NOWHERE) {
            if side_by_side {
                let from = (row + first) as usize;
                for &head in self.heads.get(from..from + 3).unwrap_or_default() {
                    count = self.gather(head, &mut crowd, count, visit);
                }
                continue;
            }
            for term in along {
                if let Some(&head) = self.heads.get((row + term) as usize) {
                    count = self.gather(head, &mut crowd, count, visit);
                }
            }
        }
        crowd.visited(count, visit);
    }

    /// Gathers the grains of a list, without a branch on whether there is one; returns how many there are now.
    #[inline]
    fn gather(
        &self,
        head: u32,
        crowd: &mut Crowd,
        count: usize,
        visit: &mut impl FnMut(&[u32], bool),
    ) -> usize {
        let now = crowd.put(head & !MORE, count);
        if head & MORE != 0 || now == CROWD {
            return self.gather_more(head, crowd, now, visit);
        }
        now
    }

    /// Gathers all but the first of a list, and makes room.
    #[inline(never)]
    fn gather_more(
        &self,
        head: u32,
        crowd: &mut Crowd,
        mut count: usize,
        visit: &mut impl FnMut(&[u32], bool),
    ) -> usize {
        let mut grain = head & !MORE;
        while grain != END {
            count = crowd.with_room(count, visit);
            grain = self.links.get(grain as usize).map_or(END, |link| link.next);
            count = crowd.put(grain, count);
        }
        crowd.with_room(count, visit)
    }
}

/// The numbers of all rows of cells, sums of a step along each axis, and how many there are.
#[inline]
fn rows(across: &[Steps]) -> ([u32; 9], usize) {
    const { assert!(MOST_AXES == 3, "nine rows are enough") };
    let (mut rows, mut count) = ([0_u32; 9], 1);
    for steps in across {
        for (digit, step) in steps.iter().enumerate().rev() {
            for row in 0..count {
                let sum = rows.get(row).copied().unwrap_or(NOWHERE) + step;
                if let Some(place) = rows.get_mut(digit * count + row) {
                    *place = sum;
                }
            }
        }
        count *= 3;
    }
    (rows, count)
}

/// How many neighbours are visited at a time.
pub(crate) const CROWD: usize = 32;

/// Neighbours that have been gathered. How many there are is passed from call to call: it stays in a register.
struct Crowd {
    grains: [u32; CROWD],
    /// Whether they are the nearest images.
    straight: bool,
}

impl Crowd {
    /// Puts a grain in, or nothing if it is the end of a list; returns how many there are now.
    #[inline]
    fn put(&mut self, grain: u32, count: usize) -> usize {
        if let Some(place) = self.grains.get_mut(count) {
            *place = grain;
        }
        count + usize::from(grain != END)
    }

    /// Makes room if there is none; returns how many there are now.
    fn with_room(&self, count: usize, visit: &mut impl FnMut(&[u32], bool)) -> usize {
        if count < CROWD {
            return count;
        }
        self.visited(count, visit);
        0
    }

    /// Lets all be visited.
    #[inline(never)]
    fn visited(&self, count: usize, visit: &mut impl FnMut(&[u32], bool)) {
        visit(self.grains.get(..count).unwrap_or_default(), self.straight);
    }
}

/// Visits all grains.
#[expect(clippy::cast_possible_truncation, reason = "setup refuses more than MOST_GRAINS")]
fn everyone(grains: usize, visit: &mut impl FnMut(&[u32], bool)) {
    for first in (0..grains).step_by(CROWD) {
        let numbers: [u32; CROWD] = core::array::from_fn(|i| (first + i) as u32);
        visit(numbers.get(..CROWD.min(grains - first)).unwrap_or_default(), false);
    }
}
