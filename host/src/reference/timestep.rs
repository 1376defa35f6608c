//! What does ordinary molecular dynamics give, and what does it cost? Reads a system and a law; writes its motion in fixed steps.

use super::cells::{NearPair, NearWall, Neighbours};
use super::error::{ReferenceError, positive};
use super::law::{ContactLaw, End, ForceLaw};
use super::system::{Boundary, Grain, System};
use super::vector::{Vector, dot, length, minus, plus};

/// How finely, and with which list.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VerletOptions {
    /// Time steps per shortest contact; 50 unless told otherwise.
    pub steps_per_contact: f64,
    /// How far beyond contact the pair list reaches; `None` chooses the cheapest by estimate.
    pub skin: Option<f64>,
}

impl Default for VerletOptions {
    fn default() -> Self {
        Self { steps_per_contact: 50.0, skin: None }
    }
}

/// What a run has cost so far.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Counters {
    /// Time steps.
    pub steps: u64,
    /// Contacts begun: a pair, or a grain and a wall, that came to overlap.
    pub contacts: u64,
    /// Distances computed.
    pub distances: u64,
    /// Contact forces computed.
    pub forces: u64,
    /// Pair lists made.
    pub lists: u64,
}

/// Force-based molecular dynamics as it is usually done: velocity Verlet, a fixed step, a pair
/// list from cells.
///
/// The step is the shortest contact's length over [`VerletOptions::steps_per_contact`], the
/// contact being that of the lightest (and largest) grains at the largest relative speed there is,
/// estimated by [`ContactLaw::contact_time`]; it is made shorter when speeds grow.
///
/// Forces depend on velocities, which velocity Verlet knows only half a step earlier. They are
/// taken at v(t + dt/2) + a(t) dt/2, which is v(t + dt) to second order; so the whole scheme stays
/// of second order at one force computation a step. At the ends of a contact the force or its
/// slope jumps: there the order is lower, though the error stays small.
///
/// Cost: O(N) per step. Between two lists only the listed pairs are looked at; contact forces
/// touch only the grains they act on.
#[derive(Debug, Clone)]
pub struct Verlet<const D: usize> {
    positions: Vec<Vector<D>>,
    velocities: Vec<Vector<D>>,
    /// Contact accelerations, zero but for the grains in `loaded`.
    accelerations: Vec<Vector<D>>,
    loaded: Vec<u32>,
    radii: Vec<f64>,
    masses: Vec<f64>,
    boundary: [Boundary; D],
    gravity: Vector<D>,
    law: ForceLaw,
    end: End,
    options: VerletOptions,
    skin: f64,
    step: f64,
    /// The relative speed the step was chosen for.
    designed: f64,
    near: Neighbours<D>,
    /// How much of the skin may be used up.
    used: f64,
    fastest: f64,
    touching: [Vec<u64>; 2],
    pushes: Vec<Push<D>>,
    counters: Counters,
    now: f64,
}

/// One contact's force on `grain`; `other` (if any) feels the opposite.
#[derive(Debug, Clone, Copy)]
struct Push<const D: usize> {
    grain: u32,
    other: Option<u32>,
    force: Vector<D>,
}

impl<const D: usize> Verlet<D> {
    /// Starts at time 0.
    ///
    /// # Errors
    ///
    /// [`ReferenceError::Parameter`] for a bad law or bad options.
    pub fn new(
        system: &System<D>,
        law: ForceLaw,
        end: End,
        options: VerletOptions,
    ) -> Result<Self, ReferenceError> {
        law.validate()?;
        positive("steps_per_contact", options.steps_per_contact)?;
        options.skin.map_or(Ok(()), |skin| positive("skin", skin))?;
        let grains = system.grains();
        let mut run = Self {
            positions: grains.iter().map(|g| g.position).collect(),
            velocities: grains.iter().map(|g| g.velocity).collect(),
            accelerations: vec![[0.0; D]; grains.len()],
            loaded: Vec::new(),
            radii: grains.iter().map(|g| g.radius).collect(),
            masses: grains.iter().map(|g| g.mass).collect(),
            boundary: *system.boundary(),
            gravity: *system.gravity(),
            law,
            end,
            options,
            skin: 0.0,
            step: f64::INFINITY,
            designed: 0.0,
            near: Neighbours::default(),
            used: f64::INFINITY,
            fastest: 0.0,
            touching: [Vec::new(), Vec::new()],
            pushes: Vec::new(),
            counters: Counters::default(),
            now: 0.0,
        };
        run.prepare();
        run.push_all(0.0);
        Ok(run)
    }

