//! When does a free grain touch next, and in which periodic image? Reads free flights; writes the earliest contact of a grain.

use super::run::{Exact, Forecast, Target};
use crate::contact_law::End;
use crate::roots::{bracketed, quadratic};
use crate::system::Boundary;
use crate::vector::{Vector, dot, length, minus};

impl<const D: usize> Exact<D> {
    /// Works out what grain i collides with next, as long as it and the others fly freely.
    pub(super) fn foresee(&mut self, i: usize) {
        let mut next = Forecast::NEVER;
        if self.owner[i].is_none() {
            self.foresee_walls(i, &mut next);
            for j in 0..self.grains.len() {
                if j != i && self.owner[j].is_none() {
                    self.foresee_pair(i, j, &mut next);
                }
            }
        }
        self.forecasts[i] = next;
    }

    fn foresee_pair(&self, i: usize, j: usize, next: &mut Forecast<D>) {
        let ((ri, vi), (rj, vj)) = (self.state(i, self.now), self.state(j, self.now));
        let (d, v) = (minus(&ri, &rj), minus(&vi, &vj));
        let contact_distance = self.grains[i].radius + self.grains[j].radius;
        let (period, speed) = (self.periods(), length(&v));
        let shortest = period.iter().filter(|p| **p > 0.0).fold(f64::INFINITY, |m, p| m.min(*p));
        let mut travel = [0.0; D];
        if shortest.is_finite() && speed > 0.0 {
            next.sooner(self.now + shortest / speed, None);
            travel = v.map(|v| v / speed * shortest);
        }
        for shift in Shifts::new(&d, &travel, contact_distance, period) {
            if let Some(dt) = time_to_contact(&minus(&d, &shift), &v, contact_distance) {
                next.sooner(self.now + dt, Some(Target::Grain { other: j, shift }));
            }
        }
    }

    fn foresee_walls(&self, i: usize, next: &mut Forecast<D>) {
        let (r, v) = self.state(i, self.now);
        for axis in 0..D {
            let sides: &[bool] = match self.boundary[axis] {
                Boundary::Walls { .. } => &[false, true],
                Boundary::Plate(_) => &[false],
                _ => &[],
            };
            for &upper in sides {
                let (facing, plate) = self.wall(axis, upper);
                let gap = facing * (r[axis] - plate.at) - self.grains[i].radius;
                let fall = [gap, facing * v[axis], 0.5 * facing * self.gravity[axis]];
                let dt = match plate.moves() {
                    true => self.plate_meeting(i, fall, &plate),
                    false => self.wall_meeting(i, fall),
                };
                if let Some(dt) = dt {
                    next.sooner(self.now + dt, Some(Target::Wall { axis, upper }));
                }
            }
        }
    }

    /// When a free grain's gap to a wall, c + b t + a t², closes; or, where a contact has ended
    /// with some overlap left, when the force would push again.
    fn wall_meeting(&self, i: usize, [c, b, a]: [f64; 3]) -> Option<f64> {
        if c > 0.0 {
            return quadratic(a, b, c)[0];
        }
        if b < 0.0 || (b == 0.0 && a < 0.0) {
            return Some(0.0);
        }
        let grain = &self.grains[i];
        let law = self.law.wall(grain.radius, grain.mass);
        let theta = law.relaxation;
        let [left, back] = quadratic(a, b, c);
        let back = back.or(if a < 0.0 { left } else { None });
        if self.end == End::Overlap || theta == 0.0 || a >= 0.0 {
            return back;
        }
        if !law.proportional() {
            // The overlap is largest, and its rate zero, halfway at the latest.
            let push = |t: f64| law.push(-c - t * (b + t * a), -b - 2.0 * t * a);
            let top = back.filter(|back| push(*back) > 0.0 && push(0.0) <= 0.0);
            return top.map_or(back, |top| Some(bracketed(push, 0.0, top)));
        }
        let [early, late] = quadratic(-a, -b - 2.0 * theta * a, -c - theta * b);
        let push = late.or(early).filter(|t| c + t * (b + t * a) <= 0.0);
        match (push, back) {
            (Some(push), Some(back)) => Some(push.min(back)),
            (push, back) => push.or(back),
        }
    }
}

