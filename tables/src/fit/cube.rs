//! What is a box of the unit cube, and where is it tested? Reads local coordinates; writes points of the unit cube.

use crate::random::Rng;

/// A box in the unit cube.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cube {
    pub low: [f64; 3],
    pub size: [f64; 3],
}

impl Cube {
    /// The point of the unit cube at local coordinates.
    pub fn at(&self, y: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|a| self.low[a] + self.size[a] * y[a])
    }

    /// The lower or upper half along an axis.
    pub fn half(&self, axis: usize, upper: bool) -> Cube {
        let mut half = *self;
        half.size[axis] *= 0.5;
        if upper {
            half.low[axis] += half.size[axis];
        }
        half
    }

    /// Whether a point of the unit cube lies in this box.
    pub fn contains(&self, y: &[f64; 3]) -> bool {
        (0..3).all(|a| y[a] >= self.low[a] && y[a] < self.low[a] + self.size[a])
    }
}

/// Local coordinates of the `n`-th point at which a box is tested: first its corners, then faces and the inside.
pub(crate) fn test_point(n: usize, rng: &mut Rng) -> [f64; 3] {
    if n < 8 {
        return [0, 1, 2].map(|a| if n >> a & 1 == 1 { 1.0 - 1e-6 } else { 1e-6 });
    }
    let mut y = [0.0; 3];
    for value in &mut y {
        let u = rng.uniform();
        // Often close to an end, where the errors peak.
        *value = match (rng.uniform() * 4.0) as u32 {
            0 => u * u * u,
            1 => 1.0 - u * u * u,
            _ => u,
        };
    }
    if n % 3 == 1 {
        // A face; the outermost ones lie outside the domain, so come from any distance.
        let near = libm::pow(10.0, -1.0 - 5.0 * rng.uniform());
        y[(n / 3) % 3] = if n % 2 == 0 { 1.0 - near } else { near };
    }
    y
}
