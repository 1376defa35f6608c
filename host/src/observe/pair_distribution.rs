//! How many others are at a distance from a grain, compared with none of them knowing of each other? Reads grains; writes counts of pairs.

use super::blocks::Blocks;
use super::layout::Layout;
use super::table::{Table, number};
use crate::scenario::{Flow, PairSpec, Placed, Side, Start, present};
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
    /// The flow of a sheared box, whose images move.
    flow: Option<Flow>,
    volume: f64,
    names: Vec<String>,
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
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate().take(start.dimension) {
            let Some([low, high]) = start.range(axis) else {
                let is = if start.sides[axis].range().is_some() {
                    "has walls that go on"
                } else {
                    "is open"
                };
                bail!("observe.pair_distribution: box.{name} {is}, must be periodic or walled");
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
            flow: start.flow,
            volume: layout.volume.unwrap_or(f64::NAN),
            names: layout.names.clone(),
            pairs,
            offset,
        })
    }

    /// How many sums there are.
    pub fn width(&self) -> usize {
        (1 + self.bins) * self.pairs.len()
    }

    /// How many pairs there would be in all of the box, each for whoever of the two is inside.
    fn expected(&self, pair: usize) -> usize {
        self.offset + pair
    }

    fn place(&self, pair: usize, bin: usize) -> usize {
        self.offset + self.pairs.len() + pair * self.bins + bin
    }

    fn expect(
        &self,
        sums: &mut [f64],
        grains: &[Placed],
        inside: &[bool],
        species: impl Fn(usize) -> usize,
    ) {
        let mut origins = vec![0.0; self.names.len()];
        let mut counts = origins.clone();
        for (k, _) in present(grains) {
            counts[species(k)] += 1.0;
            origins[species(k)] += f64::from(u8::from(inside[k]));
        }
        for (pair, &[a, b]) in self.pairs.iter().enumerate() {
            sums[self.expected(pair)] += match a == b {
                true => origins[a] * (counts[a] - 1.0),
                false => origins[a] * counts[b] + origins[b] * counts[a],
            };
        }
    }

    /// Adds the state at a time.
    pub fn add(&self, sums: &mut [f64], grains: &[Placed], layout: &Layout, time: f64) {
        let species = |k: usize| layout.species.get(k).copied().map_or(0, usize::from);
        let inside: Vec<bool> = grains.iter().map(|grain| self.is_inside(grain)).collect();
        self.expect(sums, grains, &inside, species);
        let scale = self.bins as f64 / self.to;
        self.for_each_near(grains, |i, k| {
            let seen = f64::from(u8::from(inside[i]) + u8::from(inside[k]));
            let square = self.square([&grains[i], &grains[k]], time);
            if square < self.to * self.to {
                let bin = ((square.sqrt() * scale) as usize).min(self.bins - 1);
                sums[self.place(layout.pair(species(i), species(k)), bin)] += seen;
            }
        });
    }

    /// The distance of two, squared, in the images that are the nearest.
    fn square(&self, [a, b]: [&Placed; 2], time: f64) -> f64 {
        let mut apart: [f64; 3] = std::array::from_fn(|axis| a.position[axis] - b.position[axis]);
        if let Some(flow) = &self.flow {
            apart[flow.along] -= flow.carried(&self.sides, apart[flow.gradient], time);
        }
        (0..self.dimension).map(|axis| self.sides[axis].nearest(apart[axis]).powi(2)).sum()
    }

    fn is_inside(&self, grain: &Placed) -> bool {
        let is_inside = |axis: usize| match self.sides[axis] {
            Side::Walls([from, to], ..) => {
                (from + self.to..=to - self.to).contains(&grain.position[axis])
            }
            _ => true,
        };
        grain.is_there() && (0..self.dimension).all(is_inside)
    }

    /// Visits all pairs that may be near each other, once each.
    fn for_each_near(&self, grains: &[Placed], mut visit: impl FnMut(usize, usize)) {
        let cells = Cells::new(self.dimension, &self.sides, self.flow, self.to);
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
        let expected = sums[self.expected(pair)];
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
    flow: Option<Flow>,
    counts: [usize; 3],
}

impl Cells {
    /// None if an axis has fewer than three, or there are very many.
    fn new(dimension: usize, sides: &[Side; 3], flow: Option<Flow>, width: f64) -> Option<Self> {
        let mut counts = [1; 3];
        for (axis, count) in counts.iter_mut().enumerate().take(dimension) {
            let [from, to] = sides[axis].range()?;
            *count = (((to - from) / width).floor() as usize).min(100);
            if *count < 3 {
                return None;
            }
        }
        Some(Self { sides: *sides, flow, counts })
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

    /// The cell and all beside it; across a sheared face all that may have come there.
    fn around(&self, cell: usize) -> impl Iterator<Item = usize> + use<> {
        let (counts, flow) = (self.counts, self.flow);
        let at = [cell % counts[0], cell / counts[0] % counts[1], cell / counts[0] / counts[1]];
        let steps = move |axis: usize| if counts[axis] > 1 { 0..3 } else { 1..2 };
        let all = steps(2)
            .flat_map(move |z| steps(1).flat_map(move |y| steps(0).map(move |x| [x, y, z])));
        all.flat_map(move |step| {
            let beside: [usize; 3] = std::array::from_fn(|axis| {
                (at[axis] + counts[axis] + step[axis] - 1) % counts[axis]
            });
            let row = flow.and_then(|flow| {
                let (from, to) = (at[flow.gradient] + step[flow.gradient], counts[flow.gradient]);
                (from == 0 || from > to).then_some(flow.along)
            });
            // A row is gone through once, whichever of its cells stands beside.
            let range = match row {
                Some(along) if step[along] == 1 => 0..counts[along],
                Some(_) => 0..0,
                None => 0..1,
            };
            range.map(move |place| {
                let mut beside = beside;
                if let Some(along) = row {
                    beside[along] = place;
                }
                (beside[2] * counts[1] + beside[1]) * counts[0] + beside[0]
            })
        })
    }
}
