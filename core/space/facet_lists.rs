//! How do obstacles find their cells? Reads facets, writes the lists of those that stand and of each motion once, in borrowed memory.

use super::facet::Facet;
use super::grid::{Grid, GridAxis, MAX_AXES};
use super::rigid_motion::{Listed, RigidMotion};
use crate::particle::Index;
use crate::scalar::{Scalar, Vector, component, norm};

/// What an obstacle's memory is called that is too small.
pub(super) const KNOB: &str = "places for lists of facets (WithObstacles)";

/// Facets that move as one, or stand.
#[derive(Clone, Copy)]
struct Group<'a, S: Scalar, const D: usize> {
    facets: &'a [Facet<S, D>],
    motion: Option<usize>,
}

impl<'a, S: Scalar, const D: usize> Group<'a, S, D> {
    /// Its facets and their numbers.
    fn members(self) -> impl DoubleEndedIterator<Item = (usize, &'a Facet<S, D>)> + Clone {
        let all = self.facets.iter().enumerate();
        all.filter(move |(_, facet)| facet.motion() == self.motion)
    }

    /// The box around them.
    fn extent(self) -> [Vector<S, D>; 2] {
        hull(self.members().map(|(_, facet)| facet.extent()))
    }
}

/// The box around boxes.
pub(super) fn hull<S: Scalar, const D: usize>(
    boxes: impl Iterator<Item = [Vector<S, D>; 2]>,
) -> [Vector<S, D>; 2] {
    let far = Vector::from_element(S::NEVER);
    boxes.fold([far, -far], |[low, high], [from, to]| {
        [low.zip_map(&from, S::min), high.zip_map(&to, S::max)]
    })
}

/// The list of a cell of a group whose lists begin at `first`.
#[inline]
pub(super) fn list(
    lists: &[Index],
    first: usize,
    cell: u32,
) -> impl Iterator<Item = usize> + use<'_> {
    let bound = |cell: usize| lists.get(cell).map_or(0, |place| place.get() as usize);
    let cell = first + cell as usize;
    let list = lists.get(bound(cell)..bound(cell + 1)).unwrap_or_default();
    list.iter().map(|k| k.get() as usize)
}

/// Lists all facets, those that stand first, then those of each motion. The cells of those that stand; none if the places
/// are too few. Who moves is seen from a little further off, so that a grain may go a little before it looks again.
pub(super) fn build<S: Scalar, const D: usize>(
    facets: &[Facet<S, D>],
    (sight, lists): (S, &mut [Index]),
    motions: &mut [RigidMotion<S, D>],
) -> Option<Grid<S, D>> {
    let most = usize::try_from(u32::MAX >> (u32::BITS - Index::BITS)).unwrap_or(usize::MAX);
    let places = lists.len().min(most);
    lists.iter_mut().for_each(|place| *place = Index::ZERO);
    let mut begin = 0;
    let mut of = |motion: Option<usize>, motions_left: usize, sight: S| {
        let group = Group { facets, motion };
        // What is left is shared by the facets that are left.
        let (own, later) = (group.members().count(), facets_from(facets, motion));
        let left = places.checked_sub(begin)?.checked_sub(motions_left.checked_mul(2)? + later)?;
        let share = match later {
            0 => left,
            _ => (left / (own + later) * own).max(own + 2).min(left),
        };
        let grid = choose(group, sight, share)?;
        let first = begin;
        begin = fill(&grid, group, sight, (begin, &mut *lists));
        Some((grid, first))
    };
    let (grid, _) = of(None, motions.len(), sight)?;
    let count = motions.len();
    for (k, motion) in motions.iter_mut().enumerate() {
        let margin = sight * S::half();
        let (grid, first) = of(Some(k), count - k - 1, sight + margin)?;
        motion.lists = Some(Listed { grid, first: u32::try_from(first).ok()?, margin });
    }
    Some(grid)
}

/// How many facets come in groups after this one.
fn facets_from<S: Scalar, const D: usize>(facets: &[Facet<S, D>], after: Option<usize>) -> usize {
    let rank = |motion: Option<usize>| motion.map_or(0, |k| k + 1);
    facets.iter().filter(|facet| rank(facet.motion()) > rank(after)).count()
}

/// The finest grid that fits with its lists; none if not even one cell does.
fn choose<S: Scalar, const D: usize>(
    group: Group<'_, S, D>,
    sight: S,
    places: usize,
) -> Option<Grid<S, D>> {
    let [low, high] = group.extent();
    if group.members().next().is_none() {
        return (places > 1)
            .then(|| with_width(&[Vector::zeros(), Vector::from_element(S::one())], S::one()));
    }
    let reach = Vector::from_element(sight);
    let sides = [low - reach, high + reach];
    let mut width = typical_size(group).max(sight);
    for _ in 0..200 {
        let grid = with_width(&sides, width);
        if grid.cells() < places && used(&grid, group, sight, places) <= places {
            return Some(grid);
        }
        if grid.cells() == 1 {
            return None;
        }
        width *= S::from_f32(1.25);
    }
    None
}

