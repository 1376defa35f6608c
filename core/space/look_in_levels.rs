//! Which lists of which levels hold grains near one? Reads the grid and the levels; writes nothing.

use super::choose_grid::SLACK;
use super::grid::{CellFace, Grid, GridAxis};
use super::levels::{Level, Levels};
use crate::scalar::Scalar;

/// From where a grain looks.
#[derive(Clone, Copy)]
pub(super) struct From<const D: usize> {
    /// The numbers of its cell along the axes.
    pub at: [u32; D],
    pub radius: f64,
    /// The face through which it has just come: where lists are those of the grid's own cells, only what was not
    /// near before is looked at. In a wider cell somebody may have come who was not near then.
    pub through: Option<CellFace>,
}

impl<const D: usize> Levels<D> {
    /// Visits all lists of wider cells near a grain, and those of the grid's own if they are not just those around
    /// its cell; and says of each whether it is the nearest image that is listed.
    pub(super) fn look<S: Scalar>(
        &self,
        grid: &Grid<S, D>,
        from: &From<D>,
        visit: &mut impl FnMut(u32, bool),
    ) {
        let own = self.all.iter().find(|level| from.radius <= level.largest);
        // The same for all of a level: each of two knows of the other if the other knows of it.
        let radius = own.map_or(from.radius, |level| level.largest);
        let is_fine = usize::from(self.is_fine(S::from_f64(from.radius)));
        for (n, level) in self.all.iter().enumerate().skip(is_fine) {
            // Rounding may put a grain beside its cell.
            let reach = self.sight.of(radius, level.largest) * SLACK;
            let axes = core::array::from_fn(|axis| Axis::new(grid, level, from, axis));
            let through = from.through.filter(|_| n == 0);
            Look { axes, reach, level, through }.rows(visit);
        }
    }
}

/// A level's cells along one axis, seen from a cell of the grid.
#[derive(Clone, Copy)]
struct Axis {
    /// The cell of the grid from where one looks.
    at: u32,
    cells: u32,
    /// So many cells of the grid make one of the level; the last is wider.
    group: u32,
    count: u32,
    width: f64,
    periodic: bool,
}

impl Axis {
    fn new<S: Scalar, const D: usize>(
        grid: &Grid<S, D>,
        level: &Level<D>,
        from: &From<D>,
        axis: usize,
    ) -> Self {
        let of = |numbers: &[u32; D]| numbers.get(axis).copied().unwrap_or(1);
        let along: Option<&GridAxis<S>> = grid.axes().get(axis);
        Self {
            at: of(&from.at),
            cells: along.map_or(1, |along| along.count),
            group: of(&level.group).max(1),
            count: of(&level.count),
            width: along.map_or(1.0, |along| along.width.to_f64()),
            periodic: along.is_some_and(|along| along.periodic),
        }
    }

    /// So many cells of the grid are in reach, or a little less, on each side.
    fn steps(&self, reach: f64) -> u32 {
        ((reach / self.width) as u32).min(1 << 20) + 1
    }

    fn of(&self, cell: u32) -> u32 {
        cell.checked_div(self.group).unwrap_or(0).min(self.count - 1)
    }

    /// The first of the level's cells in reach, and how many there are from it on, round a periodic axis.
    fn span(&self, at: u32, reach: f64) -> (u32, u32) {
        let steps = self.steps(reach);
        if !self.periodic {
            let first = self.of(at.saturating_sub(steps));
            return (first, self.of((at + steps).min(self.cells - 1)) - first + 1);
        }
        if self.is_round(steps) {
            return (0, self.count);
        }
        let wrap = |cell: u32| if cell >= self.cells { cell - self.cells } else { cell };
        let [first, last] = [wrap(at + self.cells - steps), wrap(at + steps)].map(|c| self.of(c));
        let many = if last >= first { last - first } else { last + self.count - first };
        (first, many + 1)
    }

    /// Whether so many steps to both sides may meet behind a periodic axis.
    fn is_round(&self, steps: u32) -> bool {
        self.periodic && 2 * steps + 1 + 2 * self.group > self.cells
    }