    /// The time the run stands at.
    pub fn now(&self) -> f64 {
        self.now
    }

    /// The largest step taken (s).
    pub fn time_step(&self) -> f64 {
        self.step
    }

    /// How far beyond contact the pair list reaches.
    pub fn skin(&self) -> f64 {
        self.skin
    }

    /// Pairs in the present list.
    pub fn listed(&self) -> usize {
        self.near.pairs.len()
    }

    /// What the run has cost so far.
    pub fn counters(&self) -> Counters {
        self.counters
    }

    /// Where grain i is; in a periodic box, some image of it near the box.
    pub fn position(&self, i: usize) -> [f64; D] {
        self.positions[i]
    }

    /// How grain i moves.
    pub fn velocity(&self, i: usize) -> [f64; D] {
        self.velocities[i]
    }

    /// All grains as they are now.
    pub fn grains(&self) -> Vec<Grain<D>> {
        let grain = |i: usize| Grain {
            radius: self.radii[i],
            mass: self.masses[i],
            position: self.positions[i],
            velocity: self.velocities[i],
        };
        (0..self.positions.len()).map(grain).collect()
    }

    /// The system as it is now.
    ///
    /// # Errors
    ///
    /// As [`System::new`]; a soft grain's centre may have crossed a wall.
    pub fn system(&self) -> Result<System<D>, ReferenceError> {
        System::new(self.grains(), self.boundary, self.gravity)
    }

    /// Goes on to time t in equal steps, none longer than [`Verlet::time_step`].
    ///
    /// # Errors
    ///
    /// [`ReferenceError::Parameter`] if t is before now or not finite,
    /// [`ReferenceError::Unresolved`] if a velocity is no longer finite.
    pub fn advance_to(&mut self, t: f64) -> Result<(), ReferenceError> {
        if !(t.is_finite() && t >= self.now) {
            return Err(ReferenceError::parameter("t", t, "finite and at least the present time"));
        }
        while self.now < t {
            let left = t - self.now;
            let count = (left / self.step).ceil().max(1.0);
            let done = self.run(count as u64, left / count);
            self.now = if done == count as u64 { t } else { self.now + done as f64 * left / count };
            if !self.fastest.is_finite() {
                let why = "its velocity is no longer finite";
                return Err(ReferenceError::Unresolved { time: self.now, grain: 0, why });
            }
        }
        Ok(())
    }

    /// Up to `count` steps of length h, from and to a full step; fewer if the step must shrink.
    fn run(&mut self, count: u64, h: f64) -> u64 {
        self.kick(0.5 * h);
        for done in 1..=count {
            self.drift(h);
            let shrunk = self.used > self.skin && self.prepare();
            self.push_all(h);
            self.counters.steps += 1;
            if done == count || shrunk || !self.fastest.is_finite() {
                self.kick(0.5 * h);
                return done;
            }
            self.kick(h);
        }
        count
    }

    fn drift(&mut self, h: f64) {
        let velocities = self.velocities.as_flattened();
        for (r, v) in self.positions.as_flattened_mut().iter_mut().zip(velocities) {
            *r += h * v;
        }
        self.used += 2.0 * h * self.fastest;
    }

