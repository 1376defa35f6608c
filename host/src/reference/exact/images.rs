//! Which periodic images of a grain matter? Reads a separation and how far it may change; writes their shifts.

use super::super::vector::Vector;

/// The shifts s = k L for which |d + travel − s| may come below a reach, on every axis.
#[derive(Debug, Clone)]
pub(super) struct Shifts<const D: usize> {
    low: [i64; D],
    high: [i64; D],
    next: Option<[i64; D]>,
    period: Vector<D>,
}

impl<const D: usize> Shifts<D> {
    /// `travel` is the change of d from now on, reached along a straight line; a period of 0
    /// stands for an axis that does not repeat.
    pub fn new(d: &Vector<D>, travel: &Vector<D>, reach: f64, period: Vector<D>) -> Self {
        let range = |k: usize| {
            if period[k] == 0.0 {
                return [0, 0];
            }
            let (back, ahead) = (travel[k].min(0.0), travel[k].max(0.0));
            let low = (d[k] + back - reach) / period[k];
            let high = (d[k] + ahead + reach) / period[k];
            [low.ceil() as i64, high.floor() as i64]
        };
        let low = std::array::from_fn(|k| range(k)[0]);
        let high = std::array::from_fn(|k| range(k)[1]);
        let any = (0..D).all(|k| low[k] <= high[k]);
        Self { low, high, next: any.then_some(low), period }
    }

    /// Shifts that put the other grain within `reach` of a separation d, axis by axis.
    pub fn near(d: &Vector<D>, reach: f64, period: Vector<D>) -> Self {
        Self::new(d, &[0.0; D], reach, period)
    }
}

impl<const D: usize> Iterator for Shifts<D> {
    type Item = Vector<D>;

    fn next(&mut self) -> Option<Vector<D>> {
        let k = self.next?;
        let mut after = k;
        let turned = (0..D).find(|&axis| {
            after[axis] += 1;
            if after[axis] > self.high[axis] {
                after[axis] = self.low[axis];
                return false;
            }
            true
        });
        self.next = turned.map(|_| after);
        Some(std::array::from_fn(|axis| k[axis] as f64 * self.period[axis]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_image_within_reach_comes_once() {
        let near = |d, reach| Shifts::near(&d, reach, [1.0, 0.0]).collect::<Vec<_>>();
        assert_eq!(near([0.1, 9.0], 0.2), [[0.0, 0.0]]);
        assert_eq!(near([2.9, 0.0], 0.2), [[3.0, 0.0]]);
        assert_eq!(near([0.5, 0.0], 0.2), Vec::<[f64; 2]>::new());
        assert_eq!(near([0.5, 0.0], 0.6), [[0.0, 0.0], [1.0, 0.0]]);
        let all: Vec<_> = Shifts::new(&[0.4, 0.4], &[0.5, -0.5], 0.2, [1.0, 1.0]).collect();
        assert_eq!(all, [[1.0, 0.0]]);
        assert_eq!(Shifts::new(&[0.1, 0.1], &[1.0, 1.0], 0.2, [1.0, 1.0]).count(), 4);
    }
}
