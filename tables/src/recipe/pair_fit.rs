//! Which expansions follow the contacts of one pair? Reads contacts that are integrated; writes coefficients, and the largest error.

use super::error::Error;
use crate::random::Rng;
use crate::read::pair::{PAIR_TERMS, PairCertificate, PairOutcome, PairTable};
use core::f64::consts::PI;

/// What one contact comes to.
pub(super) type Column = PairOutcome<f64>;
type Exact<'a> = &'a dyn Fn([f64; 2]) -> Result<Column, Error>;

/// More pieces than that are not made.
const MOST: usize = 64;
/// Contacts in each piece at which the fit is tried.
const TRIED: usize = 24;

/// The table with as few pieces as the tolerance allows.
pub(super) fn fit(
    certificate: PairCertificate,
    tolerance: f64,
    exact: Exact<'_>,
) -> Result<PairTable<f32>, Error> {
    let [slowest, fastest] = certificate.speeds;
    let time = exact([fastest, 0.0])?.duration;
    let mut pieces = [1_u8, 1];
    loop {
        let (coefficients, tails) = expansions(&certificate, (time, pieces), exact)?;
        let bytes = 4 * coefficients.len();
        let table = PairTable {
            certificate: PairCertificate { bytes, ..certificate },
            pieces,
            time,
            span: (fastest / slowest).ln(),
            coefficients: &*coefficients.leak(),
        };
        let points = TRIED * usize::from(pieces[0]) * usize::from(pieces[1]);
        let worst = largest_error(&table, points, exact)?.into_iter().fold(0.0, f64::max);
        if worst <= tolerance {
            return Ok(table);
        }
        // The axis whose last terms are the larger.
        let axis = usize::from(tails[1] > tails[0]);
        pieces[axis] = pieces[axis].saturating_mul(2);
        if usize::from(pieces[0]) * usize::from(pieces[1]) > MOST {
            let wanted = "larger, or for fewer speeds: it takes more than 64 pieces";
            return Err(Error::field("tolerance", tolerance, wanted));
        }
    }
}

/// The speeds at a place of the table, from 0 to 1 along and across.
fn speeds(c: &PairCertificate, [along, across]: [f64; 2]) -> [f64; 2] {
    let [slowest, fastest] = c.speeds;
    let normal = slowest * (fastest / slowest).powf(along);
    [normal.clamp(slowest, fastest), c.across * across.max(0.0).sqrt()]
}

/// Coefficients of all pieces, and the largest last term along and across.
fn expansions(
    c: &PairCertificate,
    (time, pieces): (f64, [u8; 2]),
    exact: Exact<'_>,
) -> Result<(Vec<f32>, [f64; 2]), Error> {
    let [n, m] = PAIR_TERMS;
    let (mut all, mut tails) = (Vec::new(), [0.0_f64; 2]);
    for i in 0..pieces[0] {
        for k in 0..pieces[1] {
            let mut values = vec![[0.0; 3]; n * m];
            for (at, value) in values.iter_mut().enumerate() {
                let place = |number: u8, pieces: u8, node: usize, nodes: usize| {
                    let x = (PI * (node as f64 + 0.5) / nodes as f64).cos();
                    (f64::from(number) + 0.5 * (x + 1.0)) / f64::from(pieces)
                };
                let along = place(i, pieces[0], at / m, n);
                let across = place(k, pieces[1], at % m, m);
                *value = scaled(c, time, speeds(c, [along, across]), exact)?;
            }
            for column in 0..3 {
                for (at, a) in transformed(&values, column).into_iter().enumerate() {
                    if at / m == n - 1 {
                        tails[0] = tails[0].max(a.abs());
                    }
                    if at % m == m - 1 {
                        tails[1] = tails[1].max(a.abs());
                    }
                    all.push(a as f32);
                }
            }
        }
    }
    Ok((all, tails))
}

/// Duration, restitution and angle as the table has them.
fn scaled(
    c: &PairCertificate,
    time: f64,
    [normal, tangential]: [f64; 2],
    exact: Exact<'_>,
) -> Result<[f64; 3], Error> {
    // Nobody turns without a speed across: as one that turns by next to nothing.
    let tangential = tangential.max(1e-6 * normal);
    let hit = exact([normal, tangential])?;
    let turned = hit.angle * c.contact_distance / tangential;
    Ok([hit.duration / time, hit.restitution, turned / time])
}

/// Chebyshev coefficients of one column from its values at the nodes.
fn transformed(values: &[[f64; 3]], column: usize) -> Vec<f64> {
    let [n, m] = PAIR_TERMS;
    let basis = |order: usize, node: usize, nodes: usize| {
        let whole = if order == 0 { 1.0 } else { 2.0 };
        let angle = PI * order as f64 * (node as f64 + 0.5) / nodes as f64;
        whole / nodes as f64 * angle.cos()
    };
    (0..n * m)
        .map(|at| {
            let sum = |(node, value): (usize, &[f64; 3])| {
                value[column] * basis(at / m, node / m, n) * basis(at % m, node % m, m)
            };
            values.iter().enumerate().map(sum).sum()
        })
        .collect()
}

/// The largest error of what the table says, in `f32` and in `f64`, times 1.5: at corners, edges and random speeds.
pub(super) fn largest_error(
    table: &PairTable<f32>,
    points: usize,
    exact: Exact<'_>,
) -> Result<[f64; 3], Error> {
    let mut rng = Rng::new(31);
    let mut largest = [0.0_f64; 3];
    for n in 0..points.max(4) {
        let place = match n {
            0..4 => [(n % 2) as f64, (n / 2) as f64],
            _ if n % 8 == 0 => [(n / 8 % 2) as f64, rng.uniform()],
            _ if n % 8 == 1 => [rng.uniform(), (n / 8 % 2) as f64],
            _ => [rng.uniform(), rng.uniform()],
        };
        // As `f32` has them, so that both read the same contact.
        let asked = table.clamp(speeds(&table.certificate, place).map(|x| x as f32));
        let truth = exact(asked.map(f64::from))?;
        let single =
            table.read(asked).map(|hit| [hit.duration, hit.restitution, hit.angle].map(f64::from));
        let double = table.read(asked.map(f64::from));
        let double = double.map(|hit| [hit.duration, hit.restitution, hit.angle]);
        for got in [single, double].into_iter().flatten() {
            let off =
                [got[0] / truth.duration - 1.0, got[1] - truth.restitution, got[2] - truth.angle];
            for (most, off) in largest.iter_mut().zip(off) {
                let off = 1.5 * off.abs();
                *most = if off <= *most { *most } else { off };
            }
        }
    }
    Ok(largest)
}