    /// Of these those that a crossing into this cell has brought in reach: one, or none; all where both ends meet.
    fn ahead(&self, reach: f64, up: bool) -> (u32, u32) {
        if self.is_round(self.steps(reach)) {
            return (0, self.count);
        }
        let before = match (up, self.at) {
            (true, 0) => self.cells - 1,
            (true, at) => at - 1,
            (false, at) if at + 1 == self.cells => 0,
            (false, at) => at + 1,
        };
        let end = |(first, many): (u32, u32)| {
            if up { self.next(first, many - 1) } else { first }
        };
        let [old, new] = [before, self.at].map(|at| self.span(at, reach));
        (end(new), u32::from(end(new) != end(old)))
    }

    /// A cell of the level so many further on, round the axis.
    fn next(&self, first: u32, further: u32) -> u32 {
        let cell = first + further;
        if cell >= self.count { cell - self.count } else { cell }
    }

    /// The distance of one of the level's cells from the one looked from.
    fn gap(&self, cell: u32) -> f64 {
        let low = cell * self.group;
        let high = if cell + 1 == self.count { self.cells } else { low + self.group } - 1;
        let round = if self.periodic { self.cells } else { 0 };
        let between = match self.at {
            at if at < low => (low - at).min(if round > 0 { at + round - high } else { u32::MAX }),
            at if at > high => (at - high).min(if round > 0 { low + round - at } else { u32::MAX }),
            _ => 1,
        };
        f64::from(between - 1) * self.width
    }

    /// Whether nothing in reach lies round the end of a periodic axis.
    fn is_inside(&self, reach: f64) -> bool {
        let steps = self.steps(reach);
        !self.periodic || self.at >= steps && self.at + steps < self.cells
    }
}

/// A look at one level.
struct Look<'a, const D: usize> {
    axes: [Axis; D],
    reach: f64,
    level: &'a Level<D>,
    through: Option<CellFace>,
}

