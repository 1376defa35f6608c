//! Who is near whom? Linked lists of grains in the cells of a grid, in borrowed memory; reads cells, writes lists.

use super::grid::{Grid, NOWHERE, Step, Stride};
use crate::number::{Scalar, Vector};

/// The end of a list.
const END: u32 = u32::MAX;

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
        let next = core::mem::replace(head, grain as u32);
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
        match self.links.get_mut(previous as usize) {
            Some(link) => link.next = next,
            None => {
                if let Some(head) = self.heads.get_mut(cell as usize) {
                    *head = next;
                }
            }
        }
    }

    /// Visits all grains in this cell and its neighbours, each with what must be added to separations
    /// from it to get those of the images that are near; all grains, without it, if there is no grid.
    #[inline]
    pub fn near(&self, cell: u32, mut visit: impl FnMut(usize, Option<&Vector<S, D>>)) {
        match &self.grid {
            None => (0..self.links.len()).for_each(|grain| visit(grain, None)),
            Some(grid) => self.within(&grid.steps(&grid.coordinates(cell)), &mut visit),
        }
    }

    /// The same after a grain has come into this cell: only those that were not near before.
    #[inline]
    pub fn ahead(
        &self,
        cell: u32,
        stride: Stride,
        mut visit: impl FnMut(usize, Option<&Vector<S, D>>),
    ) {
        let Some(grid) = &self.grid else { return };
        let mut steps = grid.steps(&grid.coordinates(cell));
        if let Some([below, same, above]) = steps.get_mut(stride.axis) {
            let behind = if stride.up { below } else { above };
            (behind.0, same.0) = (NOWHERE, NOWHERE);
        }
        self.within(&steps, &mut visit);
    }

    /// Visits the grains of the cells that these steps lead to: one of the three along each axis.
    #[inline]
    fn within(
        &self,
        steps: &[[Step<S>; 3]; D],
        visit: &mut impl FnMut(usize, Option<&Vector<S, D>>),
    ) {
        let Some((along, across)) = steps.split_first() else { return };
        let mut digits = [0_usize; D];
        let Some((_, digits)) = digits.split_first_mut() else { return };
        loop {
            let (mut row, mut image) = (0_u32, Vector::<S, D>::zeros());
            for ((step, &digit), x) in
                across.iter().zip(&*digits).zip(image.as_mut_slice().iter_mut().skip(1))
            {
                let &(term, turn) = step.get(digit).unwrap_or(&(NOWHERE, S::zero()));
                // Stays NOWHERE once it is.
                row = row.saturating_add(term);
                *x = turn;
            }
            if row != NOWHERE {
                self.row(row, along, &mut image, visit);
            }
            if !next(digits) {
                return;
            }
        }
    }

    /// Visits the grains of the three cells along the first axis.
    #[inline]
    fn row(
        &self,
        row: u32,
        along: &[Step<S>; 3],
        image: &mut Vector<S, D>,
        visit: &mut impl FnMut(usize, Option<&Vector<S, D>>),
    ) {
        for &(term, turn) in along {
            let cell = row.saturating_add(term) as usize;
            let mut grain = self.heads.get(cell).map_or(END, |&head| head);
            if let Some(x) = image.as_mut_slice().first_mut() {
                *x = turn;
            }
            while grain != END {
                visit(grain as usize, Some(image));
                grain = self.links.get(grain as usize).map_or(END, |link| link.next);
            }
        }
    }
}

/// Counts on, to the base of three; false after the last number.
#[inline]
fn next(digits: &mut [usize]) -> bool {
    for digit in digits {
        *digit += 1;
        if *digit < 3 {
            return true;
        }
        *digit = 0;
    }
    false
}
