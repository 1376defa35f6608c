//! Who is near whom? Reads positions and a box; writes the list of pairs and walls within reach.

use std::ops::Range;

use crate::plate::Plate;
use crate::system::Boundary;
use crate::vector::{Vector, dot, minus};

/// Two grains that may come to touch while the list is valid; `other` is seen at its position
/// plus `shift`, which stands for its periodic image.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct NearPair<const D: usize> {
    pub grain: u32,
    pub other: u32,
    /// R1 + R2.
    pub contact_distance: f64,
    #[cfg_attr(feature = "serde", serde(with = "crate::saved::array"))]
    pub shift: Vector<D>,
}

/// A grain that may come to touch a wall while the list is valid.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct NearWall {
    pub grain: u32,
    pub axis: usize,
    pub facing: f64,
    pub plate: Plate,
}

/// Everything within reach plus skin, in the order of the grains.
#[derive(Debug, Clone, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Neighbours<const D: usize> {
    pub pairs: Vec<NearPair<D>>,
    pub walls: Vec<NearWall>,
    /// Made anew with each list.
    #[cfg_attr(feature = "serde", serde(skip))]
    grid: Grid<D>,
}

/// Cells at least as wide as the cutoff, on each axis from `low`; grains sorted by cell.
#[derive(Debug, Clone)]
struct Grid<const D: usize> {
    low: Vector<D>,
    width: Vector<D>,
    count: [i64; D],
    period: Vector<D>,
    /// Where each cell's grains begin in `sorted`.
    begin: Vec<u32>,
    sorted: Vec<u32>,
    /// Positions in the order of `sorted`.
    at: Vec<Vector<D>>,
    /// Each grain's cell, axis by axis.
    place_of: Vec<[u32; D]>,
    runs: [Vec<Vec<Run>>; D],
}

/// Cells side by side on an axis, all in the image at `shift`.
#[derive(Debug, Clone, Copy)]
struct Run {
    first: usize,
    cells: usize,
    shift: f64,
}

impl<const D: usize> Default for Grid<D> {
    fn default() -> Self {
        Self {
            low: [0.0; D],
            width: [1.0; D],
            count: [1; D],
            period: [0.0; D],
            begin: Vec::new(),
            sorted: Vec::new(),
            at: Vec::new(),
            place_of: Vec::new(),
            runs: std::array::from_fn(|_| Vec::new()),
        }
    }
}

impl<const D: usize> Neighbours<D> {
    /// Lists all pairs whose gap is below `skin`. Positions must be inside the periodic box.
    pub fn rebuild(
        &mut self,
        positions: &[Vector<D>],
        radii: &[f64],
        boundary: &[Boundary; D],
        skin: f64,
    ) {
        let cutoff = 2.0 * radii.iter().fold(0.0_f64, |m, r| m.max(*r)) + skin;
        self.grid.fill(positions, boundary, cutoff);
        self.pairs.clear();
        for (i, position) in positions.iter().enumerate() {
            let from = self.pairs.len();
            self.collect(i, position, radii, cutoff, skin);
            self.pairs[from..].sort_unstable_by_key(|p| p.other);
        }
        self.near_walls(positions, radii, boundary, skin);
    }

    fn collect(&mut self, i: usize, r: &Vector<D>, radii: &[f64], cutoff: f64, skin: f64) {
        let (grid, pairs) = (&self.grid, &mut self.pairs);
        grid.around(&grid.place_of[i], 0, (0, [0.0; D]), &mut |members, shift| {
            let from = minus(r, shift);
            for slot in members {
                let d = minus(&from, &grid.at[slot]);
                let (square, j) = (dot(&d, &d), grid.sorted[slot]);
                if square < cutoff * cutoff && j as usize > i {
                    let contact_distance = radii[i] + radii[j as usize];
                    if square < (contact_distance + skin) * (contact_distance + skin) {
                        pairs.push(NearPair {
                            grain: i as u32,
                            other: j,
                            contact_distance,
                            shift: *shift,
                        });
                    }
                }
            }
        });
    }

    /// A moving plate counts as if it were at its highest.
    fn near_walls(&mut self, r: &[Vector<D>], radii: &[f64], boundary: &[Boundary; D], skin: f64) {
        self.walls.clear();
        for (i, position) in r.iter().enumerate() {
            for (axis, bound) in boundary.iter().enumerate() {
                for (facing, plate) in planes(bound) {
                    let gap = facing * (position[axis] - plate.at) - plate.amplitude;
                    if gap < radii[i] + skin {
                        self.walls.push(NearWall { grain: i as u32, axis, facing, plate });
                    }
                }
            }
        }
    }
}

/// The planes of an axis, facing up (+1) or down (−1).
fn planes(bound: &Boundary) -> impl Iterator<Item = (f64, Plate)> {
    let planes = match *bound {
        Boundary::Walls { lo, hi } => {
            [Some((1.0, Plate::fixed(lo))), Some((-1.0, Plate::fixed(hi)))]
        }
        Boundary::Plate(plate) => [Some((1.0, plate)), None],
        _ => [None, None],
    };
    planes.into_iter().flatten()
}

impl<const D: usize> Grid<D> {
    fn fill(&mut self, positions: &[Vector<D>], boundary: &[Boundary; D], cutoff: f64) {
        self.measure(positions, boundary, cutoff);
        let cells = self.count.iter().product::<i64>() as usize;
        self.begin.clear();
        self.begin.resize(cells + 2, 0);
        self.place_of.clear();
        for r in positions {
            let place = self.places(r);
            let cell = self.cell(&place);
            self.begin[cell + 2] += 1;
            self.place_of.push(place);
        }
        for c in 2..cells + 2 {
            self.begin[c] += self.begin[c - 1];
        }
        self.sorted.resize(positions.len(), 0);
        self.at.resize(positions.len(), [0.0; D]);
        for (i, position) in positions.iter().enumerate() {
            let cell = self.cell(&self.place_of[i]);
            let place = &mut self.begin[cell + 1];
            self.sorted[*place as usize] = i as u32;
            self.at[*place as usize] = *position;
            *place += 1;
        }
    }

