//! How far do grains get, and how long do they remember how they moved? Reads grains at equal times apart; writes sums over them for each time apart.

use super::blocks::Blocks;
use super::table::{Table, number};
use crate::scenario::{CorrelationSpec, Placed, Side, Start};
use serde::{Deserialize, Serialize};

/// Times apart, in equal steps.
#[derive(Clone, Debug, PartialEq)]
pub struct Correlations {
    /// Looks from one time apart to the next.
    stride: u64,
    points: usize,
    /// Time between two looks (s).
    every: f64,
    sides: [Side; 3],
    /// Along which axes: of a sheared box those across the flow.
    axes: Vec<usize>,
    /// The grains that are followed.
    followed: Vec<usize>,
    /// Where its sums begin.
    offset: usize,
}

/// The ways of the grains that are followed, since the first look.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Ways {
    looks: u64,
    last: Vec<[f64; 3]>,
    way: Vec<[f64; 3]>,
    origins: Vec<Origin>,
    /// Times that a grain went so far between two looks that it may have been round the box.
    pub unclear: u64,
}

/// Where they were once, and how they moved.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Origin {
    look: u64,
    way: Vec<[f64; 3]>,
    velocity: Vec<[f64; 3]>,
}

/// Origins at a time.
const ORIGINS: u64 = 8;

/// How often, way squared, velocity by velocity.
const SUMS: usize = 3;

impl Correlations {
    /// Those of a system that is looked at so often, their sums from `offset` on.
    pub fn new(spec: &CorrelationSpec, start: &Start, every: f64, offset: usize) -> Self {
        let looks = (spec.to / every).round().max(1.0);
        let stride = (looks / f64::from(spec.points)).round().max(1.0) as u64;
        let points = (looks as u64 / stride).max(1) as usize;
        let (count, most) = (start.grains.len(), spec.grains as usize);
        let followed = (0..count.min(most)).map(|k| k * count / count.min(most)).collect();
        let is_still = |axis: &usize| start.flow.is_none_or(|flow| flow.along != *axis);
        let axes = (0..start.dimension).filter(is_still).collect();
        Self { stride, points, every, sides: start.sides, axes, followed, offset }
    }

    /// How many sums there are.
    pub fn width(&self) -> usize {
        SUMS * (self.points + 1)
    }

    fn place(&self, point: usize) -> usize {
        self.offset + SUMS * point
    }

    /// Adds a state: it is compared with those before, and may be one that later ones are compared with.
    pub fn add(&self, sums: &mut [f64], ways: &mut Ways, grains: &[Placed]) {
        self.follow(ways, grains);
        let longest = self.stride * self.points as u64;
        ways.origins.retain(|origin| ways.looks - origin.look <= longest);
        if ways.looks.is_multiple_of((longest / ORIGINS).max(self.stride)) {
            let velocity = self.followed.iter().map(|&k| grains[k].velocity).collect();
            ways.origins.push(Origin { look: ways.looks, way: ways.way.clone(), velocity });
        }
        for origin in &ways.origins {
            let apart = ways.looks - origin.look;
            if apart.is_multiple_of(self.stride) {
                let place = self.place((apart / self.stride) as usize);
                self.compare(&mut sums[place..place + SUMS], ways, origin, grains);
            }
        }
        ways.looks += 1;
    }

    /// Adds up ways as the shortest there are.
    fn follow(&self, ways: &mut Ways, grains: &[Placed]) {
        if ways.last.is_empty() {
            ways.last = self.followed.iter().map(|&k| grains[k].position).collect();
            ways.way = vec![[0.0; 3]; self.followed.len()];
        }
        for (place, &k) in self.followed.iter().enumerate() {
            let Some(grain) = grains.get(k).filter(|grain| grain.is_there()) else { continue };
            for &axis in &self.axes {
                let step = grain.position[axis] - ways.last[place][axis];
                ways.way[place][axis] += self.sides[axis].nearest(step);
                if let Side::Periodic([from, to]) = self.sides[axis] {
                    let far = grain.velocity[axis].abs() * self.every > 0.5 * (to - from);
                    ways.unclear += u64::from(far);
                }
            }
            ways.last[place] = grain.position;
        }
    }

    fn compare(&self, sums: &mut [f64], ways: &Ways, origin: &Origin, grains: &[Placed]) {
        for (place, &k) in self.followed.iter().enumerate() {
            let Some(grain) = grains.get(k).filter(|grain| grain.is_there()) else { continue };
            let (way, before) = (&ways.way[place], &origin.way[place]);
            sums[0] += 1.0;
            for &axis in &self.axes {
                sums[1] += (way[axis] - before[axis]).powi(2);
                sums[2] += grain.velocity[axis] * origin.velocity[place][axis];
            }
        }
    }

    /// Both functions, each column followed by its standard error; no displacement where it is not clear.
    pub fn table(&self, blocks: &Blocks, ways: &Ways) -> Table {
        let heads = vec![
            "time apart [s]",
            "mean square displacement [m2]",
            "mean square displacement error [m2]",
            "velocity autocorrelation [m2/s2]",
            "velocity autocorrelation error [m2/s2]",
        ];
        let mut table = Table::new("correlations", 0, heads);
        for point in 0..=self.points {
            let place = self.place(point);
            let known = [1.0, if ways.unclear > 0 { f64::NAN } else { 1.0 }, 1.0];
            let mean =
                |what: usize| blocks.mean(|sums| known[what] * sums[place + what] / sums[place]);
            let means = [1, 2].map(mean);
            let cells = means.into_iter().flat_map(|mean| [mean.value, mean.error]);
            let time = self.apart(point);
            table.rows.push(std::iter::once(time).chain(cells).map(number).collect());
        }
        table
    }

    fn apart(&self, point: usize) -> f64 {
        point as f64 * self.stride as f64 * self.every
    }

    /// The coefficient of diffusion: half of the slope of the mean square displacement along an axis, over
    /// the later half of the times apart.
    pub fn diffusion(&self) -> impl Fn(&[f64]) -> f64 + use<> {
        let points = [self.points / 2, self.points];
        let places = points.map(|point| self.place(point));
        let time = self.apart(points[1]) - self.apart(points[0]);
        let d = self.axes.len() as f64;
        move |sums| {
            let [half, whole] = places.map(|place| sums[place + 1] / sums[place]);
            (whole - half) / (2.0 * d * time)
        }
    }
}
