//! How long a step, which pairs, how often a new list? Reads speeds and sizes; writes the step and the pair list.

use super::verlet::Verlet;
use crate::contact_law::ContactLaw;
use crate::system::Boundary;
use crate::vector::length;

/// Cost of looking at one listed pair in one step (ns, measured).
const PAIR_COST: f64 = 2.0;
/// Cost of one grain in making a list (ns, measured).
const LIST_COST: f64 = 200.0;

impl<const D: usize> Verlet<D> {
    /// Wraps positions, makes a new list, and says whether the step became shorter.
    pub(super) fn prepare(&mut self) -> bool {
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
        let shrunk = self.choose_step(first + second.max(self.fastest_plate));
        if self.skin == 0.0 {
            self.skin = self.options.skin.unwrap_or_else(|| self.cheapest_skin());
        }
        self.near.rebuild(&self.positions, &self.radii, &self.boundary, self.skin);
        self.used = 0.0;
        self.statistics.lists += 1;
        shrunk
    }

    fn choose_step(&mut self, relative: f64) -> bool {
        let largest = self.radii.iter().fold(0.0, |m: f64, r| m.max(*r));
        let relative = relative.max((length(&self.gravity) * largest).sqrt());
        if relative <= 1.25 * self.designed && self.step.is_finite() {
            return false;
        }
        let lightest = self.lightest;
        let pair: ContactLaw = self.law.pair([largest; 2], [lightest; 2]);
        let wall = self.law.wall(largest, lightest);
        let wall_like = |b: &Boundary| matches!(b, Boundary::Walls { .. } | Boundary::Plate(_));
        let walled = self.boundary.iter().any(wall_like);
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
        let contact_distance = 2.0 * self.radii.iter().sum::<f64>() / n;
        let density = n / self.volume(contact_distance);
        let cost = |skin: f64| {
            let ball = |r: f64| [2.0 * r, 3.15 * r * r, 4.19 * r * r * r][D.clamp(1, 3) - 1];
            let pairs = 0.5 * density * ball(contact_distance + skin);
            let fastest = self.fastest.max(self.fastest_plate);
            let per_list = skin / (2.0 * fastest * self.step);
            pairs * PAIR_COST + (LIST_COST + 10.0 * pairs) / per_list.max(1.0)
        };
        let trials = (0..60).map(|k| 0.02 * contact_distance * 1.12_f64.powi(k));
        trials
            .map(|s| (cost(s), s))
            .fold((f64::INFINITY, contact_distance), |a, b| if b.0 < a.0 { b } else { a })
            .1
    }

    fn volume(&self, contact_distance: f64) -> f64 {
        let side = |axis: usize| {
            let all = self.positions.iter().map(|r| r[axis]);
            let low = all.clone().fold(f64::INFINITY, f64::min);
            all.fold(f64::NEG_INFINITY, f64::max) - low + contact_distance
        };
        (0..D).map(side).product()
    }
}
