//! What pushes each grain now? Reads positions, predicted velocities and the pair list; writes contact accelerations.

use super::told::{Other, Push};
use super::verlet::Verlet;
use crate::cells::{NearPair, NearWall};
use crate::vector::{Vector, dot, minus, plus};

impl<const D: usize> Verlet<D> {
    /// New contact accelerations, at the present positions and predicted velocities.
    pub(super) fn push_all(&mut self, h: f64) {
        self.touching.swap(0, 1);
        self.touching[1].clear();
        self.pushes.clear();
        (self.pushed, self.virial[0]) = (false, 0.0);
        self.push_pairs(h);
        self.push_walls(h);
        self.statistics.distances += (self.near.pairs.len() + self.near.walls.len()) as u64;
        if self.loaded.is_empty() && self.pushes.is_empty() {
            return;
        }
        self.pushed = self.pushed_noticeably();
        if self.pushed {
            self.touched = self.clock;
        }
        self.count_contacts();
        self.accelerate();
    }

    fn push_pairs(&mut self, h: f64) {
        let pairs = std::mem::take(&mut self.near.pairs);
        for pair in &pairs {
            let (i, j) = (pair.grain as usize, pair.other as usize);
            let d = minus(&minus(&self.positions[i], &self.positions[j]), &pair.shift);
            let square = dot(&d, &d);
            if square < pair.contact_distance * pair.contact_distance {
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
        let rate = -dot(&v, &normal);
        let push = law.force_until(pair.contact_distance - distance, rate, self.end);
        self.virial[0] += push * distance;
        let mut force = normal.map(|n| push * n);
        if law.tangential > 0.0 && push != 0.0 {
            force = plus(&force, -law.tangential, &plus(&v, rate, &normal));
        }
        let other = Other::Grain(pair.other);
        self.note(Push { grain: pair.grain, other, force, separation: *d });
    }

    fn push_walls(&mut self, h: f64) {
        let walls = std::mem::take(&mut self.near.walls);
        for wall in &walls {
            let i = wall.grain as usize;
            let at = wall.plate.height(self.clock);
            let overlap = self.radii[i] - wall.facing * (self.positions[i][wall.axis] - at);
            if overlap > 0.0 {
                self.push_wall(wall, overlap, h);
            }
        }
        self.near.walls = walls;
    }

    fn push_wall(&mut self, wall: &NearWall, overlap: f64, h: f64) {
        let i = wall.grain as usize;
        let law = self.law.wall(self.radii[i], self.masses[i]);
        let along = self.predicted(i, h);
        let fallen = along[wall.axis] + 0.5 * h * self.gravity[wall.axis];
        let v = fallen - wall.plate.velocity(self.clock);
        let push = law.force_until(overlap, -wall.facing * v, self.end);
        let mut force = match law.tangential > 0.0 && push != 0.0 {
            true => along.map(|v| -law.tangential * v),
            false => [0.0; D],
        };
        force[wall.axis] = wall.facing * push;
        let (axis, upper) = (wall.axis, wall.facing < 0.0);
        let mut separation = [0.0; D];
        separation[axis] = wall.facing * (self.radii[i] - overlap);
        let other = Other::Wall { axis, upper, velocity: wall.plate.velocity(self.clock) };
        self.note(Push { grain: wall.grain, other, force, separation });
    }

    fn note(&mut self, push: Push<D>) {
        self.touching[1].push(push.key());
        self.pushes.push(push);
    }

    /// The velocity half a step on, by the old contact acceleration (uniform gravity apart).
    fn predicted(&self, i: usize, h: f64) -> Vector<D> {
        plus(&self.velocities[i], 0.5 * h, &self.accelerations[i])
    }

    /// Whether some contact's force, over a contact time, changes a velocity by more than 1e-6 of
    /// the fastest one. Grains that rest against each other overlap by some rounding for ever.
    fn pushed_noticeably(&self) -> bool {
        let duration = self.step * self.options.steps_per_contact;
        let least = 1e-6 * self.fastest * self.lightest / duration;
        self.pushes.iter().any(|push| dot(&push.force, &push.force) > least * least)
    }

    fn count_contacts(&mut self) {
        let [before, now] = &mut self.touching;
        now.sort_unstable();
        let begun = now.iter().filter(|key| before.binary_search(key).is_err()).count();
        self.statistics.contacts += begun as u64;
        self.statistics.forces += self.pushes.len() as u64;
    }

    fn accelerate(&mut self) {
        for i in self.loaded.drain(..) {
            self.accelerations[i as usize] = [0.0; D];
        }
        for push in &self.pushes {
            let other = match push.other {
                Other::Grain(other) => Some(other),
                Other::Wall { .. } => None,
            };
            for (grain, sign) in [(Some(push.grain), 1.0), (other, -1.0)] {
                let Some(grain) = grain else { continue };
                let a = &mut self.accelerations[grain as usize];
                *a = plus(a, sign / self.masses[grain as usize], &push.force);
                self.loaded.push(grain);
            }
        }
        self.loaded.sort_unstable();
        self.loaded.dedup();
    }
}
