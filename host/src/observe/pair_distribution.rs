//! How many others are at a distance from a grain, compared with none of them knowing of each other? Reads grains; writes counts of pairs.

use super::blocks::Blocks;
use super::layout::Layout;
use super::table::{Table, number};
use crate::scenario::{PairSpec, Placed, Side, Start};
use anyhow::{Result, bail};
use std::f64::consts::PI;

/// Distances in equal parts.
///
/// Grains that are nearer to a wall than the largest distance are neighbours only: what is around them
/// is not all there.
#[derive(Clone, Debug, PartialEq)]
pub struct PairDistribution {
    to: f64,
    bins: usize,
    /// One look in so many.
    pub one_in: u64,
    dimension: usize,
    sides: [Side; 3],
    volume: f64,
    names: Vec<String>,
    counts: Vec<f64>,
    pairs: Vec<[usize; 2]>,
    /// Where its sums begin.
    offset: usize,
}

impl PairDistribution {
    /// That of a system, its sums from `offset` on.
    ///
    /// # Errors
    /// When the box has no volume, or is too small for the largest distance.
    pub fn new(spec: &PairSpec, start: &Start, layout: &Layout, offset: usize) -> Result<Self> {
        let widest = start.grains.iter().map(|grain| grain.radius).fold(0.0, f64::max);
        let to = spec.to.unwrap_or(6.0 * widest);
        for (axis, side) in start.sides.iter().enumerate().take(start.dimension) {
            let name = ["x", "y", "z"][axis];
            let Some([low, high]) = side.range() else {
                bail!("observe.pair_distribution: box.{name} is open, must be periodic or walled");
            };
            if !(to > 0.0 && 2.0 * to <= high - low) {
                let most = 0.5 * (high - low);
                bail!(
                    "observe.pair_distribution.to is {to}, must be above 0 and at most {most}, half of box.{name}"
                );
            }
        }
        let species = layout.names.len();
        let pairs = (0..species).flat_map(|b| (0..=b).map(move |a| [a, b])).collect();
        Ok(Self {
            to,
            bins: spec.bins as usize,
            one_in: u64::from(spec.one_in),
            dimension: start.dimension,
            sides: start.sides,
            volume: layout.volume.unwrap_or(f64::NAN),
            names: layout.names.clone(),
            counts: layout.masses.iter().map(|(_, count)| *count as f64).collect(),
            pairs,
            offset,
        })
    }

    /// How many sums there are.
    pub fn width(&self) -> usize {
        self.names.len() + self.bins * self.pairs.len()
    }

    fn place(&self, pair: usize, bin: usize) -> usize {
        self.offset + self.names.len() + pair * self.bins + bin
    }

    /// Adds a state.
    pub fn add(&self, sums: &mut [f64], grains: &[Placed], layout: &Layout) {
        let species = |k: usize| layout.species.get(k).copied().map_or(0, usize::from);
        let inside: Vec<bool> = grains.iter().map(|grain| self.is_inside(grain)).collect();
        for (k, _) in inside.iter().enumerate().filter(|(_, inside)| **inside) {
            sums[self.offset + species(k)] += 1.0;
        }
        let scale = self.bins as f64 / self.to;
        self.for_each_near(grains, |i, k| {
            let seen = f64::from(u8::from(inside[i]) + u8::from(inside[k]));
            let (a, b) = (&grains[i].position, &grains[k].position);
            let square: f64 = (0..self.dimension)
                .map(|axis| self.sides[axis].nearest(a[axis] - b[axis]).powi(2))
                .sum();
            if square < self.to * self.to {
                let bin = ((square.sqrt() * scale) as usize).min(self.bins - 1);
                sums[self.place(layout.pair(species(i), species(k)), bin)] += seen;
            }
        });
    }

    fn is_inside(&self, grain: &Placed) -> bool {
        (0..self.dimension).all(|axis| match self.sides[axis] {
            Side::Walls([from, to], ..) => {
                (from + self.to..=to - self.to).contains(&grain.position[axis])
            }
            _ => true,
        })
    }

