//! Who is near whom? Linked lists of grains in the cells of a grid, in borrowed memory; reads cells, writes lists.

use super::grid::{Around, Grid, NOWHERE, Stride};
use crate::number::{LANES, Scalar};

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
        self.crowds(&self.coordinates(cell), END, &mut |crowd: &Crowd| {
            crowd.all().iter().for_each(|&grain| visit(grain as usize));
        });
    }

    /// A cell's numbers along the axes; zeros without a grid.
    #[inline]
    pub fn coordinates(&self, cell: u32) -> [u32; D] {
        self.grid.as_ref().map_or([0; D], |grid| grid.coordinates(cell))
    }

    /// The same for the cell with these numbers along the axes, in crowds, filled up with a number of one's choice.
    #[inline]
    pub fn crowds(&self, at: &[u32; D], filler: u32, visit: &mut impl FnMut(&Crowd)) {
        match &self.grid {
            None => everyone(self.links.len(), filler, visit),
            Some(grid) => self.within(&grid.around(at), filler, visit),
        }
    }

    /// The same after a grain has come into this cell: only those that were not near before.
    #[inline]
    pub fn ahead(
        &self,
        at: &[u32; D],
        stride: Stride,
        filler: u32,
        visit: &mut impl FnMut(&Crowd),
    ) {
        let Some(grid) = &self.grid else { return };
        self.within(&grid.ahead(at, stride), filler, visit);
    }

    /// Visits the grains of these cells.
    ///
    /// They are gathered first, without a branch on whether there is one in a cell, and those behind the first in
    /// their lists after that: a chase from grain to grain and computations with them go badly together.
    #[inline(never)]
    fn within(&self, around: &Around, filler: u32, visit: &mut impl FnMut(&Crowd)) {
        let mut crowd = Crowd::new(filler, around.straight);
        let [along @ [first, second, third], near, far] = &around.steps;
        let side_by_side = *second == first + 1 && *third == second + 1;
        for row in far {
            for row in near.iter().map(|step| row + step).filter(|&row| row < NOWHERE) {
                let three =
                    self.heads.get((row + first) as usize..).and_then(<[u32]>::first_chunk::<3>);
                if let Some(three) = three.filter(|_| side_by_side) {
                    three.iter().for_each(|&head| crowd.put(head));
                    continue;
                }
                let cells = along.iter().filter_map(|step| self.heads.get((row + step) as usize));
                cells.for_each(|&head| crowd.put(head));
            }
        }
        for list in 0..crowd.lists {
            let first = crowd.more.get(list).copied().unwrap_or(END);
            self.gather(first, &mut crowd, filler, visit);
        }
        crowd.visited(filler, visit);
    }

    /// Gathers all but the first of a list, and makes room.
    #[inline]
    fn gather(&self, first: u32, crowd: &mut Crowd, filler: u32, visit: &mut impl FnMut(&Crowd)) {
        let mut grain = first;
        while let Some(Link { next, .. }) = self.links.get(grain as usize).filter(|l| l.next != END)
        {
            if crowd.count == CROWD {
                crowd.visited(filler, visit);
            }
            put(&mut crowd.grains, crowd.count, *next);
            crowd.count += 1;
            grain = *next;
        }
    }
}

/// How many neighbours are visited at a time: a multiple of the lanes, and more than cells are visited at a time.
pub(crate) const CROWD: usize = 32;

/// Neighbours that have been gathered.
pub(crate) struct Crowd {
    grains: [u32; CROWD],
    count: usize,
    /// The first grains of lists with more than one.
    more: [u32; CROWD],
    lists: usize,
    /// Whether they are the nearest images of those in the cell looked from.
    pub straight: bool,
}

/// Writes a place that is always there: no check is left of it.
#[inline(always)]
pub(crate) fn put(places: &mut [u32; CROWD], place: usize, grain: u32) {
    if let Some(place) = places.get_mut(place % CROWD) {
        *place = grain;
    }
}

impl Crowd {
    /// Nobody yet.
    #[inline(always)]
    fn new(filler: u32, straight: bool) -> Self {
        Self { grains: [filler; CROWD], count: 0, more: [0; CROWD], lists: 0, straight }
    }

    /// Takes the head of a list in; that of an empty one gives way to the next.
    #[inline(always)]
    fn put(&mut self, head: u32) {
        let grain = head & !MORE;
        put(&mut self.grains, self.count, grain);
        put(&mut self.more, self.lists, grain);
        self.count += usize::from(head != END);
        self.lists += (head / MORE) as usize;
    }

    /// The grains.
    pub fn all(&self) -> &[u32] {
        self.grains.get(..self.count).unwrap_or_default()
    }

    /// The grains, as many at a time as are computed with side by side; at the end the filler.
    #[inline]
    pub fn groups(&self) -> impl Iterator<Item = &[u32; LANES]> {
        const { assert!(CROWD.is_multiple_of(LANES) && LANES <= 2) };
        self.grains.as_chunks().0.iter().take(self.count.div_ceil(LANES))
    }

    /// Some of them.
    pub fn only(&self, filler: u32, mut which: impl FnMut(u32) -> bool) -> Self {
        let mut few = Self::new(filler, self.straight);
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
    fn visited(&mut self, filler: u32, visit: &mut impl FnMut(&Self)) {
        self.end(filler);
        visit(self);
        self.count = 0;
    }
}

/// Visits all grains.
#[expect(clippy::cast_possible_truncation, reason = "setup refuses more than MOST_GRAINS")]
fn everyone(grains: usize, filler: u32, visit: &mut impl FnMut(&Crowd)) {
    for first in (0..grains).step_by(CROWD) {
        let mut crowd = Crowd::new(filler, false);
        crowd.grains = core::array::from_fn(|i| (first + i) as u32);
        crowd.count = CROWD.min(grains - first);
        crowd.visited(filler, visit);
    }
}
