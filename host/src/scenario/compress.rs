//! How densely can grains be packed at random? Reads small grains; writes nothing, returns where they are when grown.
//!
//! Lubachevsky and Stillinger, J. Stat. Phys. 60, 561 (1990): grains fly and collide as hard ones do, while
//! all grow at a constant rate until they are as large as they should be. The engine's own grains do not
//! grow, so this small event-driven loop stands for itself: it knows neither time nor mass nor law.

use super::region::Region;
use super::side::Placed;
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
    /// How large they are at first, as a part of that.
    pub scale: f64,
}

/// The grains jammed when they were this part of what they should be.
#[derive(Clone, Copy, Debug)]
pub struct Jammed(pub f64);

/// Growth of the mean radius, in units of a velocity's standard deviation. Equal spheres that grow as
/// fast as this do not crystallise, and pass 0.62.
const RATES: [f64; 2] = [0.02, 0.004];

/// A hair more than is asked for, so that rounding is no overlap.
const MARGIN: f64 = 1e-9;

/// Collisions a grain after the growth: they come off each other.
const RELAXATION: usize = 10;

/// Collisions a grain after which a grain that still has to grow counts as jammed.
const PATIENCE: f64 = 20_000.0;

/// Lets the grains grow to their size.
///
/// # Errors
/// When they jam before.
pub fn grow(
    growth: &Growth<'_>,
    start: Vec<[f64; 3]>,
    rng: &mut Pcg64,
) -> Result<Vec<[f64; 3]>, Jammed> {
    let mut jammed = Jammed(0.0);
    for rate in RATES {
        let mut run = Run::new(growth, &start, rate, rng);
        match run.grow_up() {
            Ok(()) => {
                run.relax();
                return Ok(run.positions(start.len()));
            }
            Err(found) => jammed = Jammed(jammed.0.max(found.0)),
        }
    }
    Err(jammed)
}

/// One grain at its own time.
#[derive(Clone, Copy)]
struct Body {
    position: [f64; 3],
    velocity: [f64; 3],
    /// The radius is `fixed` + `growing` s, with s the scale of the present.
    growing: f64,
    fixed: f64,
    time: f64,
    cell: [usize; 3],
    /// How often its way has changed.
    changes: u32,
    /// Which prediction is its last one.
    prediction: u32,
    next: Next,
}

/// What happens next to a grain.
#[derive(Clone, Copy)]
enum Next {
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
    /// It enters the next cell.
    Cross {
        axis: usize,
        up: bool,
    },
}

/// A time in the queue: finite, and so in order.
#[derive(Clone, Copy, PartialEq)]
struct Due(f64);

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

struct Run {
    region: Region,
    bodies: Vec<Body>,
    /// Grains that move.
    moving: usize,
    /// s = `scale` + `rate` t.
    scale: f64,
    rate: f64,
    counts: [usize; 3],
    cells: Vec<Vec<u32>>,
    queue: BinaryHeap<Reverse<(Due, usize, u32)>>,
    now: f64,
    collisions: usize,
}