    /// Visits all pairs that may be near each other, once each.
    fn for_each_near(&self, grains: &[Placed], mut visit: impl FnMut(usize, usize)) {
        let cells = Cells::new(self.dimension, &self.sides, self.to);
        let Some(cells) = cells else {
            (0..grains.len()).for_each(|i| (0..i).for_each(|k| visit(i, k)));
            return;
        };
        let home: Vec<usize> = grains.iter().map(|grain| cells.of(grain)).collect();
        let mut members: Vec<Vec<u32>> = vec![Vec::new(); cells.count()];
        for (i, &cell) in home.iter().enumerate() {
            for near in cells.around(cell) {
                members[near].iter().for_each(|&k| visit(i, k as usize));
            }
            members[cell].push(i as u32);
        }
    }

    /// g(r), each column followed by its standard error.
    pub fn table(&self, blocks: &Blocks) -> Table {
        let mut heads = vec!["r [m]".to_owned()];
        for [a, b] in &self.pairs {
            let of = match self.names.len() {
                1 => String::new(),
                _ => format!(" ({} - {})", self.names[*a], self.names[*b]),
            };
            heads.extend([format!("g{of}"), format!("g{of} error")]);
        }
        let mut table = Table::new("pair-distribution", 0, heads);
        let width = self.to / self.bins as f64;
        for bin in 0..self.bins {
            let shell = [bin, bin + 1].map(|k| self.ball(k as f64 * width));
            let shell = shell[1] - shell[0];
            let means = (0..self.pairs.len())
                .map(|pair| blocks.mean(|sums| self.value(sums, pair, bin, shell)))
                .flat_map(|mean| [mean.value, mean.error]);
            let middle = (bin as f64 + 0.5) * width;
            table.rows.push(std::iter::once(middle).chain(means).map(number).collect());
        }
        table
    }

    fn value(&self, sums: &[f64], pair: usize, bin: usize, shell: f64) -> f64 {
        let [a, b] = self.pairs[pair];
        let origins = |s: usize| sums[self.offset + s];
        let expected = if a == b {
            origins(a) * (self.counts[a] - 1.0)
        } else {
            origins(a) * self.counts[b] + origins(b) * self.counts[a]
        };
        sums[self.place(pair, bin)] * self.volume / (expected * shell)
    }

    fn ball(&self, radius: f64) -> f64 {
        match self.dimension {
            1 => 2.0 * radius,
            2 => PI * radius * radius,
            _ => 4.0 / 3.0 * PI * radius.powi(3),
        }
    }
}

/// A box in cells that are not narrower than the largest distance.
struct Cells {
    sides: [Side; 3],
    counts: [usize; 3],
}

impl Cells {
    /// None if an axis has fewer than three, or there are very many.
    fn new(dimension: usize, sides: &[Side; 3], width: f64) -> Option<Self> {
        let mut counts = [1; 3];
        for (axis, count) in counts.iter_mut().enumerate().take(dimension) {
            let [from, to] = sides[axis].range()?;
            *count = (((to - from) / width).floor() as usize).min(100);
            if *count < 3 {
                return None;
            }
        }
        Some(Self { sides: *sides, counts })
    }

    fn count(&self) -> usize {
        self.counts.iter().product()
    }

    fn of(&self, grain: &Placed) -> usize {
        (0..3).rev().fold(0, |cell, axis| {
            let count = self.counts[axis];
            let Some([from, to]) = self.sides[axis].range().filter(|_| count > 1) else {
                return cell;
            };
            let part = (grain.position[axis] - from) / (to - from);
            cell * count + ((part * count as f64).max(0.0) as usize).min(count - 1)
        })
    }

    /// The cell and all beside it.
    fn around(&self, cell: usize) -> impl Iterator<Item = usize> + use<> {
        let counts = self.counts;
        let at = [cell % counts[0], cell / counts[0] % counts[1], cell / counts[0] / counts[1]];
        let steps = move |axis: usize| if counts[axis] > 1 { 0..3 } else { 1..2 };
        let beside =
            move |axis: usize, step: usize| (at[axis] + counts[axis] + step - 1) % counts[axis];
        steps(2).flat_map(move |z| {
            steps(1).flat_map(move |y| {
                steps(0).map(move |x| {
                    (beside(2, z) * counts[1] + beside(1, y)) * counts[0] + beside(0, x)
                })
            })
        })
    }
}
