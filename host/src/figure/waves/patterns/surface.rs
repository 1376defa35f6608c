//! Which pattern is on a surface? Reads heights on a square that is periodic; writes the amplitudes of its plane waves.

use std::f64::consts::TAU;

/// Mean heights in the places of a square, row by row.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Surface {
    /// Places along each side.
    pub places: usize,
    /// One for each place.
    pub heights: Vec<f64>,
}

/// A plane wave on a square: how often it fits along each side, and half of its height from trough to crest.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wave {
    /// Wavelengths along x and along y.
    pub numbers: [i32; 2],
    /// In the heights' unit.
    pub amplitude: f64,
}

impl Wave {
    /// The numbers of the wave across it.
    pub fn across(&self) -> [i32; 2] {
        [-self.numbers[1], self.numbers[0]]
    }

    /// Whether it is this one, which may be counted the other way.
    pub fn is(&self, other: &Self) -> bool {
        self.numbers == other.numbers || self.numbers == other.numbers.map(|n| -n)
    }
}

impl Surface {
    /// Mean heights of points [x, y, height], x and y in sides of the square.
    pub fn mean(places: usize, points: impl Iterator<Item = [f64; 3]>) -> Self {
        let mut sums = vec![[0.0_f64; 2]; places * places];
        let place = |x: f64| ((x.rem_euclid(1.0) * places as f64) as usize).min(places - 1);
        for [x, y, height] in points {
            let [sum, count] = &mut sums[place(y) * places + place(x)];
            *sum += height;
            *count += 1.0;
        }
        let heights = sums.into_iter().map(|[sum, count]| sum / count.max(1.0)).collect();
        Self { places, heights }
    }

    /// Adds so much of another surface of as many places.
    pub fn add(&mut self, other: &Self, factor: f64) {
        if self.heights.is_empty() {
            *self = Self { heights: vec![0.0; other.heights.len()], places: other.places };
        }
        for (sum, height) in self.heights.iter_mut().zip(&other.heights) {
            *sum += factor * height;
        }
    }

    /// How much of this wave is on it.
    pub fn wave(&self, numbers: [i32; 2]) -> Wave {
        let mut parts = [0.0; 2];
        for (k, height) in self.heights.iter().enumerate() {
            let [x, y] =
                [k % self.places, k / self.places].map(|at| at as f64 / self.places as f64);
            let phase = TAU * (f64::from(numbers[0]) * x + f64::from(numbers[1]) * y);
            parts[0] += height * libm::cos(phase);
            parts[1] += height * libm::sin(phase);
        }
        let amplitude = 2.0 * libm::hypot(parts[0], parts[1]) / self.heights.len() as f64;
        Wave { numbers, amplitude }
    }

    /// Its waves of at least four places, the highest first; of two that are opposite only one.
    pub fn waves(&self) -> Vec<Wave> {
        let most = (self.places / 4) as i32;
        let half = (-most..=most).flat_map(|m| (0..=most).map(move |n| [m, n]));
        let distinct = half.filter(|[m, n]| *n > 0 || *m > 0);
        let mut waves: Vec<Wave> = distinct.map(|numbers| self.wave(numbers)).collect();
        waves.sort_by(|a, b| b.amplitude.total_cmp(&a.amplitude));
        waves
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_waves_across_each_other_are_found() {
        let height = |x: f64, y: f64| 2.0 * (TAU * 2.0 * x + 0.3).cos() + 0.5 * (TAU * y).sin();
        let places = |k: usize| (k as f64 + 0.5) / 16.0;
        let points = (0..256).map(|k| [places(k % 16), places(k / 16)]);
        let surface = Surface::mean(16, points.map(|[x, y]| [x, y, height(x, y)]));
        let waves = surface.waves();
        assert_eq!([waves[0].numbers, waves[1].numbers], [[2, 0], [0, 1]]);
        assert!((waves[0].amplitude - 2.0).abs() < 1e-12, "{waves:?}");
        assert!((waves[1].amplitude - 0.5).abs() < 1e-12, "{waves:?}");
        assert_eq!(waves[0].across(), [0, 2]);
        let [there, back] = [[1, -2], [-1, 2]].map(|numbers| Wave { numbers, amplitude: 1.0 });
        assert!(there.is(&back) && !there.is(&waves[0]));
        assert!(waves[2].amplitude < 1e-12);
    }
}
