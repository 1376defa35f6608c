//! Who is near whom? A grid of cells with linked lists in borrowed memory; reads positions, writes lists.
//!
//! Cells are at least as wide as the largest grain, so only grains in the same or a neighbouring cell
//! can touch. The outermost cells of an axis that is not periodic reach to infinity, so the grid is
//! right for grains anywhere. A periodic axis needs four cells, so that the nearest image of a
//! neighbour is the one that can touch; where there are fewer, all pairs are neighbours.

use super::boundary::Boundary;
use super::grain::Body;
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

/// The cells along one axis.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Lane<S> {
    low: S,
    width: S,
    count: u32,
    periodic: bool,
}

/// The cells along all axes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Grid<S: Scalar, const D: usize> {
    lanes: Vector<Lane<S>, D>,
}

/// A step into a neighbouring cell: which axis, and whether upwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Stride {
    pub axis: usize,
    pub up: bool,
}

impl Stride {
    /// As one word.
    #[expect(clippy::cast_possible_truncation, reason = "there are at most a few axes")]
    pub fn code(self) -> u32 {
        2 * self.axis as u32 + u32::from(self.up)
    }

    /// From one word.
    pub fn from_code(code: u32) -> Self {
        Self { axis: code as usize / 2, up: code % 2 == 1 }
    }
}

impl<S: Scalar, const D: usize> Grid<S, D> {
    /// The grid with about one grain a cell, cells no narrower than `reach`, at most `most` of them;
    /// none if that leaves fewer than four along a periodic axis.
    pub(crate) fn choose(
        boundary: &Boundary<S, D>,
        bodies: &[Body<S, D>],
        reach: S,
        most: usize,
    ) -> Option<Self> {
        let sides: [([S; 2], bool); D] = core::array::from_fn(|axis| {
            (extent(boundary, bodies, axis), boundary.periodic(axis).is_some())
        });
        let volume: f64 = sides.iter().map(|([low, high], _)| (*high - *low).to_f64()).product();
        let dense = libm::pow(volume / bodies.len().max(1) as f64, 1.0 / D as f64);
        let mut width = dense.max(1.001 * reach.to_f64());
        if !(width > 0.0 && width.is_finite()) {
            return None;
        }
        // Each round makes cells an eighth wider; 500 of them span any range of widths.
        for _ in 0..500 {
            let lanes = sides.map(|(side, periodic)| lane(side, periodic, width));
            let cells: f64 = lanes.iter().map(|l: &Lane<S>| f64::from(l.count)).product();
            if lanes.iter().any(|lane| lane.periodic && lane.count < 4) {
                return None;
            }
            if cells <= most as f64 {
                return (cells >= 8.0).then(|| Self { lanes: Vector::from(lanes) });
            }
            width *= 1.125;
        }
        None
    }

    /// Whether every lane can be counted with: a grid may have been read from a file.
    fn is_sound(&self) -> bool {
        let sound = |l: &Lane<S>| l.count > 0 && l.count <= 1 << 20 && l.width > S::zero();
        self.lanes.iter().all(sound)
    }

    /// How many cells there are.
    pub(crate) fn cells(&self) -> usize {
        self.lanes.iter().fold(1, |n: usize, lane| n.saturating_mul(lane.count as usize))
    }

    /// The cell of a position inside the box.
    pub(crate) fn locate(&self, position: &Vector<S, D>) -> u32 {
        let mut cell = 0;
        for (lane, &x) in self.lanes.iter().zip(position.iter()).rev() {
            cell = cell * lane.count + lane.index(x);
        }
        cell
    }

    /// The cells' numbers along the axes.
    fn coordinates(&self, mut cell: u32) -> [u32; D] {
        let mut at = [0; D];
        for (c, lane) in at.iter_mut().zip(self.lanes.iter()) {
            *c = cell % lane.count;
            cell /= lane.count;
        }
        at
    }

    /// The neighbour number `which` (base-three digits −1, 0, 1) of a cell; none beyond an end.
    fn neighbour(&self, at: &[u32; D], mut which: u32) -> Option<u32> {
        let (mut cell, mut scale) = (0, 1);
        for (&c, lane) in at.iter().zip(self.lanes.iter()) {
            let moved = match which % 3 {
                0 => lane.below(c)?,
                1 => c,
                _ => lane.above(c)?,
            };
            which /= 3;
            cell += moved * scale;
            scale *= lane.count;
        }
        Some(cell)
    }

