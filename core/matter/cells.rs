//! Who is near whom? Linked lists of grains in the cells of a grid, in borrowed memory; reads cells, writes lists.

use super::grid::{Grid, NOWHERE};
use crate::number::Scalar;

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

    /// All grains in this cell and its neighbours; all grains if there is no grid.
    pub fn near(&self, cell: u32) -> Near<'_, D> {
        let steps = self.grid.as_ref().map(|grid| grid.steps(cell));
        let cursor = if steps.is_some() { END } else { 0 };
        let steps = steps.unwrap_or([[0; 3]; D]);
        let (heads, links) = (&*self.heads, &*self.links);
        Near {
            gridded: self.grid.is_some(),
            heads,
            links,
            steps,
            digits: [0; D],
            done: false,
            cursor,
        }
    }
}

/// The grains near a cell, one after the other.
pub(crate) struct Near<'a, const D: usize> {
    gridded: bool,
    heads: &'a [u32],
    links: &'a [Link],
    steps: [[u32; 3]; D],
    /// Which neighbour is next: below, the same or above along each axis.
    digits: [u8; D],
    done: bool,
    cursor: u32,
}

impl<const D: usize> Near<'_, D> {
    /// The first grain of the next neighbour; `END` if it is empty or does not exist.
    fn head(&mut self) -> u32 {
        let mut cell = Some(0);
        for (&digit, step) in self.digits.iter().zip(&self.steps) {
            let term = step.get(usize::from(digit)).copied().filter(|&term| term != NOWHERE);
            cell = cell.zip(term).map(|(cell, term): (u32, u32)| cell + term);
        }
        self.done = true;
        for digit in &mut self.digits {
            *digit = (*digit + 1) % 3;
            if *digit != 0 {
                self.done = false;
                break;
            }
        }
        cell.and_then(|c| self.heads.get(c as usize)).map_or(END, |&head| head)
    }
}

impl<const D: usize> Iterator for Near<'_, D> {
    type Item = usize;

    fn next(&mut self) -> Option<usize> {
        if !self.gridded {
            let grain = self.cursor as usize;
            self.cursor += 1;
            return (grain < self.links.len()).then_some(grain);
        }
        while self.cursor == END {
            if self.done {
                return None;
            }
            self.cursor = self.head();
        }
        let grain = self.cursor as usize;
        self.cursor = self.links.get(grain).map_or(END, |link| link.next);
        Some(grain)
    }
}