    fn kick(&mut self, h: f64) {
        if self.gravity != [0.0; D] {
            let g = self.gravity.map(|g| h * g);
            self.velocities.iter_mut().for_each(|v| *v = plus(v, 1.0, &g));
            self.fastest += length(&g);
        }
        for &i in &self.loaded {
            let v = &mut self.velocities[i as usize];
            *v = plus(v, h, &self.accelerations[i as usize]);
            self.fastest = self.fastest.max(length(v));
            if !v[0].is_finite() {
                self.fastest = f64::NAN;
            }
        }
    }

    /// New contact accelerations, at the present positions and predicted velocities.
    fn push_all(&mut self, h: f64) {
        self.touching.swap(0, 1);
        self.touching[1].clear();
        self.pushes.clear();
        self.push_pairs(h);
        self.push_walls(h);
        self.counters.distances += (self.near.pairs.len() + self.near.walls.len()) as u64;
        if self.loaded.is_empty() && self.pushes.is_empty() {
            return;
        }
        self.count_contacts();
        self.accelerate();
    }
}

impl<const D: usize> Verlet<D> {
    fn push_pairs(&mut self, h: f64) {
        let pairs = std::mem::take(&mut self.near.pairs);
        for pair in &pairs {
            let (i, j) = (pair.grain as usize, pair.other as usize);
            let d = minus(&minus(&self.positions[i], &self.positions[j]), &pair.shift);
            let square = dot(&d, &d);
            if square < pair.reach * pair.reach {
                self.push_pair(pair, &d, square.sqrt(), h);
            }
        }
        self.near.pairs = pairs;
    }

    #[cold]
    fn push_pair(&mut self, pair: &NearPair<D>, d: &Vector<D>, distance: f64, h: f64) {
        let (i, j) = (pair.grain as usize, pair.other as usize);
        let v = minus(&self.predicted(i, h), &self.predicted(j, h));
        let normal = d.map(|d| d / distance);
        let law = self.law.pair([self.radii[i], self.radii[j]], [self.masses[i], self.masses[j]]);
        let force = law.force_until(pair.reach - distance, -dot(&v, &normal), self.end);
        let force = normal.map(|n| force * n);
        self.pushes.push(Push { grain: pair.grain, other: Some(pair.other), force });
        self.touching[1].push(u64::from(pair.grain) << 32 | u64::from(pair.other));
    }

    fn push_walls(&mut self, h: f64) {
        let walls = std::mem::take(&mut self.near.walls);
        for wall in &walls {
            let i = wall.grain as usize;
            let overlap = self.radii[i] - wall.facing * (self.positions[i][wall.axis] - wall.at);
            if overlap > 0.0 {
                self.push_wall(wall, overlap, h);
            }
        }
        self.near.walls = walls;
    }

    fn push_wall(&mut self, wall: &NearWall, overlap: f64, h: f64) {
        let i = wall.grain as usize;
        let law = self.law.wall(self.radii[i], self.masses[i]);
        let v = self.predicted(i, h)[wall.axis] + 0.5 * h * self.gravity[wall.axis];
        let mut force = [0.0; D];
        force[wall.axis] = wall.facing * law.force_until(overlap, -wall.facing * v, self.end);
        self.pushes.push(Push { grain: wall.grain, other: None, force });
        let which = 2 * wall.axis as u64 + u64::from(wall.facing < 0.0);
        self.touching[1].push(u64::from(wall.grain) << 32 | (u64::from(u32::MAX) - which));
    }

    /// The velocity half a step on, by the old contact acceleration (uniform gravity apart).
    fn predicted(&self, i: usize, h: f64) -> Vector<D> {
        plus(&self.velocities[i], 0.5 * h, &self.accelerations[i])
    }

    fn count_contacts(&mut self) {
        let [before, now] = &mut self.touching;
        now.sort_unstable();
        let begun = now.iter().filter(|key| before.binary_search(key).is_err()).count();
        self.counters.contacts += begun as u64;
        self.counters.forces += self.pushes.len() as u64;
    }

