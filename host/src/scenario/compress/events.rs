//! What is done in an event of grains that grow? Takes the earliest one; writes the ways and cells of the grains concerned.

use super::state::{Due, Next, Run};
use std::cmp::Reverse;

impl Run {
    /// The next event, if there is one before `end`.
    pub(super) fn step(&mut self, end: f64) -> bool {
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
                Next::Facet(facet) => self.touch_facet(i, facet),
                Next::Cross { axis, up } => self.cross(i, axis, up),
            }
            return true;
        }
        false
    }

    pub(super) fn renew(&mut self) {
        self.queue.clear();
        for i in 0..self.moving {
            self.bodies[i].changes += 1;
        }
        (0..self.moving).for_each(|i| self.predict(i));
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
}
