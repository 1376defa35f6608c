//! In which list is a grain, where sizes differ? Reads radii and the grid; writes the levels at the start.
//!
//! Cells as wide as the largest grain hold many small ones, all of which would be looked at. So the grid is cut
//! for small grains, and larger ones are listed in levels of wider cells, each of which is a block of the grid's
//! cells (hierarchical grid, Ogarko & Luding, Comput. Phys. Commun. 183, 931, 2012). Every grain, whatever its
//! level, crosses the grid's own cells, and looks from there: so each sees the others where they are at most one
//! cell from where they were when they looked last.

use super::choose_grid::SLACK;
use super::grid::Grid;
use super::sight::Sight;
use crate::particle::Body;
use crate::scalar::Scalar;

/// How many levels there can be.
pub(super) const MAX_LEVELS: usize = 16;

/// Grains of similar size, and the cells in which they are listed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Level<const D: usize> {
    /// The largest radius among them.
    pub largest: f64,
    /// How many cells of the grid are one of these, along each axis. The last one is wider.
    pub group: [u32; D],
    /// How many there are along each axis.
    pub count: [u32; D],
    /// The number of the first one's list.
    pub first: u32,
}

/// All levels, the finest first: its cells are the grid's. None where one grid serves all.
#[derive(Clone, Debug)]
pub(crate) struct Levels<const D: usize> {
    pub(super) all: heapless::Vec<Level<D>, MAX_LEVELS>,
    pub(super) sight: Sight,
}

impl<const D: usize> Levels<D> {
    /// From how far grains see each other.
    pub fn sight(&self) -> Sight {
        self.sight
    }

    /// One grid for all grains.
    pub fn one(sight: Sight) -> Self {
        Self { all: heapless::Vec::new(), sight }
    }

    /// Whether one grid serves all grains.
    #[inline(always)]
    pub fn is_one(&self) -> bool {
        self.all.is_empty()
    }

    /// How many there are, at least one.
    pub fn len(&self) -> usize {
        self.all.len().max(1)
    }

    /// The largest radius of those that are listed in the grid's own cells.
    #[inline]
    pub fn finest<S: Scalar>(&self, largest: S) -> S {
        self.all.first().map_or(largest, |level| S::from_f64(level.largest))
    }

    /// Whether a grain of this radius is listed in the grid's own cells.
    #[inline]
    pub fn is_fine<S: Scalar>(&self, radius: S) -> bool {
        self.all.first().is_none_or(|level| radius.to_f64() <= level.largest)
    }

    /// The list of a grain of this radius in a cell of the grid.
    #[inline]
    pub fn list<S: Scalar>(&self, grid: &Grid<S, D>, cell: u32, radius: S) -> u32 {
        if self.is_fine(radius) { cell } else { self.coarse_list(grid, cell, radius.to_f64()) }
    }

    #[inline(never)]
    fn coarse_list<S: Scalar>(&self, grid: &Grid<S, D>, cell: u32, radius: f64) -> u32 {
        let level = self.all.iter().find(|level| radius <= level.largest);
        let Some(level) = level.or(self.all.last()) else { return cell };
        let (mut list, mut scale) = (level.first, 1);
        let counts = level.group.iter().zip(&level.count);
        for (c, (group, count)) in grid.coordinates(cell).into_iter().zip(counts) {
            list += scale * c.checked_div(*group).unwrap_or(0).min(count - 1);
            scale *= count;
        }
        list
    }

