//! Where are grains that grow, how large, and how fast? Reads what is to grow; keeps each grain at its own time, its cell and its next event.

use super::super::clear::Obstacles;
use super::super::nearest::Point;
use super::super::region::Region;
use super::super::side::Placed;
use rand::RngExt;
use rand_distr::StandardNormal;
use rand_pcg::Pcg64;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// What grows.
pub struct Growth<'a> {
    /// Where.
    pub region: Region,
    /// How large they will be.
    pub radii: &'a [f64],
    /// Grains that stay as they are.
    pub others: &'a [Placed],
    /// What stands there; grains come off it.
    pub obstacles: &'a Obstacles,
    /// How large they are at first, as a part of that.
    pub scale: f64,
}

/// A hair more than is asked for, so that rounding is no overlap.
pub(super) const MARGIN: f64 = 1e-9;

/// One grain at its own time.
#[derive(Clone, Copy)]
pub(super) struct Body {
    pub(super) position: [f64; 3],
    pub(super) velocity: [f64; 3],
    /// The radius is `fixed` + `growing` s, with s the scale of the present.
    pub(super) growing: f64,
    pub(super) fixed: f64,
    pub(super) time: f64,
    pub(super) cell: [usize; 3],
    /// How often its way has changed.
    pub(super) changes: u32,
    /// Which prediction is its last one.
    pub(super) prediction: u32,
    pub(super) next: Next,
}

/// What happens next to a grain.
#[derive(Clone, Copy)]
pub(super) enum Next {
    Nothing,
    /// It touches another, seen at this shift, if that has not changed its way.
    Touch {
        other: usize,
        shift: [f64; 3],
        changes: u32,
    },
    /// It touches the lower or the upper end of an axis.
    End {
        axis: usize,
        upper: bool,
    },
    /// It touches a facet of an obstacle.
    Facet(usize),
    /// It enters the next cell.
    Cross {
        axis: usize,
        up: bool,
    },
}

/// A time in the queue: finite, and so in order.
#[derive(Clone, Copy, PartialEq)]
pub(super) struct Due(pub(super) f64);

impl Eq for Due {}

impl PartialOrd for Due {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Due {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}

pub(super) struct Run {
    pub(super) region: Region,
    pub(super) bodies: Vec<Body>,
    /// Grains that move.
    pub(super) moving: usize,
    /// s = `scale` + `rate` t.
    pub(super) scale: f64,
    pub(super) rate: f64,
    pub(super) counts: [usize; 3],
    pub(super) cells: Vec<Vec<u32>>,
    /// The facets of obstacles, and which of them can be touched from each cell; no lists without any.
    pub(super) facets: Vec<Vec<Point>>,
    pub(super) facets_near: Vec<Vec<usize>>,
    pub(super) queue: BinaryHeap<Reverse<(Due, usize, u32)>>,
    pub(super) now: f64,
    pub(super) collisions: usize,
}

impl Run {
    pub(super) fn new(growth: &Growth<'_>, start: &[[f64; 3]], rate: f64, rng: &mut Pcg64) -> Self {
        let region = growth.region;
        let mean = growth.radii.iter().sum::<f64>() / growth.radii.len().max(1) as f64;
        let largest = growth.radii.iter().chain(growth.others.iter().map(|other| &other.radius));
        let width = 2.0 * largest.fold(0.0, |a: f64, b| a.max(*b)) * (1.0 + 2.0 * MARGIN);
        let mut counts = [1; 3];
        for (axis, count) in counts.iter_mut().enumerate().take(region.dimension) {
            // No more than a few cells a grain, however small it is.
            let most = 4 + 2 * start.len();
            *count = ((region.length(axis) / width) as usize).clamp(1, most);
        }
        while counts.iter().product::<usize>() > 64 + 8 * start.len() {
            counts = counts.map(|count| (count / 2).max(1));
        }
        let body = |position: [f64; 3], velocity, growing, fixed| Body {
            position,
            velocity,
            growing,
            fixed,
            time: 0.0,
            cell: [0; 3],
            changes: 0,
            prediction: 0,
            next: Next::Nothing,
        };
        let mut velocity = || {
            let mut velocity = [0.0; 3];
            velocity[..region.dimension].fill_with(|| mean * rng.sample::<f64, _>(StandardNormal));
            velocity
        };
        let grown = start.iter().zip(growth.radii);
        let grown = grown.map(|(place, radius)| body(*place, velocity(), *radius, 0.0));
        let fixed = growth.others.iter().map(|one| body(one.position, [0.0; 3], 0.0, one.radius));
        let mut run = Self {
            region,
            bodies: grown.chain(fixed).collect(),
            moving: start.len(),
            scale: growth.scale,
            rate,
            counts,
            cells: vec![Vec::new(); counts.iter().product()],
            facets: Vec::new(),
            facets_near: Vec::new(),
            queue: BinaryHeap::new(),
            now: 0.0,
            collisions: 0,
        };
        for i in 0..run.bodies.len() {
            run.enter(i);
        }
        run.list_facets(growth.obstacles, 0.5 * width);
        (0..run.moving).for_each(|i| run.predict(i));
        run
    }

    pub(super) fn advance(&mut self, i: usize) {
        let body = &mut self.bodies[i];
        let step = self.now - body.time;
        for (x, v) in body.position.iter_mut().zip(body.velocity) {
            *x += v * step;
        }
        body.time = self.now;
    }

    /// Where a grain is now.
    pub(super) fn place(&self, i: usize) -> [f64; 3] {
        let body = &self.bodies[i];
        let step = self.now - body.time;
        std::array::from_fn(|axis| body.position[axis] + body.velocity[axis] * step)
    }

    pub(super) fn radius(&self, i: usize) -> f64 {
        let body = &self.bodies[i];
        body.fixed + body.growing * (self.scale + self.rate * self.now)
    }

    pub(super) fn number(&self, cell: [usize; 3]) -> usize {
        cell[0] + self.counts[0] * (cell[1] + self.counts[1] * cell[2])
    }

    pub(super) fn enter(&mut self, i: usize) {
        for axis in 0..3 {
            let [low, _] = self.region.axes[axis];
            let part = (self.bodies[i].position[axis] - low) / self.region.length(axis);
            let count = self.counts[axis];
            let cell = if part > 0.0 { (part * count as f64) as usize } else { 0 };
            self.bodies[i].cell[axis] = cell.min(count - 1);
        }
        let number = self.number(self.bodies[i].cell);
        self.cells[number].push(i as u32);
    }
}