/// How large facets are in the mean.
fn typical_size<S: Scalar, const D: usize>(group: Group<'_, S, D>) -> S {
    let count = group.members().count();
    let part = S::one() / S::from_count(u32::try_from(count).unwrap_or(u32::MAX));
    group.members().fold(S::zero(), |mean, (_, facet)| {
        let [low, high] = facet.extent();
        mean + (high - low).iter().fold(S::zero(), |most, &x| most.max(x)) * part
    })
}

/// Cells about so wide; for more than three axes there is one.
fn with_width<S: Scalar, const D: usize>([low, high]: &[Vector<S, D>; 2], width: S) -> Grid<S, D> {
    let most = if D > MAX_AXES { 1 } else { 1 << 10 };
    Grid::new(core::array::from_fn(|axis| {
        let [low, high] = [low, high].map(|side| component(side, axis));
        let count = ((high - low) / width).to_count().clamp(1, most);
        let width = (high - low) / S::from_count(count);
        GridAxis { low, width, count, periodic: false, length: S::zero() }
    }))
}

/// How many places cells and their lists take; more than `most` is not counted.
fn used<S: Scalar, const D: usize>(
    grid: &Grid<S, D>,
    group: Group<'_, S, D>,
    sight: S,
    most: usize,
) -> usize {
    let mut count = grid.cells() + 1;
    for (_, facet) in group.members() {
        for_each_cell(grid, facet, sight, |_| count += 1);
        if count > most {
            break;
        }
    }
    count
}

/// Lists a group's facets from `begin` on. There is room. Where it ends.
fn fill<S: Scalar, const D: usize>(
    grid: &Grid<S, D>,
    group: Group<'_, S, D>,
    sight: S,
    (begin, lists): (usize, &mut [Index]),
) -> usize {
    let cells = grid.cells();
    let add = |lists: &mut [Index], place: usize, more: u32| {
        let now = lists.get(place).map_or(0, |x| x.get()).wrapping_add(more);
        lists.get_mut(place).into_iter().for_each(|x| *x = Index::new(now));
        now
    };
    for (_, facet) in group.members() {
        for_each_cell(grid, facet, sight, |cell| {
            add(lists, begin + cell as usize, 1);
        });
    }
    // Where each list ends; it is filled from there backwards.
    let mut end = u32::try_from(begin + cells + 1).unwrap_or(0);
    for cell in 0..=cells {
        end = add(lists, begin + cell, end);
    }
    for (k, facet) in group.members().rev() {
        for_each_cell(grid, facet, sight, |cell| {
            let place = add(lists, begin + cell as usize, u32::MAX) as usize;
            let number = Index::new(u32::try_from(k).unwrap_or(0));
            lists.get_mut(place).into_iter().for_each(|x| *x = number);
        });
    }
    end as usize
}

/// Visits the cells of which some position is nearer to a facet than that, and perhaps a few more.
fn for_each_cell<S: Scalar, const D: usize>(
    grid: &Grid<S, D>,
    facet: &Facet<S, D>,
    sight: S,
    mut visit: impl FnMut(u32),
) {
    let [low, high] = facet.extent();
    let reach = Vector::from_element(sight);
    let [from, to] = [low - reach, high + reach].map(|x| grid.coordinates(grid.locate(&x)));
    let half = Vector::<S, D>::from_fn(|axis, _| {
        grid.axes().get(axis).map_or(S::zero(), |along| along.width * S::half())
    });
    let far = norm(&half) * S::from_f32(1.0 + 1.0 / 64.0) + sight;
    let mut at = from;
    loop {
        if facet.nearest(&centre(grid, &at)).distance <= far {
            visit(grid.number(&at));
        }
        // The next of the block of cells, the first axis fastest.
        let mut axis = 0;
        loop {
            let (Some(c), Some(&first), Some(&last)) =
                (at.get_mut(axis), from.get(axis), to.get(axis))
            else {
                return;
            };
            if *c < last {
                *c += 1;
                break;
            }
            *c = first;
            axis += 1;
        }
    }
}

/// The middle of a cell.
fn centre<S: Scalar, const D: usize>(grid: &Grid<S, D>, at: &[u32; D]) -> Vector<S, D> {
    Vector::from_fn(|axis, _| {
        let (along, c) = (grid.axes().get(axis), at.get(axis).copied().unwrap_or(0));
        along.map_or(S::zero(), |along| along.low + along.width * (S::from_count(c) + S::half()))
    })
}