impl<const D: usize> Look<'_, D> {
    /// Visits the lists of cells in reach, row by row: along the axis that was crossed only the new end of each.
    fn rows(&self, visit: &mut impl FnMut(u32, bool)) {
        let along = self.through.map_or(0, |face| face.axis);
        let same_image = self.axes.iter().all(|axis| axis.is_inside(self.reach));
        let mut spans = self.axes.map(|axis| axis.span(axis.at, self.reach));
        if let Some(row) = spans.get_mut(along) {
            *row = (0, 1);
        }
        let rows = spans.iter().fold(1_u32, |rows, (_, many)| rows.saturating_mul(*many));
        // Of few rows none is worth a root; but what is new is so against what was in reach, to the cell.
        let is_ball = rows > 9 || self.through.is_some();
        for number in 0..rows {
            let (list, gap2) = self.row(number, &spans, along);
            let rest = self.reach * self.reach - gap2;
            if rest >= 0.0 {
                let reach = if is_ball { libm::sqrt(rest) } else { self.reach };
                self.visit_row(along, (list, reach), |list| visit(list, same_image));
            }
        }
    }

    /// The list at a row's beginning, and the square of the row's distance.
    fn row(&self, mut number: u32, spans: &[(u32, u32); D], along: usize) -> (u32, f64) {
        let (mut list, mut gap2, mut scale) = (self.level.first, 0.0, 1);
        for (n, (axis, (first, many))) in self.axes.iter().zip(spans).enumerate() {
            if n != along {
                let above = number.checked_div(*many).unwrap_or(0);
                let cell = axis.next(*first, number - above * many);
                let gap = axis.gap(cell);
                (list, gap2, number) = (list + scale * cell, gap2 + gap * gap, above);
            }
            scale *= axis.count;
        }
        (list, gap2)
    }

    fn visit_row(&self, along: usize, (list, reach): (u32, f64), mut visit: impl FnMut(u32)) {
        let Some(axis) = self.axes.get(along) else { return };
        let scale: u32 = self.axes.iter().take(along).map(|axis| axis.count).product();
        let (first, many) = match self.through {
            Some(face) => axis.ahead(reach, face.up),
            None => axis.span(axis.at, reach),
        };
        for further in 0..many {
            visit(list + scale * axis.next(first, further));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::space::sight::Sight;
    use std::collections::BTreeSet;
    use std::vec::Vec;

    /// A grid of these many cells of width one, periodic or open along each axis, and levels of wider cells.
    fn cells(counts: [u32; 2], periodic: [bool; 2], groups: &[u32]) -> (Grid<f64, 2>, Levels<2>) {
        let axis = |axis: usize| {
            let (count, periodic) = (counts[axis], periodic[axis]);
            let length = if periodic { f64::from(count) } else { 0.0 };
            GridAxis { low: 0.0, width: 1.0, count, periodic, length }
        };
        let mut levels = Levels::one(Sight { may_crowd: false });
        let mut first = 0;
        for &group in [1].iter().chain(groups) {
            let group = counts.map(|count| group.min(count));
            let count = [0, 1].map(|axis| (counts[axis] / group[axis]).max(1));
            let largest = 0.45 * f64::from(group[0].max(group[1]));
            let _ = levels.all.push(Level { largest, group, count, first });
            first += count[0] * count[1];
        }
        (Grid::new([axis(0), axis(1)]), levels)
    }

    /// How far two cells of width one are from each other along an axis, the shorter way round.
    fn gap(a: u32, b: u32, round: Option<u32>) -> f64 {
        let apart = a.abs_diff(b);
        f64::from(round.map_or(apart, |n| apart.min(n - apart)).saturating_sub(1))
    }

    /// All lists that a grain sees.
    fn seen(grid: &Grid<f64, 2>, levels: &Levels<2>, from: &From<2>) -> BTreeSet<u32> {
        let mut seen = BTreeSet::new();
        levels.look(grid, from, &mut |list, _| {
            assert!(seen.insert(list), "{list} twice");
        });
        seen
    }

    proptest::proptest! {
        /// Whoever is in reach of a cell is listed where one looks; and after a crossing where one looks then, or
        /// has looked before.
        #[test]
        fn nobody_in_reach_is_overlooked(
            counts in proptest::array::uniform2(4_u32..40),
            periodic in proptest::array::uniform2(proptest::bool::ANY),
            groups in proptest::collection::vec(2_u32..9, 1..3),
            (at, radius) in (proptest::array::uniform2(0_u32..1000), 0.1..4.0_f64),
            (axis, up) in (0_usize..2, proptest::bool::ANY),
        ) {
            let mut groups = groups;
            groups.sort_unstable();
            groups.dedup();
            let (grid, levels) = cells(counts, periodic, &groups);
            let at = [at[0] % counts[0], at[1] % counts[1]];
            let radius = radius.min(levels.all.last().unwrap().largest);
            let from = From { at, radius, through: None };
            let own = usize::from(levels.is_fine(radius));
            let in_reach = |at: [u32; 2]| {
                let mut lists = BTreeSet::new();
                for level in &levels.all[own..] {
                    for cell in 0..counts[0] * counts[1] {
                        let there = grid.coordinates(cell);
                        let gaps: Vec<f64> = (0..2)
                            .map(|a| gap(at[a], there[a], periodic[a].then_some(counts[a])))
                            .collect();
                        if gaps[0].hypot(gaps[1]) <= radius + level.largest {
                            lists.insert(levels.list(&grid, cell, level.largest));
                        }
                    }
                }
                lists
            };
            let now = seen(&grid, &levels, &from);
            proptest::prop_assert!(in_reach(at).is_subset(&now));
            let number = at[0] + counts[0] * at[1];
            if let Some((next, _)) = grid.across(number, CellFace { axis, up }) {
                let at = grid.coordinates(next);
                let ahead = From { at, radius, through: Some(CellFace { axis, up }) };
                let both = &now | &seen(&grid, &levels, &ahead);
                proptest::prop_assert!(in_reach(at).is_subset(&both));
            }
        }
    }
}