    fn accelerate(&mut self) {
        for i in self.loaded.drain(..) {
            self.accelerations[i as usize] = [0.0; D];
        }
        for push in &self.pushes {
            for (grain, sign) in [(Some(push.grain), 1.0), (push.other, -1.0)] {
                let Some(grain) = grain else { continue };
                let a = &mut self.accelerations[grain as usize];
                *a = plus(a, sign / self.masses[grain as usize], &push.force);
                self.loaded.push(grain);
            }
        }
        self.loaded.sort_unstable();
        self.loaded.dedup();
    }

    /// Wraps positions, makes a new list, and says whether the step became shorter.
    fn prepare(&mut self) -> bool {
        for (axis, bound) in self.boundary.iter().enumerate() {
            let Boundary::Periodic { lo, hi } = *bound else { continue };
            for r in &mut self.positions {
                if r[axis] < lo || r[axis] >= hi {
                    r[axis] -= (hi - lo) * ((r[axis] - lo) / (hi - lo)).floor();
                }
            }
        }
        let speeds = self.velocities.iter().map(length);
        let [first, second] = speeds.fold(
            [0.0, 0.0],
            |[a, b]: [f64; 2], v| {
                if v > a { [v, a] } else { [a, b.max(v)] }
            },
        );
        self.fastest = first;
        let shrunk = self.choose_step(first + second);
        if self.skin == 0.0 {
            self.skin = self.options.skin.unwrap_or_else(|| self.cheapest_skin());
        }
        self.near.rebuild(&self.positions, &self.radii, &self.boundary, self.skin);
        self.used = 0.0;
        self.counters.lists += 1;
        shrunk
    }

    fn choose_step(&mut self, relative: f64) -> bool {
        let largest = self.radii.iter().fold(0.0, |m: f64, r| m.max(*r));
        let relative = relative.max((length(&self.gravity) * largest).sqrt());
        if relative <= 1.25 * self.designed && self.step.is_finite() {
            return false;
        }
        let lightest = self.masses.iter().fold(f64::INFINITY, |m, x| m.min(*x));
        let pair: ContactLaw = self.law.pair([largest; 2], [lightest; 2]);
        let wall = self.law.wall(largest, lightest);
        let walled = self.boundary.iter().any(|b| matches!(b, Boundary::Walls { .. }));
        let speed = if relative > 0.0 { relative } else { largest };
        let mut shortest = pair.contact_time(speed);
        if walled {
            shortest = shortest.min(wall.contact_time(speed));
        }
        let before = self.step;
        self.designed = relative;
        self.step = before.min(shortest / self.options.steps_per_contact);
        self.step < before
    }

    /// Weighs the pairs looked at in each step against making lists, by rough costs of both.
    fn cheapest_skin(&self) -> f64 {
        let n = self.positions.len() as f64;
        let reach = 2.0 * self.radii.iter().sum::<f64>() / n;
        let density = n / self.volume(reach);
        let cost = |skin: f64| {
            let ball = |r: f64| [2.0 * r, 3.15 * r * r, 4.19 * r * r * r][D.clamp(1, 3) - 1];
            let pairs = 0.5 * density * ball(reach + skin);
            let per_list = skin / (2.0 * self.fastest * self.step);
            pairs * PAIR_COST + (LIST_COST + 10.0 * pairs) / per_list.max(1.0)
        };
        let trials = (0..60).map(|k| 0.02 * reach * 1.12_f64.powi(k));
        trials
            .map(|s| (cost(s), s))
            .fold((f64::INFINITY, reach), |a, b| if b.0 < a.0 { b } else { a })
            .1
    }

    fn volume(&self, reach: f64) -> f64 {
        let side = |axis: usize| {
            let all = self.positions.iter().map(|r| r[axis]);
            let low = all.clone().fold(f64::INFINITY, f64::min);
            all.fold(f64::NEG_INFINITY, f64::max) - low + reach
        };
        (0..D).map(side).product()
    }
}

/// Cost of looking at one listed pair in one step (ns, measured).
const PAIR_COST: f64 = 2.0;
/// Cost of one grain in making a list (ns, measured).
const LIST_COST: f64 = 200.0;