    /// Chooses the cells: as wide as the cutoff or wider, and not many more than grains.
    fn measure(&mut self, positions: &[Vector<D>], boundary: &[Boundary; D], cutoff: f64) {
        let most = libm::pow(positions.len() as f64, 1.0 / D as f64).ceil().max(1.0);
        for (axis, bound) in boundary.iter().enumerate() {
            self.period[axis] = bound.period();
            let (low, high) = match *bound {
                Boundary::Periodic { lo, hi } => (lo, hi),
                _ => positions.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), r| {
                    (a.min(r[axis]), b.max(r[axis]))
                }),
            };
            let count = ((high - low) / cutoff).floor().clamp(1.0, most);
            self.low[axis] = low;
            self.count[axis] = count as i64;
            self.width[axis] = ((high - low) / count).max(f64::MIN_POSITIVE);
        }
        self.plan(cutoff);
    }

    fn places(&self, r: &Vector<D>) -> [u32; D] {
        std::array::from_fn(|axis| {
            let place = ((r[axis] - self.low[axis]) / self.width[axis]) as i64;
            place.clamp(0, self.count[axis] - 1) as u32
        })
    }

    fn cell(&self, place: &[u32; D]) -> usize {
        (0..D).fold(0, |cell, axis| cell * self.count[axis] as usize + place[axis] as usize)
    }

    /// For each axis and each place on it, the runs of cells that may hold a grain within the
    /// cutoff. Where the box repeats, a cell past its end means an image; so a box of one or two
    /// cells needs no special case, and each image of a grain comes up exactly once.
    fn plan(&mut self, cutoff: f64) {
        for axis in 0..D {
            let (count, period) = (self.count[axis], self.period[axis]);
            let far = match period > 0.0 {
                true => (cutoff / self.width[axis]).ceil() as i64,
                false => 1.min(count - 1),
            };
            let runs = |place: i64| runs([place - far, place + far], count, period, axis + 1 == D);
            self.runs[axis] = (0..count).map(runs).collect();
        }
    }

    /// Calls `each` with the members and the shift of every run of cells around a place.
    fn around(
        &self,
        place: &[u32; D],
        axis: usize,
        (base, mut shift): (usize, Vector<D>),
        each: &mut dyn FnMut(Range<usize>, &Vector<D>),
    ) {
        for run in &self.runs[axis][place[axis] as usize] {
            shift[axis] = run.shift;
            let cell = base * self.count[axis] as usize + run.first;
            if axis + 1 < D {
                self.around(place, axis + 1, (cell, shift), each);
            } else {
                each(self.begin[cell] as usize..self.begin[cell + run.cells] as usize, &shift);
            }
        }
    }
}

/// The places from..=to on an axis of `count` cells; neighbours of one image in one run if `joined`.
fn runs([from, to]: [i64; 2], count: i64, period: f64, joined: bool) -> Vec<Run> {
    let mut all: Vec<Run> = Vec::new();
    for k in from..=to {
        let (first, image) = (k.rem_euclid(count) as usize, k.div_euclid(count));
        if image != 0 && period == 0.0 {
            continue;
        }
        let shift = image as f64 * period;
        match all.last_mut() {
            Some(run) if joined && run.shift == shift => run.cells += 1,
            _ => all.push(Run { first, cells: 1, shift }),
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All pairs, all images, one by one.
    fn by_hand(r: &[Vector<2>], radius: f64, period: [f64; 2], skin: f64) -> Vec<(u32, u32)> {
        let mut found = Vec::new();
        for i in 0..r.len() {
            for j in i + 1..r.len() {
                for (kx, ky) in (-3..=3).flat_map(|x| (-3..=3).map(move |y| (x, y))) {
                    let shift = [f64::from(kx) * period[0], f64::from(ky) * period[1]];
                    let d = minus(&minus(&r[i], &r[j]), &shift);
                    if (kx == 0 || period[0] > 0.0)
                        && (ky == 0 || period[1] > 0.0)
                        && dot(&d, &d).sqrt() < 2.0 * radius + skin
                    {
                        found.push((i as u32, j as u32));
                    }
                }
            }
        }
        found
    }

    #[test]
    fn small_and_large_boxes_list_every_image_once() {
        let mut seed = 7_u64;
        let mut random = move || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 11) as f64 / (1_u64 << 53) as f64
        };
        for (side, periodic) in
            [0.25, 0.45, 0.7, 1.0, 3.0].into_iter().flat_map(|s| [(s, true), (s, false)])
        {
            let r: Vec<Vector<2>> = (0..30).map(|_| [side * random(), side * random()]).collect();
            let bound = Boundary::Periodic { lo: 0.0, hi: side };
            let other = if periodic { bound } else { Boundary::Open };
            let mut near = Neighbours::default();
            near.rebuild(&r, &[0.1; 30], &[bound, other], 0.07);
            let mut listed: Vec<(u32, u32)> =
                near.pairs.iter().map(|p| (p.grain, p.other)).collect();
            listed.sort_unstable();
            let period = [side, if periodic { side } else { 0.0 }];
            let mut wanted = by_hand(&r, 0.1, period, 0.07);
            wanted.sort_unstable();
            assert_eq!(listed, wanted, "side {side}");
        }
    }
}
