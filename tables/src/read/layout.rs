//! What is a table made of? Reads nothing; writes nothing, names the parts: a tree of boxes, with a sparse Chebyshev expansion in each leaf.

use super::coordinates::CoordinateMap;
use super::domain::Domain;

/// The largest number of Chebyshev terms along one axis.
pub(crate) const MAX_TERMS: usize = 16;

/// One bisection of a box: its lower half along `axis` is `low`, its upper half `high`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Branch {
    /// The axis of the unit cube: 0, 1 or 2.
    pub axis: u8,
    /// The next branch, or `!leaf` (bitwise not of the leaf's index) when negative.
    pub low: i16,
    /// The next branch, or `!leaf` (bitwise not of the leaf's index) when negative.
    pub high: i16,
}

/// One box that is not bisected further: where its rows and coefficients start, and how many there are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Leaf {
    /// Index of its first entry in [`TableData::rows`].
    pub first_row: u32,
    /// Index of its first entry in [`TableData::coefficients`].
    pub first_coefficient: u32,
    /// Number of rows of each of the three columns: duration, speed, angle.
    pub rows: [u8; 3],
    /// Largest number of terms along each axis.
    pub terms: [u8; 3],
    /// Whether the third column is the angle in radians itself. It is where the centres may pass
    /// each other; elsewhere the leading behaviour of the angle has been divided out.
    pub direct_angle: bool,
}

/// One row of a sparse expansion: its orders along the first two axes and its number of terms along the third.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// Sixteen times the order along the first axis, plus the order along the second.
    pub orders: u8,
    /// Number of coefficients, for the orders 0, 1, 2, … along the third axis.
    pub terms: u8,
}

/// The data of a table, borrowed from wherever they are; `C` is the stored number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TableData<'a, C> {
    /// The groups for which the table answers.
    pub domain: Domain<C>,
    /// How the groups become coordinates in the unit cube.
    pub coordinates: CoordinateMap<C>,
    /// Bisections of the unit cube, the first one at the root; empty when there is one leaf.
    pub branches: &'a [Branch],
    /// The boxes that are left.
    pub leaves: &'a [Leaf],
    /// Rows of the sparse expansions.
    pub rows: &'a [Row],
    /// Chebyshev coefficients.
    pub coefficients: &'a [C],
}

#[cfg(feature = "generate")]
impl<C> TableData<'_, C> {
    /// Size in bytes of branches, leaves, rows and coefficients.
    pub(crate) fn bytes(&self) -> usize {
        size_of_val(self.branches)
            + size_of_val(self.leaves)
            + size_of_val(self.rows)
            + size_of_val(self.coefficients)
    }
}
