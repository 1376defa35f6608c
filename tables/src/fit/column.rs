//! Which Chebyshev coefficients does a box need? Reads values at its nodes; writes row lengths and coefficients.

use crate::read::layout::MAX_TERMS;

/// One column of one box: all coefficients, and the length of every row that is kept.
pub(crate) struct Column {
    pub all: Vec<f64>,
    pub lengths: Vec<usize>,
    pub n: [usize; 3],
}

/// The Chebyshev nodes of 0..1.
pub(super) fn nodes(n: usize) -> Vec<f64> {
    (0..n)
        .map(|i| 0.5 + 0.5 * libm::cos(core::f64::consts::PI * (i as f64 + 0.5) / n as f64))
        .collect()
}

impl Column {
    /// Values at the nodes to coefficients, axis by axis.
    pub fn new(mut values: Vec<f64>, n: [usize; 3]) -> Self {
        let strides = [n[1] * n[2], n[2], 1];
        for axis in 0..3 {
            let cosines: Vec<f64> = (0..4 * n[axis])
                .map(|m| libm::cos(core::f64::consts::PI * m as f64 / (2 * n[axis]) as f64))
                .collect();
            for start in 0..values.len() {
                if start / strides[axis] % n[axis] == 0 {
                    line(&mut values, start, strides[axis], n[axis], &cosines);
                }
            }
        }
        Column { all: values, lengths: vec![n[2]; n[0] * n[1]], n }
    }

    /// Keeps, row by row, what is larger than the threshold.
    pub fn cut(&mut self, threshold: f64) {
        for (row, length) in self.lengths.iter_mut().enumerate() {
            let values = &self.all[row * self.n[2]..][..self.n[2]];
            *length = values.iter().rposition(|a| a.abs() > threshold).map_or(0, |k| k + 1);
        }
    }

    /// Number of coefficients that are kept.
    pub fn count(&self) -> usize {
        self.lengths.iter().sum()
    }

    /// How much stands in the high orders along each axis, in units of the threshold.
    pub fn tails(&self, threshold: f64) -> [f64; 3] {
        let n = self.n;
        let mut tails = [0.0; 3];
        for (at, a) in self.all.iter().enumerate() {
            let order = [at / (n[1] * n[2]), at / n[2] % n[1], at % n[2]];
            let weight = (a.abs() / threshold).min(1e3);
            for axis in 0..3 {
                let part = order[axis] as f64 / n[axis] as f64;
                tails[axis] += weight * part * part * part;
            }
        }
        tails
    }

    /// The value of what is kept; `t` holds the Chebyshev polynomials along each axis.
    pub fn value(&self, t: &[[f64; MAX_TERMS]; 3]) -> f64 {
        let mut sum = 0.0;
        for i in 0..self.n[0] {
            for j in 0..self.n[1] {
                let row = i * self.n[1] + j;
                let mut line = 0.0;
                let mut k = 0;
                while k < self.lengths[row] {
                    line += self.all[row * self.n[2] + k] * t[2][k];
                    k += 1;
                }
                sum += line * t[0][i] * t[1][j];
            }
        }
        sum
    }
}

/// One discrete cosine transform along an axis.
fn line(values: &mut [f64], start: usize, stride: usize, n: usize, cosines: &[f64]) {
    let old: Vec<f64> = (0..n).map(|i| values[start + i * stride]).collect();
    for k in 0..n {
        let mut sum = 0.0;
        let mut i = 0;
        while i < n {
            sum += old[i] * cosines[k * (2 * i + 1) % (4 * n)];
            i += 1;
        }
        values[start + k * stride] = sum * if k == 0 { 1.0 } else { 2.0 } / n as f64;
    }
}
