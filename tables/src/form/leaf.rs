//! What do the expansions say at a point of the unit cube? Reads branches, leaves, rows and coefficients; writes the three columns.

use super::{Body, Stored};
use crate::number::Real;

/// The largest number of Chebyshev terms along one axis.
pub const MAX_TERMS: usize = 16;

/// One bisection: below one half of `axis` go to `low`, else to `high`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Branch {
    /// 0, 1 or 2.
    pub axis: u8,
    /// Next branch, or `!leaf` when negative.
    pub low: i16,
    /// Next branch, or `!leaf` when negative.
    pub high: i16,
}

/// One piece: where its row lengths and coefficients start, and the terms along each axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Leaf {
    /// First entry in `rows`.
    pub row: u32,
    /// First entry in `coefficients`.
    pub coefficient: u32,
    /// Number of rows of each column.
    pub rows: [u8; 3],
    /// Largest number of terms along each axis.
    pub terms: [u8; 3],
    /// Does the third column hold the angle itself (the pair may pass the centre)?
    pub direct: bool,
}

/// The three columns at a point of the unit cube; `None` only for a table that was tampered with.
pub(super) fn evaluate<S: Real, C: Stored>(
    body: &Body<'_, C>,
    point: [S; 3],
) -> Option<([S; 3], bool)> {
    let (leaf, local) = descend(body, point)?;
    let basis = [
        chebyshev(local[0], leaf.terms[0]),
        chebyshev(local[1], leaf.terms[1]),
        chebyshev(local[2], leaf.terms[2]),
    ];
    let mut rows = body.rows.get(leaf.row as usize..)?;
    let mut coefficients: &[C] = body.coefficients.get(leaf.coefficient as usize..)?;
    let mut columns = [S::from_f32(0.0); 3];
    for (column, &count) in columns.iter_mut().zip(&leaf.rows) {
        let (mine, others) = rows.split_at_checked(usize::from(count))?;
        rows = others;
        *column = expansion(mine, &mut coefficients, &basis)?;
    }
    Some((columns, leaf.direct))
}

/// Walks to the leaf and to the place in it, each coordinate still in 0..1.
fn descend<'a, S: Real, C>(body: &Body<'a, C>, mut y: [S; 3]) -> Option<(&'a Leaf, [S; 3])> {
    let (half, one) = (S::from_f32(0.5), S::from_f32(1.0));
    let mut next: i16 = if body.branches.is_empty() { !0 } else { 0 };
    for _ in 0..=body.branches.len() {
        if next < 0 {
            return Some((body.leaves.get(!next as usize)?, y));
        }
        let branch = body.branches.get(next as usize)?;
        let place = y.get_mut(branch.axis as usize)?;
        let above = *place >= half;
        *place = *place + *place - if above { one } else { S::from_f32(0.0) };
        next = if above { branch.high } else { branch.low };
    }
    None
}

/// `T_0 .. T_(terms-1)` of `2 y - 1`.
fn chebyshev<S: Real>(y: S, terms: u8) -> [S; MAX_TERMS] {
    let one = S::from_f32(1.0);
    let x = y + y - one;
    let mut t = [one; MAX_TERMS];
    t[1] = x;
    for k in 2..(terms as usize).min(MAX_TERMS) {
        t[k] = (x + x) * t[k - 1] - t[k - 2];
    }
    t
}

/// One row of a sparse expansion: its orders along the first two axes and its number of terms along the third.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// Sixteen times the order along the first axis, plus the order along the second.
    pub orders: u8,
    /// Number of coefficients.
    pub terms: u8,
}

/// One sparse tensor expansion: the sum over its rows of `T_i(y0) T_j(y1) sum_k a_ijk T_k(y2)`.
fn expansion<S: Real, C: Stored>(
    rows: &[Row],
    coefficients: &mut &[C],
    [first, second, third]: &[[S; MAX_TERMS]; 3],
) -> Option<S> {
    let zero = S::from_f32(0.0);
    let mut rest: &[C] = coefficients;
    let mut sum = zero;
    for row in rows {
        let (line, others) = rest.split_at_checked(usize::from(row.terms))?;
        rest = others;
        let mut value = zero;
        let (pairs, last) = line.as_chunks::<2>();
        let mut basis = third.as_chunks::<2>().0.iter();
        for (&[a, b], &[s, t]) in pairs.iter().zip(&mut basis) {
            value = value + (a.get::<S>() * s + b.get::<S>() * t);
        }
        if let ([a], Some([t, _])) = (last, basis.next()) {
            value = value + a.get::<S>() * *t;
        }
        let (i, j) = (usize::from(row.orders >> 4), usize::from(row.orders & 15));
        sum = sum + value * (first[i] * second[j]);
    }
    *coefficients = rest;
    Some(sum)
}
