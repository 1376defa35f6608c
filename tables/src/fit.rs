//! Which sparse expansions hold a contact law? Reads law, end and frame; writes rows and coefficients.

use crate::contact::follow;
use crate::form::{Frame, Leaf};
use crate::law::{End, Law};

/// What a fit is asked for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ask {
    pub law: Law,
    pub end: End,
    pub frame: Frame<f64>,
    pub nodes: [usize; 3],
    pub tolerance: [f64; 3],
}

/// Leaves, row lengths and coefficients in double precision.
#[derive(Clone, Debug, Default)]
pub(crate) struct Fit {
    pub leaves: Vec<Leaf>,
    pub rows: Vec<u8>,
    pub coefficients: Vec<f64>,
}

/// One leaf over the whole unit cube.
pub(crate) fn fit(ask: &Ask) -> Fit {
    let mut columns = sample(ask);
    let mut fit = Fit::default();
    let mut terms = [2_u8; 3];
    for (column, tolerance) in columns.iter_mut().zip(ask.tolerance) {
        transform(column, ask.nodes);
        keep(column, ask.nodes, tolerance, &mut fit, &mut terms);
    }
    fit.leaves.push(Leaf { row: 0, coefficient: 0, terms });
    fit
}

/// The three columns at the Chebyshev nodes.
fn sample(ask: &Ask) -> [Vec<f64>; 3] {
    let mut columns = [const { Vec::new() }; 3];
    for i in 0..ask.nodes[0] {
        for j in 0..ask.nodes[1] {
            for k in 0..ask.nodes[2] {
                let y = [node(i, ask.nodes[0]), node(j, ask.nodes[1]), node(k, ask.nodes[2])];
                for (column, value) in columns.iter_mut().zip(target(ask, y)) {
                    column.push(value);
                }
            }
        }
    }
    columns
}

fn node(i: usize, n: usize) -> f64 {
    0.5 + 0.5 * libm::cos(core::f64::consts::PI * (i as f64 + 0.5) / n as f64)
}

/// What the three columns hold at a point of the unit cube.
fn target(ask: &Ask, y: [f64; 3]) -> [f64; 3] {
    let f = &ask.frame;
    let kappa = f.kappa_scale * y[0] / (1.0 - y[0]);
    let eta = y[1] * 2.0 * f.softness * f.softness / (2.0 * f.softness + kappa);
    let third = if f.root { y[2] * y[2] } else { y[2] };
    let c_dis = f.c_dis * third / (1.0 + f.bend * kappa * (1.0 - third));
    let done = follow(ask.law, ask.end, kappa, eta, c_dis);
    let push = 1.0 + kappa;
    [
        done.tau * push,
        (1.0 / done.speed - 1.0) / (c_dis * push),
        (done.sweep / done.tau - 1.0) / eta,
    ]
}

/// Values at the nodes to Chebyshev coefficients, axis by axis.
fn transform(column: &mut [f64], nodes: [usize; 3]) {
    let strides = [nodes[1] * nodes[2], nodes[2], 1];
    for axis in 0..3 {
        let (n, stride) = (nodes[axis], strides[axis]);
        for start in 0..column.len() {
            if (start / stride) % n == 0 {
                line(column, start, stride, n);
            }
        }
    }
}

fn line(column: &mut [f64], start: usize, stride: usize, n: usize) {
    let values: Vec<f64> = (0..n).map(|i| column[start + i * stride]).collect();
    for k in 0..n {
        let angle = core::f64::consts::PI * k as f64 / n as f64;
        let sum: f64 =
            values.iter().enumerate().map(|(i, v)| v * libm::cos(angle * (i as f64 + 0.5))).sum();
        column[start + k * stride] = sum * if k == 0 { 1.0 } else { 2.0 } / n as f64;
    }
}

/// Keeps, row by row, what is larger than the tolerance.
fn keep(column: &[f64], nodes: [usize; 3], tolerance: f64, fit: &mut Fit, terms: &mut [u8; 3]) {
    let length = |i: usize, j: usize| {
        let row = &column[(i * nodes[1] + j) * nodes[2]..][..nodes[2]];
        row.iter().rposition(|a| a.abs() > tolerance).map_or(0, |k| k + 1)
    };
    let planes: Vec<usize> = (0..nodes[0])
        .map(|i| (0..nodes[1]).rposition(|j| length(i, j) > 0).map_or(0, |j| j + 1))
        .collect();
    let first = planes.iter().rposition(|&n| n > 0).map_or(0, |i| i + 1);
    fit.rows.push(first as u8);
    terms[0] = terms[0].max(first as u8);
    for (i, &second) in planes[..first].iter().enumerate() {
        fit.rows.push(second as u8);
        terms[1] = terms[1].max(second as u8);
        for j in 0..second {
            let third = length(i, j);
            fit.rows.push(third as u8);
            terms[2] = terms[2].max(third as u8);
            fit.coefficients.extend(&column[(i * nodes[1] + j) * nodes[2]..][..third]);
        }
    }
}