impl Run {
    fn new(growth: &Growth<'_>, start: &[[f64; 3]], rate: f64, rng: &mut Pcg64) -> Self {
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
            queue: BinaryHeap::new(),
            now: 0.0,
            collisions: 0,
        };
        for i in 0..run.bodies.len() {
            run.enter(i);
        }
        (0..run.moving).for_each(|i| run.predict(i));
        run
    }

    /// Until the scale is 1.
    fn grow_up(&mut self) -> Result<(), Jammed> {
        let end = (1.0 + MARGIN - self.scale) / self.rate;
        let window = 10 * self.moving.max(1);
        let (mut next_look, mut before) = (window, self.now);
        while self.step(end) {
            if self.collisions < next_look {
                continue;
            }
            let gained = self.now - before;
            let per_grain = 2.0 * window as f64 / self.moving as f64;
            if (end - self.now) * per_grain > PATIENCE * gained {
                return Err(Jammed(self.scale + self.rate * self.now));
            }
            (next_look, before) = (self.collisions + window, self.now);
            self.cool();
        }
        self.now = end;
        Ok(())
    }

    /// A few collisions more at full size.
    fn relax(&mut self) {
        for i in 0..self.moving {
            self.advance(i);
        }
        (self.scale, self.rate) = (1.0 + MARGIN, 0.0);
        self.renew();
        let enough = self.collisions + RELAXATION * self.moving / 2;
        // In this time a grain alone flies as far as a few dozen radii.
        let end = self.now + 20.0;
        while self.collisions < enough && self.step(end) {}
    }

    /// Where the first grains are now, inside the region.
    fn positions(&mut self, count: usize) -> Vec<[f64; 3]> {
        (0..count)
            .map(|i| {
                self.advance(i);
                let mut place = self.bodies[i].position;
                for (axis, x) in place.iter_mut().enumerate() {
                    let ([low, high], length) = (self.region.axes[axis], self.region.length(axis));
                    if self.region.periodic[axis] && !(low..high).contains(x) {
                        *x = low + (*x - low).rem_euclid(length);
                    }
                }
                place
            })
            .collect()
    }

    /// Growth makes grains faster: back to the speed of the start, with new predictions for all.
    fn cool(&mut self) {
        let square = |body: &Body| body.velocity.iter().map(|v| v * v).sum::<f64>();
        let moving = &self.bodies[..self.moving];
        let mean = moving.iter().map(|body| body.growing).sum::<f64>() / self.moving as f64;
        let now: f64 = moving.iter().map(square).sum::<f64>() / self.moving as f64;
        let factor = mean * (self.region.dimension as f64 / now).sqrt();
        if !(factor.is_finite() && factor < 0.9) {
            return;
        }
        for i in 0..self.moving {
            self.advance(i);
            self.bodies[i].velocity = self.bodies[i].velocity.map(|v| factor * v);
        }
        self.renew();
    }

    fn renew(&mut self) {
        self.queue.clear();
        for i in 0..self.moving {
            self.bodies[i].changes += 1;
        }
        (0..self.moving).for_each(|i| self.predict(i));
    }

    /// The next event, if there is one before `end`.
    fn step(&mut self, end: f64) -> bool {
        while let Some(Reverse((Due(time), i, prediction))) = self.queue.pop() {
            if prediction != self.bodies[i].prediction {
                continue;
            }
            if time > end {
                return false;
            }
            self.now = time.max(self.now);
            match self.bodies[i].next {
                Next::Nothing => {}
                Next::Touch { other, changes, .. } if changes != self.bodies[other].changes => {
                    self.predict(i);
                }
                Next::Touch { other, shift, .. } => self.touch(i, other, shift),
                Next::End { axis, upper } => self.touch_end(i, axis, upper),
                Next::Cross { axis, up } => self.cross(i, axis, up),
            }
            return true;
        }
        false
    }

    fn advance(&mut self, i: usize) {
        let body = &mut self.bodies[i];
        let step = self.now - body.time;
        for (x, v) in body.position.iter_mut().zip(body.velocity) {
            *x += v * step;
        }
        body.time = self.now;
    }

    /// Where a grain is now.
    fn place(&self, i: usize) -> [f64; 3] {
        let body = &self.bodies[i];
        let step = self.now - body.time;
        std::array::from_fn(|axis| body.position[axis] + body.velocity[axis] * step)
    }

    fn radius(&self, i: usize) -> f64 {
        let body = &self.bodies[i];
        body.fixed + body.growing * (self.scale + self.rate * self.now)
    }

    /// Two grains exchange what they bring along the line of centres, and what they have grown.
    fn touch(&mut self, i: usize, j: usize, shift: [f64; 3]) {
        self.advance(i);
        self.advance(j);
        let (a, b) = (self.bodies[i], self.bodies[j]);
        let apart: [f64; 3] =
            std::array::from_fn(|axis| a.position[axis] - b.position[axis] - shift[axis]);
        let distance = apart.iter().map(|x| x * x).sum::<f64>().sqrt();
        let normal = apart.map(|x| x / distance);
        let along =
            |velocity: [f64; 3]| velocity.iter().zip(normal).map(|(v, n)| v * n).sum::<f64>();
        let growth = self.rate * (a.growing + b.growing);
        let gained = 2.0 * (growth - (along(a.velocity) - along(b.velocity)));
        let share = if j < self.moving { 0.5 } else { 1.0 };
        for (axis, n) in normal.into_iter().enumerate() {
            self.bodies[i].velocity[axis] += share * gained * n;
            if j < self.moving {
                self.bodies[j].velocity[axis] -= share * gained * n;
            }
        }
        self.collisions += 1;
        self.bodies[i].changes += 1;
        if j < self.moving {
            self.bodies[j].changes += 1;
            self.predict(j);
        }
        self.predict(i);
    }

    fn touch_end(&mut self, i: usize, axis: usize, upper: bool) {
        self.advance(i);
        let growth = self.rate * self.bodies[i].growing;
        let sign = if upper { -1.0 } else { 1.0 };
        let v = &mut self.bodies[i].velocity[axis];
        *v = 2.0 * growth * sign - *v;
        self.collisions += 1;
        self.bodies[i].changes += 1;
        self.predict(i);
    }

    fn cross(&mut self, i: usize, axis: usize, up: bool) {
        self.advance(i);
        let number = self.number(self.bodies[i].cell);
        self.cells[number].retain(|&member| member as usize != i);
        let (count, length) = (self.counts[axis], self.region.length(axis));
        let body = &mut self.bodies[i];
        let cell = body.cell[axis];
        // Who goes all round the region is seen elsewhere from then on.
        match (up, cell) {
            (true, cell) if cell + 1 == count => {
                (body.cell[axis], body.position[axis]) = (0, body.position[axis] - length);
                body.changes += 1;
            }
            (false, 0) => {
                (body.cell[axis], body.position[axis]) = (count - 1, body.position[axis] + length);
                body.changes += 1;
            }
            (true, cell) => body.cell[axis] = cell + 1,
            (false, cell) => body.cell[axis] = cell - 1,
        }
        let number = self.number(self.bodies[i].cell);
        self.cells[number].push(i as u32);
        self.predict(i);
    }

    fn number(&self, cell: [usize; 3]) -> usize {
        cell[0] + self.counts[0] * (cell[1] + self.counts[1] * cell[2])
    }

    fn enter(&mut self, i: usize) {
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

    /// Puts the earliest event of a grain into the queue.
    fn predict(&mut self, i: usize) {
        let mut best = (f64::INFINITY, Next::Nothing);
        let here = self.place(i);
        for (axis, x) in here.into_iter().enumerate().take(self.region.dimension) {
            self.look_along(i, axis, x, &mut best);
        }
        for step in 0..27 {
            let steps = [step % 3, step / 3 % 3, step / 9].map(|k| k as isize - 1);
            self.look_into(i, &here, steps, &mut best);
        }
        let body = &mut self.bodies[i];
        body.prediction += 1;
        body.next = best.1;
        if best.0.is_finite() {
            self.queue.push(Reverse((Due(self.now + best.0), i, body.prediction)));
        }
    }

    /// The end of an axis and the next cell along it.
    fn look_along(&self, i: usize, axis: usize, x: f64, best: &mut (f64, Next)) {
        let (body, [low, high]) = (&self.bodies[i], self.region.axes[axis]);
        let (v, growth, radius) = (body.velocity[axis], self.rate * body.growing, self.radius(i));
        if !self.region.periodic[axis] {
            for (gap, closing, upper) in
                [(x - low - radius, growth - v, false), (high - x - radius, growth + v, true)]
            {
                let after = gap.max(0.0) / closing;
                if closing > 0.0 && after < best.0 {
                    *best = (after, Next::End { axis, upper });
                }
            }
        }
        let (count, cell) = (self.counts[axis], body.cell[axis]);
        let width = self.region.length(axis) / count as f64;
        let up = v > 0.0;
        let leads_nowhere = !self.region.periodic[axis] && cell == if up { count - 1 } else { 0 };
        if v == 0.0 || leads_nowhere {
            return;
        }
        let face = low + width * (cell + usize::from(up)) as f64;
        let after = ((face - x) / v).max(0.0);
        if after < best.0 {
            *best = (after, Next::Cross { axis, up });
        }
    }

    /// The grains of a cell beside that of grain i.
    fn look_into(&self, i: usize, here: &[f64; 3], steps: [isize; 3], best: &mut (f64, Next)) {
        let (mut cell, mut shift) = ([0; 3], [0.0; 3]);
        for axis in 0..3 {
            let (count, length) = (self.counts[axis] as isize, self.region.length(axis));
            let to = self.bodies[i].cell[axis] as isize + steps[axis];
            let inside = to.rem_euclid(count);
            if inside != to && !self.region.periodic[axis] {
                return;
            }
            // Seen from grain i, who is in that cell is one length further on.
            shift[axis] = length * (to - inside) as f64 / count as f64;
            cell[axis] = inside as usize;
        }
        for &member in &self.cells[self.number(cell)] {
            let j = member as usize;
            if j == i {
                continue;
            }
            let there = self.place(j);
            let apart = std::array::from_fn(|axis| here[axis] - there[axis] - shift[axis]);
            if let Some(after) = self.meeting(i, j, apart).filter(|after| *after < best.0) {
                *best = (after, Next::Touch { other: j, shift, changes: self.bodies[j].changes });
            }
        }
    }

    /// After which time two grains touch: |r + v t| = σ + σ' t.
    fn meeting(&self, i: usize, j: usize, r: [f64; 3]) -> Option<f64> {
        let (a, b) = (&self.bodies[i], &self.bodies[j]);
        let v: [f64; 3] = std::array::from_fn(|axis| a.velocity[axis] - b.velocity[axis]);
        let dot = |p: [f64; 3], q: [f64; 3]| p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
        let (sigma, growth) =
            (self.radius(i) + self.radius(j), self.rate * (a.growing + b.growing));
        let square = dot(v, v) - growth * growth;
        let half = dot(r, v) - sigma * growth;
        let rest = dot(r, r) - sigma * sigma;
        if half < 0.0 && rest <= 0.0 {
            return Some(0.0);
        }
        let discriminant = half * half - square * rest;
        if half < 0.0 {
            return (discriminant >= 0.0).then(|| rest / (discriminant.sqrt() - half));
        }
        // They part, but grow faster than that.
        (square < 0.0).then(|| (half + discriminant.max(0.0).sqrt()) / -square)
    }
}
