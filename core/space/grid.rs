//! Which cell is where? Reads positions and the numbers of cells, writes nothing.
//!
//! Cells are at least as wide as the largest grain's diameter, so only grains in the same or a neighbouring cell
//! can touch (where sizes differ, see `levels`). The outermost cells of an axis that is not periodic reach to infinity, so the grid is
//! right for grains anywhere. A periodic axis needs four cells, so that the nearest image of a
//! neighbour is the one that can touch; where there are fewer, all pairs are neighbours.

use crate::scalar::{Scalar, Vector};

/// For more axes there are no grids.
pub(super) const MAX_AXES: usize = 3;

/// From here on there are no cells: sums of a few such numbers do not overflow.
pub(super) const NOWHERE: u32 = 1 << 28;

/// What the three cells along an axis, below, same and above, add to a cell's number; `NOWHERE` if there is none.
pub(super) type Steps = [u32; 3];

/// The cells around one: a step along each axis leads to each.
pub(super) struct CellBlock {
    pub steps: [Steps; MAX_AXES],
    /// Whether none of them goes round a periodic axis.
    pub same_image: bool,
}

/// The cells along one axis.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct GridAxis<S> {
    pub(super) low: S,
    pub(super) width: S,
    pub(super) count: u32,
    pub(super) periodic: bool,
    /// The length of a periodic axis; else zero.
    pub(super) length: S,
}

/// The cells along all axes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Grid<S: Scalar, const D: usize> {
    axes: Vector<GridAxis<S>, D>,
}

/// A face of a cell, through which a grain crosses into the next: across which axis, and whether upwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct CellFace {
    pub axis: usize,
    pub up: bool,
}

impl CellFace {
    /// As one byte.
    #[expect(clippy::cast_possible_truncation, reason = "there are at most a few axes")]
    pub fn code(self) -> u8 {
        2 * self.axis as u8 + u8::from(self.up)
    }

    /// From one byte.
    pub fn from_code(code: u8) -> Self {
        Self { axis: usize::from(code / 2), up: code % 2 == 1 }
    }
}

impl<S: Scalar, const D: usize> Grid<S, D> {
    /// The grid with cells along these axes.
    pub(super) fn new(axes: [GridAxis<S>; D]) -> Self {
        Self { axes: Vector::from(axes) }
    }

    /// The cells along each axis.
    #[inline]
    pub(super) fn axes(&self) -> &[GridAxis<S>; D] {
        let [axes] = &self.axes.data.0;
        axes
    }

    /// Where the cells begin and end.
    pub(super) fn extent(&self) -> [Vector<S, D>; 2] {
        let low = |axis: usize| self.axes().get(axis).map_or(S::zero(), |along| along.low);
        let long = |along: &GridAxis<S>| along.width * S::from_count(along.count);
        let high = |axis: usize| low(axis) + self.axes().get(axis).map_or(S::zero(), long);
        [Vector::from_fn(|axis, _| low(axis)), Vector::from_fn(|axis, _| high(axis))]
    }

    /// Whether every axis can be counted with: a grid may have been read from a file.
    pub(super) fn is_valid(&self) -> bool {
        let valid = |l: &GridAxis<S>| l.count > 0 && l.count <= 1 << 20 && l.width > S::zero();
        self.axes.as_slice().iter().all(valid) && self.cells() <= NOWHERE as usize
    }

    /// Whether a position lies in a cell, or so near that only rounding can tell.
    pub(crate) fn holds(&self, cell: u32, position: &Vector<S, D>) -> bool {
        let at = self.coordinates(cell);
        (cell as usize) < self.cells()
            && self.axes.as_slice().iter().zip(position.iter()).enumerate().all(
                |(axis, (along, &x))| {
                    let near = -along.width * S::from_f32(1e-3);
                    self.faces(&at, axis, x).into_iter().flatten().all(|gap| gap >= near)
                },
            )
    }

    /// How many cells there are.
    pub(crate) fn cells(&self) -> usize {
        self.axes
            .as_slice()
            .iter()
            .fold(1, |n: usize, along| n.saturating_mul(along.count as usize))
    }

    /// The cell of a position inside the box.
    pub(crate) fn locate(&self, position: &Vector<S, D>) -> u32 {
        let mut at = [0; D];
        for ((c, along), &x) in at.iter_mut().zip(self.axes.as_slice()).zip(position.as_slice()) {
            *c = along.index(x);
        }
        self.number(&at)
    }

    /// A cell's numbers along the axes.
    pub(crate) fn coordinates(&self, mut cell: u32) -> [u32; D] {
        let mut at = [0; D];
        for (c, along) in at.iter_mut().zip(self.axes.as_slice().iter()) {
            // No axis is without cells; said like this no panic is linked for it.
            let above = cell.checked_div(along.count).unwrap_or(0);
            *c = cell - above * along.count;
            cell = above;
        }
        at
    }

