//! What is the mean over time, and how well is it known? Reads sums of equal spans of time; writes nothing, keeps the sums of blocks.

use serde::{Deserialize, Serialize};

/// Sums over time, in blocks of equal length.
///
/// When there are [`Blocks::MOST`] of them each two become one, so that there are always enough of them
/// for an error and none is shorter than needed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Blocks {
    /// Spans in a block.
    length: u64,
    /// Spans in the open block.
    filled: u64,
    open: Vec<f64>,
    whole: Vec<Vec<f64>>,
}

/// A mean and its standard error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mean {
    /// The mean.
    pub value: f64,
    /// Its standard error; NaN if there are fewer than two blocks.
    pub error: f64,
}

impl Blocks {
    /// So many blocks become half as many.
    pub const MOST: usize = 64;

    /// No time has passed; there are so many sums.
    pub fn new(width: usize) -> Self {
        Self { length: 1, filled: 0, open: vec![0.0; width], whole: Vec::new() }
    }

    /// The sums of one more span.
    pub fn add(&mut self, sums: &[f64]) {
        self.open.iter_mut().zip(sums).for_each(|(sum, more)| *sum += more);
        self.filled += 1;
        if self.filled < self.length {
            return;
        }
        let empty = vec![0.0; self.open.len()];
        self.whole.push(std::mem::replace(&mut self.open, empty));
        self.filled = 0;
        if self.whole.len() == Self::MOST {
            self.whole = self.whole.chunks(2).map(|pair| added(&pair[0], &pair[1])).collect();
            self.length *= 2;
        }
    }

    /// The blocks that are whole, in the order of time.
    pub fn whole(&self) -> &[Vec<f64>] {
        &self.whole
    }

    /// The sums over all of the time.
    pub fn total(&self) -> Vec<f64> {
        self.whole.iter().fold(self.open.clone(), |sum, block| added(&sum, block))
    }

    /// A quantity that follows from sums: of all of the time, its error from how it differs between blocks.
    ///
    /// Blocks must be longer than what the quantity remembers; where they are not the error is too small.
    pub fn mean(&self, quantity: impl Fn(&[f64]) -> f64) -> Mean {
        let values = self.whole.iter().map(|block| quantity(block));
        let values: Vec<f64> = values.filter(|value| value.is_finite()).collect();
        let count = values.len() as f64;
        let mean = values.iter().sum::<f64>() / count;
        let square: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
        let error = (square / (count * (count - 1.0))).sqrt();
        Mean { value: quantity(&self.total()), error }
    }
}

fn added(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a + b).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 1,000 spans with 3 and 5 in turn: the mean is 4, two spans are a block with nothing to differ in.
    #[test]
    fn blocks_grow_and_lose_nothing() {
        let mut blocks = Blocks::new(2);
        for k in 0..1000 {
            blocks.add(&[1.0, if k % 2 == 0 { 3.0 } else { 5.0 }]);
        }
        assert_eq!(blocks.total(), [1000.0, 4000.0]);
        assert!((32..64).contains(&blocks.whole().len()), "{}", blocks.whole().len());
        assert_eq!(blocks.mean(|s| s[1] / s[0]), Mean { value: 4.0, error: 0.0 });
    }

    /// The standard error of the mean of 1, 2, …, n.
    #[test]
    fn the_error_is_that_of_a_mean() {
        let mut blocks = Blocks::new(1);
        (1..=9).for_each(|k| blocks.add(&[f64::from(k)]));
        let Mean { error, .. } = blocks.mean(|s| s[0]);
        assert!((error - (7.5_f64 / 9.0).sqrt()).abs() < 1e-15);
    }
}
