//! Which expansions reproduce a contact over time? Reads a law; writes coefficients and their largest error.

use crate::contact::motion;
use crate::read::history::{History, TERMS};
use crate::read::law::Law;
use crate::read::stored::StoredNumber;

/// Terms of the expansions in c_dis.
const ORDERS: usize = 14;

/// The expansions of one law.
pub(crate) struct FittedHistory {
    pub duration: Vec<f64>,
    pub overlap: Vec<f64>,
    pub rate: Vec<f64>,
}

/// Interpolates at the Chebyshev points of phase and c_dis.
pub(crate) fn fit(law: Law, c_dis_max: f64) -> FittedHistory {
    let phases: Vec<f64> = (0..TERMS).rev().map(|k| unit(node(k, TERMS))).collect();
    let mut durations = Vec::new();
    let mut rows = [vec![Vec::new(); TERMS], vec![Vec::new(); TERMS]];
    for k in 0..ORDERS {
        let (duration, states) = motion(law, c_dis_max * unit(node(k, ORDERS)), &phases);
        durations.push(duration);
        for (which, row) in rows.iter_mut().enumerate() {
            let values: Vec<f64> = states.iter().rev().map(|state| state[which]).collect();
            transform(&values).into_iter().zip(row).for_each(|(a, place)| place.push(a));
        }
    }
    let series = |row: &[Vec<f64>]| row.iter().flat_map(|values| transform(values)).collect();
    FittedHistory {
        duration: transform(&durations),
        overlap: series(&rows[0]),
        rate: series(&rows[1]),
    }
}

/// The largest error of overlap, rate and (relative) duration between the points of the fit.
pub(crate) fn largest_error<C: StoredNumber>(history: &History<C>) -> f64 {
    const FINE: u32 = 64;
    let phases: Vec<f64> = (0..=FINE).map(|k| f64::from(k) / f64::from(FINE)).collect();
    let mut worst = 0.0_f64;
    for k in 0..=40_u32 {
        let c_dis = history.c_dis_max * (f64::from(k) / 40.0).powi(2);
        let (duration, states) = motion(history.law, c_dis, &phases);
        let Some(found) = history.at::<f64>(c_dis) else { return f64::INFINITY };
        worst = worst.max((found.duration / duration - 1.0).abs());
        for (&phase, [overlap, rate]) in phases.iter().zip(states) {
            worst = worst.max((found.overlap(phase) - overlap).abs());
            worst = worst.max((found.rate(phase) - rate).abs());
        }
    }
    worst
}

/// The k-th of n Chebyshev points in −1..1.
fn node(k: usize, n: usize) -> f64 {
    libm::cos(core::f64::consts::PI * (k as f64 + 0.5) / n as f64)
}

fn unit(x: f64) -> f64 {
    0.5 * (x + 1.0)
}

/// The coefficients of the polynomial through the values at the Chebyshev points.
fn transform(values: &[f64]) -> Vec<f64> {
    let n = values.len();
    let term = |j: usize| {
        let angle = |k: usize| core::f64::consts::PI * j as f64 * (k as f64 + 0.5) / n as f64;
        let sum: f64 = values.iter().enumerate().map(|(k, v)| v * libm::cos(angle(k))).sum();
        sum * if j == 0 { 1.0 } else { 2.0 } / n as f64
    };
    (0..n).map(term).collect()
}