    /// The distances from a position to the lower and upper face of its cell along an axis; none where
    /// the cell reaches to infinity.
    pub(crate) fn faces(&self, cell: u32, axis: usize, x: S) -> [Option<S>; 2] {
        let (at, lane) = (self.coordinates(cell), self.lanes.get(axis));
        let (Some(&c), Some(lane)) = (at.get(axis), lane) else { return [None, None] };
        let face = |c: u32| lane.low + lane.width * S::from_f64(f64::from(c));
        let low = lane.below(c).map(|_| x - face(c));
        let high = lane.above(c).map(|_| face(c + 1) - x);
        [low, high]
    }

    /// The cell after a stride, and by how many box lengths along the axis the position must be moved.
    pub(crate) fn stride(&self, cell: u32, stride: Stride) -> Option<(u32, S)> {
        let mut at = self.coordinates(cell);
        let (c, lane) = (at.get_mut(stride.axis)?, self.lanes.get(stride.axis)?);
        let moved = if stride.up { lane.above(*c)? } else { lane.below(*c)? };
        let turns = match (stride.up, moved) {
            (true, 0) => -S::one(),
            (false, m) if m + 1 == lane.count && *c == 0 => S::one(),
            _ => S::zero(),
        };
        *c = moved;
        Some((self.neighbour(&at, (3_u32.pow(D as u32) - 1) / 2)?, turns))
    }
}

impl<S: Scalar> Lane<S> {
    fn index(&self, x: S) -> u32 {
        let cell = ((x - self.low) / self.width).to_f64();
        // A cast from float saturates, and NaN gives 0.
        (cell as u32).min(self.count - 1)
    }

    fn below(&self, c: u32) -> Option<u32> {
        if c > 0 { Some(c - 1) } else { self.periodic.then(|| self.count - 1) }
    }

    fn above(&self, c: u32) -> Option<u32> {
        if c + 1 < self.count { Some(c + 1) } else { self.periodic.then_some(0) }
    }
}

/// From where to where the grains can be along an axis: the box, or where they are at the start.
fn extent<S: Scalar, const D: usize>(
    boundary: &Boundary<S, D>,
    bodies: &[Body<S, D>],
    axis: usize,
) -> [S; 2] {
    if let Some(p) = boundary.periodic(axis) {
        return [p.low, p.low + p.length];
    }
    let (mut low, mut high) = (S::NEVER, -S::NEVER);
    for body in bodies {
        if let Some(&x) = body.position.get(axis) {
            low = low.smaller(x - body.radius);
            high = high.larger(x + body.radius);
        }
    }
    boundary.between_planes(axis, [low, high])
}

fn lane<S: Scalar>([low, high]: [S; 2], periodic: bool, width: f64) -> Lane<S> {
    let length = (high - low).to_f64();
    let count = ((length / width) as u32).clamp(1, 1 << 20);
    Lane { low, width: S::from_f64(length / f64::from(count)), count, periodic }
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
    pub fn near(&self, cell: u32) -> Near<'_, 'm, S, D> {
        let at = self.grid.as_ref().map_or([0; D], |grid| grid.coordinates(cell));
        Near { cells: self, at, which: 0, cursor: if self.grid.is_some() { END } else { 0 } }
    }
}

/// The grains near a cell, one after the other.
pub(crate) struct Near<'a, 'm, S: Scalar, const D: usize> {
    cells: &'a Cells<'m, S, D>,
    at: [u32; D],
    which: u32,
    cursor: u32,
}

impl<S: Scalar, const D: usize> Iterator for Near<'_, '_, S, D> {
    type Item = usize;

    fn next(&mut self) -> Option<usize> {
        let Some(grid) = &self.cells.grid else {
            let grain = self.cursor as usize;
            self.cursor += 1;
            return (grain < self.cells.links.len()).then_some(grain);
        };
        while self.cursor == END {
            if self.which >= 3_u32.pow(D as u32) {
                return None;
            }
            let cell = grid.neighbour(&self.at, self.which);
            self.which += 1;
            self.cursor = cell.and_then(|c| self.cells.heads.get(c as usize)).map_or(END, |&h| h);
        }
        let grain = self.cursor as usize;
        self.cursor = self.cells.links.get(grain).map_or(END, |link| link.next);
        Some(grain)
    }
}
