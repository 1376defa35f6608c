//! How far do grains get? Reads their positions now and then; writes the coefficient of self-diffusion.

/// Positions in a periodic box at equal intervals, put together to paths.
#[derive(Clone, Debug)]
pub struct Tracks {
    edge: f64,
    /// Where each grain is, not wrapped.
    now: Vec<[f64; 3]>,
    kept: Vec<Vec<[f64; 3]>>,
}

impl Tracks {
    /// Begins here.
    pub fn new(edge: f64, start: Vec<[f64; 3]>) -> Self {
        Self { edge, now: start, kept: Vec::new() }
    }

    /// Follows the grains to where they are now; none may have flown half the box since.
    pub fn follow(&mut self, positions: impl IntoIterator<Item = [f64; 3]>) {
        for (at, new) in self.now.iter_mut().zip(positions) {
            for (x, new) in at.iter_mut().zip(new) {
                let step = new - *x;
                *x += step - self.edge * (step / self.edge).round();
            }
        }
    }

    /// Keeps where the grains are.
    pub fn keep(&mut self) {
        self.kept.push(self.now.clone());
    }

    /// The mean square displacement over so many of the intervals, over all grains and beginnings.
    pub fn spread(&self, intervals: usize) -> f64 {
        let pairs = self.kept.iter().zip(self.kept.iter().skip(intervals));
        let square = |(a, b): (&[f64; 3], &[f64; 3])| {
            (0..3).map(|axis| (b[axis] - a[axis]).powi(2)).sum::<f64>()
        };
        let of = |(early, late): (&Vec<[f64; 3]>, &Vec<[f64; 3]>)| {
            early.iter().zip(late).map(square).sum::<f64>()
        };
        let beginnings = self.kept.len().saturating_sub(intervals).max(1);
        pairs.map(of).sum::<f64>() / (beginnings * self.now.len()) as f64
    }

    /// The coefficient of self-diffusion from how the spread grows between two ages, in intervals of
    /// this length: Einstein's relation after the memory of the velocities is gone.
    pub fn diffusion(&self, [young, old]: [usize; 2], interval: f64) -> f64 {
        (self.spread(old) - self.spread(young)) / (6.0 * (old - young) as f64 * interval)
    }
}

#[cfg(test)]
mod tests {
    use super::Tracks;

    /// Two grains that fly apart at speed 1 through a box of 2, looked at every 0.25.
    #[test]
    fn paths_go_on_through_the_faces_of_the_box() {
        let mut tracks = Tracks::new(2.0, vec![[0.0; 3]; 2]);
        for k in 0..40 {
            let x = 0.25 * f64::from(k);
            let wrapped = |x: f64| x - 2.0 * (x / 2.0).round();
            tracks.follow([[wrapped(x), 0.0, 0.0], [wrapped(-x), 0.0, 0.0]]);
            tracks.keep();
        }
        assert!((tracks.spread(8) - 4.0).abs() < 1e-12);
        // (8² − 4²) 0.25² = 3 over 6 · 4 · 0.25.
        assert!((tracks.diffusion([4, 8], 0.25) - 0.5).abs() < 1e-12);
    }
}
