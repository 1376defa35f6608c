//! What happens next to a grain that grows? Reads the grains around it; writes its earliest event into the queue.

use super::state::{Due, Next, Run};
use std::cmp::Reverse;

impl Run {
    /// Puts the earliest event of a grain into the queue.
    pub(super) fn predict(&mut self, i: usize) {
        let mut best = (f64::INFINITY, Next::Nothing);
        let here = self.place(i);
        for (axis, x) in here.into_iter().enumerate().take(self.region.dimension) {
            self.look_along(i, axis, x, &mut best);
        }
        for step in 0..27 {
            let steps = [step % 3, step / 3 % 3, step / 9].map(|k| k as isize - 1);
            self.look_into(i, &here, steps, &mut best);
        }
        self.look_at_facets(i, &here, &mut best);
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
