//! Where do grains lie in rows, as a layer or a heap? Reads a region with a floor; writes nothing, returns places from below.

use super::region::Region;

/// A floor and what is above it.
#[derive(Clone, Copy, Debug)]
pub struct Ground {
    /// The axis that leads up.
    pub up: usize,
    /// Where grains may be; only its floor counts along that axis.
    pub region: Region,
    /// The distance of two sites: no grain is wider.
    pub spacing: f64,
}

impl Ground {
    fn across(&self) -> impl Iterator<Item = usize> + use<> {
        let up = self.up;
        (0..self.region.dimension).filter(move |axis| *axis != up)
    }

    /// The sites of a layer, row by row from below: each row lies in the hollows of the one before.
    pub fn layer(self) -> impl Iterator<Item = [f64; 3]> {
        let mut counts = [1usize; 3];
        let mut pitch = [0.0; 3];
        let mut offset = [0.0; 3];
        for axis in self.across() {
            let length = self.region.length(axis);
            counts[axis] = ((length / self.spacing) as usize).max(1);
            pitch[axis] = length / counts[axis] as f64;
            if counts[axis] > 1 || self.region.periodic[axis] {
                offset[axis] = 0.5 * pitch[axis];
            }
        }
        let hollow: f64 = offset.iter().map(|x| x * x).sum();
        let square = self.spacing * self.spacing;
        let height = (square - hollow).max(0.25 * square).sqrt();
        (0..).flat_map(move |row: usize| {
            let is_shifted = row % 2 == 1;
            let row_counts: [usize; 3] = std::array::from_fn(|axis| {
                let between_walls = is_shifted && offset[axis] > 0.0 && !self.region.periodic[axis];
                counts[axis] - usize::from(between_walls)
            });
            let [nx, ny, nz] = row_counts;
            (0..nx * ny * nz).map(move |number| {
                let k = [number % nx, number / nx % ny, number / nx / ny];
                std::array::from_fn(|axis| {
                    let low = self.region.axes[axis][0];
                    if axis == self.up {
                        return low + 0.5 * self.spacing + row as f64 * height;
                    }
                    let shift = if is_shifted { offset[axis] } else { 0.0 };
                    low + (k[axis] as f64 + 0.5) * pitch[axis] + shift
                })
            })
        })
    }

    /// The sites of a heap of so many grains, row by row from below: a triangle in two dimensions, a pyramid
    /// on a square in three, each row one shorter than the one below.
    pub fn pile(self, count: usize, top: [f64; 3]) -> Vec<[f64; 3]> {
        let across: Vec<usize> = self.across().collect();
        let in_row = |side: usize| side.pow(across.len() as u32);
        let holds = |base: usize| (1..=base).map(in_row).sum::<usize>();
        let base = (1..).find(|base| across.is_empty() || holds(*base) >= count).unwrap_or(1);
        let hollow = 0.25 * across.len() as f64;
        let height = self.spacing * (1.0 - hollow).sqrt();
        let row = |number: usize| {
            let (side, axes) = (base.saturating_sub(number).max(1), across.clone());
            (0..in_row(side)).map(move |k| {
                let mut place = top;
                let mut rest = k;
                for &axis in &axes {
                    let step = (rest % side) as f64 - 0.5 * (side - 1) as f64;
                    place[axis] += step * self.spacing;
                    rest /= side;
                }
                let low = self.region.axes[self.up][0];
                place[self.up] = low + 0.5 * self.spacing + number as f64 * height;
                place
            })
        };
        (0..).flat_map(row).take(count).collect()
    }
}
