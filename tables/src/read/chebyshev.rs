//! What do the expansions say at a point of the unit cube? Reads branches, leaves, rows and coefficients; writes the three columns.

use super::layout::{Leaf, MAX_TERMS, Row, TableData};
use super::real::Real;
use super::stored::StoredNumber;

/// The three columns at a point of the unit cube; `None` if the parts of the table do not fit together, which a generated one's do.
pub(super) fn evaluate<S: Real, C: StoredNumber>(
    data: &TableData<'_, C>,
    point: [S; 3],
) -> Option<([S; 3], bool)> {
    let (leaf, local) = descend(data, point)?;
    let basis = [
        polynomials(local[0], leaf.terms[0]),
        polynomials(local[1], leaf.terms[1]),
        polynomials(local[2], leaf.terms[2]),
    ];
    let mut rows = data.rows.get(leaf.first_row as usize..)?;
    let mut coefficients: &[C] = data.coefficients.get(leaf.first_coefficient as usize..)?;
    let mut columns = [S::from_f32(0.0); 3];
    for (column, &count) in columns.iter_mut().zip(&leaf.rows) {
        let (mine, others) = rows.split_at_checked(usize::from(count))?;
        rows = others;
        *column = expansion(mine, &mut coefficients, &basis)?;
    }
    Some((columns, leaf.direct_angle))
}

/// Walks to the leaf and to the place in it, each coordinate still in 0..1.
fn descend<'a, S: Real, C>(data: &TableData<'a, C>, mut y: [S; 3]) -> Option<(&'a Leaf, [S; 3])> {
    let (half, one) = (S::from_f32(0.5), S::from_f32(1.0));
    let mut next: i16 = if data.branches.is_empty() { !0 } else { 0 };
    for _ in 0..=data.branches.len() {
        if next < 0 {
            return Some((data.leaves.get(!next as usize)?, y));
        }
        let branch = data.branches.get(next as usize)?;
        let place = y.get_mut(branch.axis as usize)?;
        let above = *place >= half;
        *place = *place + *place - if above { one } else { S::from_f32(0.0) };
        next = if above { branch.high } else { branch.low };
    }
    None
}

/// `T_0 .. T_(terms-1)` of `2 y - 1`.
fn polynomials<S: Real>(y: S, terms: u8) -> [S; MAX_TERMS] {
    let one = S::from_f32(1.0);
    let x = y + y - one;
    let mut t = [one; MAX_TERMS];
    t[1] = x;
    for k in 2..(terms as usize).min(MAX_TERMS) {
        t[k] = (x + x) * t[k - 1] - t[k - 2];
    }
    t
}

/// One sparse tensor expansion: the sum over its rows of `T_i(y0) T_j(y1) sum_k a_ijk T_k(y2)`.
fn expansion<S: Real, C: StoredNumber>(
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
        let (pairs, mut basis) = (line.chunks_exact(2), third.chunks_exact(2));
        let last = pairs.remainder();
        for pair in pairs.zip(&mut basis) {
            if let ([a, b], &[s, t]) = pair {
                value = value + (a.get::<S>() * s + b.get::<S>() * t);
            }
        }
        if let ([a], Some(&[t, _])) = (last, basis.next()) {
            value = value + a.get::<S>() * t;
        }
        let (i, j) = (usize::from(row.orders >> 4), usize::from(row.orders & 15));
        sum = sum + value * (first[i] * second[j]);
    }
    *coefficients = rest;
    Some(sum)
}