    /// The levels over a grid, in at most `most` lists: none are needed where all grains can see no further than a
    /// cell. None if they do not fit.
    pub fn over<S: Scalar>(
        grid: &Grid<S, D>,
        bodies: &[Body<S, D>],
        sight: Sight,
        most: usize,
    ) -> Option<Self> {
        let grains = || bodies.iter().filter(|body| !body.is_vacant());
        let radii = || grains().map(|body| body.radius.to_f64());
        let largest = radii().fold(0.0, f64::max);
        let axes = grid.axes().iter().filter(|along| along.periodic || along.count > 1);
        let width = axes.fold(f64::INFINITY, |width, along| width.min(along.width.to_f64()));
        let mut levels = Self::one(sight);
        if sight.of(largest, largest) <= width {
            return Some(levels);
        }
        let finest = finest_octave(largest, |radius| sight.of(radius, radius) <= width)?;
        let is_tight = grid.axes().iter().any(|along| {
            let room = along.length.to_f64() * 0.5 - 2.0 * along.width.to_f64();
            along.periodic && sight.of(largest, largest) * SLACK > room
        });
        let volume: f64 =
            grid.axes().iter().map(|l| l.width.to_f64() * f64::from(l.count)).product();
        // Where they are too many with a factor of two from one to the next, it is four, or sixteen.
        for factor in [2.0, 4.0, 16.0, 256.0] {
            levels.all.clear();
            let space = (volume, most);
            if !is_tight && levels.fill(grid, radii, [finest, largest, factor], space) {
                return Some(levels);
            }
        }
        None
    }

    /// The levels from the finest up to the largest radius; false if there are too many.
    fn fill<S: Scalar, I: Iterator<Item = f64>>(
        &mut self,
        grid: &Grid<S, D>,
        radii: impl Fn() -> I,
        [finest, largest, factor]: [f64; 3],
        (volume, most): (f64, usize),
    ) -> bool {
        let (mut below, mut up_to, mut first) = (0.0, finest, 0_usize);
        while below < largest {
            let mut members = radii().filter(|radius| *radius > below && *radius <= up_to);
            if let Some(one) = members.next() {
                let (count, radius) = members.fold((1.0, one), |(n, r), x| (n + 1.0, r.max(x)));
                let width = (2.0 * radius).max(libm::pow(volume / count, 1.0 / D as f64));
                let width = if self.all.is_empty() { 0.0 } else { width };
                let level = Level::new(grid, radius, width, (first, most));
                first = match level.map(|level| (level, self.all.push(level))) {
                    Some((level, Ok(()))) => first + level.cells(),
                    _ => return false,
                };
            }
            (below, up_to) = (up_to, up_to * factor);
        }
        true
    }
}

impl<const D: usize> Level<D> {
    /// Cells of this width or more, with lists from the first on; none if there is not one left.
    fn new<S: Scalar>(
        grid: &Grid<S, D>,
        largest: f64,
        mut width: f64,
        (first, most): (usize, usize),
    ) -> Option<Self> {
        // Twice as wide each time: the grid has fewer than 2³⁰ cells along an axis.
        for _ in 0..32 {
            let group = grid.axes().map(|along| {
                (libm::ceil(width / along.width.to_f64()) as u32).clamp(1, along.count)
            });
            let mut count = group;
            for (count, along) in count.iter_mut().zip(grid.axes()) {
                *count = along.count.checked_div(*count).unwrap_or(1).max(1);
            }
            let first_list = u32::try_from(first).ok()?;
            let level = Self { largest, group, count, first: first_list };
            if level.cells() <= most.saturating_sub(first) {
                return Some(level);
            }
            if count.iter().all(|&count| count == 1) {
                return None;
            }
            width = 2.0 * width.max(grid.axes().iter().fold(0.0, |w, l| l.width.to_f64().max(w)));
        }
        None
    }

    /// How many cells it has.
    pub fn cells(&self) -> usize {
        self.count.iter().fold(1, |n: usize, &count| n.saturating_mul(count as usize))
    }
}

/// The largest radius over a power of two for which this is true.
pub(super) fn finest_octave(largest: f64, is_seen: impl Fn(f64) -> bool) -> Option<f64> {
    let mut octaves = (0..64).map(|n| largest * libm::ldexp(1.0, -n));
    octaves.find(|radius| is_seen(*radius))
}
