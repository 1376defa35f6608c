//! Which waves are on a surface? Reads heights at equal distances in a periodic box; writes amplitudes and signs.

use std::f64::consts::TAU;

/// A wave on a surface: how often it fits into the box, and its complex amplitude.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mode {
    /// Wavelengths in the box.
    pub number: usize,
    /// Of cosine and sine, in the heights' unit.
    pub parts: [f64; 2],
}

impl Mode {
    /// This mode of a surface.
    pub fn of(heights: &[f64], number: usize) -> Self {
        let scale = 2.0 / heights.len() as f64;
        let mut parts = [0.0; 2];
        for (k, height) in heights.iter().enumerate() {
            let phase = TAU * (number * k) as f64 / heights.len() as f64;
            parts[0] += scale * height * libm::cos(phase);
            parts[1] += scale * height * libm::sin(phase);
        }
        Self { number, parts }
    }

    /// The strongest mode of a surface that is no shorter than four places.
    pub fn strongest(heights: &[f64]) -> Self {
        let all = (1..=heights.len() / 4).map(|number| Self::of(heights, number));
        let flat = Self { number: 0, parts: [0.0; 2] };
        all.fold(flat, |best, mode| if mode.amplitude() > best.amplitude() { mode } else { best })
    }

    /// Half of the height from trough to crest.
    pub fn amplitude(&self) -> f64 {
        libm::hypot(self.parts[0], self.parts[1])
    }

    /// Of two modes of one number: 1 where crests are crests, −1 where they are troughs.
    pub fn correlation(&self, other: &Self) -> f64 {
        let product = self.parts[0] * other.parts[0] + self.parts[1] * other.parts[1];
        product / (self.amplitude() * other.amplitude())
    }
}