    /// The cells around one, itself included.
    #[inline]
    pub(super) fn around(&self, at: &[u32; D]) -> CellBlock {
        let (mut scale, mut same_image) = (1, true);
        let mut steps = [[0, NOWHERE, NOWHERE]; MAX_AXES];
        for ((steps, along), &c) in steps.iter_mut().zip(self.axes.as_slice()).zip(at) {
            let to = |c: Option<u32>| c.map_or(NOWHERE, |c| c * scale);
            *steps = [to(along.below(c)), c * scale, to(along.above(c))];
            same_image &= !along.periodic || (c > 0 && c + 1 < along.count);
            scale *= along.count;
        }
        CellBlock { steps, same_image }
    }

    /// Of the cells around one those that are nearer to a position in it than a reach along each axis.
    #[cfg(not(feature = "alloc"))]
    #[inline]
    pub(super) fn touching(&self, at: &[u32; D], position: &Vector<S, D>, reach: S) -> CellBlock {
        let mut around = self.around(at);
        for (axis, (steps, &x)) in around.steps.iter_mut().zip(position.iter()).enumerate() {
            let [below, _, above] = steps;
            for (gap, step) in self.faces(at, axis, x).into_iter().zip([below, above]) {
                if gap.is_some_and(|gap| gap > reach) {
                    *step = NOWHERE;
                }
            }
        }
        around
    }

    /// Of the cells around one those that a crossing of this face into it has brought near.
    #[inline]
    pub(super) fn ahead(&self, at: &[u32; D], face: CellFace) -> CellBlock {
        let mut around = self.around(at);
        if let Some([below, same, above]) = around.steps.get_mut(face.axis) {
            let next = if face.up { *above } else { *below };
            (*below, *same, *above) = (next, NOWHERE, NOWHERE);
        }
        around.steps.swap(0, face.axis.min(MAX_AXES - 1));
        around
    }

    /// The number of the cell with these coordinates.
    pub(crate) fn number(&self, at: &[u32; D]) -> u32 {
        let (mut number, mut scale) = (0, 1);
        for (&c, along) in at.iter().zip(self.axes.as_slice()) {
            number += c * scale;
            scale *= along.count;
        }
        number
    }

    /// The distances from a position to the lower and upper face of its cell along an axis; none where
    /// the cell reaches to infinity.
    #[inline]
    pub(crate) fn faces(&self, at: &[u32; D], axis: usize, x: S) -> [Option<S>; 2] {
        let (Some(&c), Some(along)) = (at.get(axis), self.axes.as_slice().get(axis)) else {
            return [None, None];
        };
        let face = |c: u32| along.low + along.width * S::from_count(c);
        let low = along.below(c).map(|_| x - face(c));
        let high = along.above(c).map(|_| face(c + 1) - x);
        [low, high]
    }

    /// Where this face of a cell is, and whether there is another cell behind it.
    #[inline]
    pub(crate) fn face_ahead(&self, at: &[u32; D], face: CellFace) -> (S, bool) {
        let [axes] = &self.axes.data.0;
        let (Some(&c), Some(along)) = (at.get(face.axis), axes.get(face.axis)) else {
            return (S::zero(), false);
        };
        let up = u32::from(face.up);
        let number = c + up;
        let last = number == along.count * up;
        (along.low + along.width * S::from_count(number), along.periodic | !last)
    }

    /// The cell behind a face, and by how many box lengths along the axis the position must be moved.
    pub(crate) fn across(&self, cell: u32, face: CellFace) -> Option<(u32, S)> {
        let from = self.coordinates(cell);
        let at = self.beside(&from, face)?;
        let (c, moved) = (from.get(face.axis)?, at.get(face.axis)?);
        let turns = match (face.up, moved) {
            (true, 0) => -S::one(),
            (false, m) if *c == 0 && *m + 1 == self.axes.as_slice().get(face.axis)?.count => {
                S::one()
            }
            _ => S::zero(),
        };
        Some((self.number(&at), turns))
    }

    /// The coordinates of the cell behind a face of that with these.
    #[cfg_attr(feature = "alloc", inline)]
    pub(crate) fn beside(&self, at: &[u32; D], face: CellFace) -> Option<[u32; D]> {
        let mut beside = *at;
        let (c, along) = (beside.get_mut(face.axis)?, self.axes.as_slice().get(face.axis)?);
        *c = along.next(*c, face.up)?;
        Some(beside)
    }
}

impl<S: Scalar> GridAxis<S> {
    fn index(&self, x: S) -> u32 {
        ((x - self.low) / self.width).to_count().min(self.count - 1)
    }

    /// The cell beside one.
    fn next(&self, c: u32, up: bool) -> Option<u32> {
        if up { self.above(c) } else { self.below(c) }
    }

    fn below(&self, c: u32) -> Option<u32> {
        if c > 0 { Some(c - 1) } else { self.periodic.then(|| self.count - 1) }
    }

    fn above(&self, c: u32) -> Option<u32> {
        if c + 1 < self.count { Some(c + 1) } else { self.periodic.then_some(0) }
    }
}