/// The first time at which |d + v t| has come down to `contact_distance`; at once if they overlap and approach.
fn time_to_contact<const D: usize>(
    d: &Vector<D>,
    v: &Vector<D>,
    contact_distance: f64,
) -> Option<f64> {
    let approach = dot(d, v);
    if approach >= 0.0 {
        return None;
    }
    let distance = length(d);
    if distance <= contact_distance {
        return Some(0.0);
    }
    quadratic(
        dot(v, v),
        2.0 * approach,
        (distance - contact_distance) * (distance + contact_distance),
    )[0]
}

/// The shifts s = k L for which |d + travel − s| may come below `contact_distance`, on every axis.
#[derive(Debug, Clone)]
pub(super) struct Shifts<const D: usize> {
    low: [i64; D],
    high: [i64; D],
    next: Option<[i64; D]>,
    period: Vector<D>,
}

impl<const D: usize> Shifts<D> {
    /// `travel` is the change of d from now on, reached along a straight line; a period of 0
    /// stands for an axis that does not repeat.
    pub fn new(
        d: &Vector<D>,
        travel: &Vector<D>,
        contact_distance: f64,
        period: Vector<D>,
    ) -> Self {
        let range = |k: usize| {
            if period[k] == 0.0 {
                return [0, 0];
            }
            let (back, ahead) = (travel[k].min(0.0), travel[k].max(0.0));
            let low = (d[k] + back - contact_distance) / period[k];
            let high = (d[k] + ahead + contact_distance) / period[k];
            [low.ceil() as i64, high.floor() as i64]
        };
        let low = std::array::from_fn(|k| range(k)[0]);
        let high = std::array::from_fn(|k| range(k)[1]);
        let any = (0..D).all(|k| low[k] <= high[k]);
        Self { low, high, next: any.then_some(low), period }
    }

    /// Shifts that put the other grain within `contact_distance` of a separation d, axis by axis.
    pub fn near(d: &Vector<D>, contact_distance: f64, period: Vector<D>) -> Self {
        Self::new(d, &[0.0; D], contact_distance, period)
    }
}

impl<const D: usize> Iterator for Shifts<D> {
    type Item = Vector<D>;

    fn next(&mut self) -> Option<Vector<D>> {
        let k = self.next?;
        let mut after = k;
        let turned = (0..D).find(|&axis| {
            after[axis] += 1;
            if after[axis] > self.high[axis] {
                after[axis] = self.low[axis];
                return false;
            }
            true
        });
        self.next = turned.map(|_| after);
        Some(std::array::from_fn(|axis| k[axis] as f64 * self.period[axis]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_image_within_reach_comes_once() {
        let near = |d, contact_distance| {
            Shifts::near(&d, contact_distance, [1.0, 0.0]).collect::<Vec<_>>()
        };
        assert_eq!(near([0.1, 9.0], 0.2), [[0.0, 0.0]]);
        assert_eq!(near([2.9, 0.0], 0.2), [[3.0, 0.0]]);
        assert_eq!(near([0.5, 0.0], 0.2), Vec::<[f64; 2]>::new());
        assert_eq!(near([0.5, 0.0], 0.6), [[0.0, 0.0], [1.0, 0.0]]);
        let all: Vec<_> = Shifts::new(&[0.4, 0.4], &[0.5, -0.5], 0.2, [1.0, 1.0]).collect();
        assert_eq!(all, [[1.0, 0.0]]);
        assert_eq!(Shifts::new(&[0.1, 0.1], &[1.0, 1.0], 0.2, [1.0, 1.0]).count(), 4);
    }
}
