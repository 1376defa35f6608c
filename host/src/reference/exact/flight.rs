//! When does a free grain touch next? Reads free flights; writes the earliest contact of a grain.

use super::super::law::End;
use super::super::roots::{bracketed, quadratic};
use super::super::system::Boundary;
use super::super::vector::{Vector, dot, length, minus};
use super::Exact;
use super::images::Shifts;

/// What is met.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Target<const D: usize> {
    /// A grain, at its position plus `shift`.
    Grain { other: usize, shift: Vector<D> },
    /// A wall.
    Wall { axis: usize, upper: bool },
}

/// The next event of a free grain; without a target, only the time to look again.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Forecast<const D: usize> {
    pub time: f64,
    pub target: Option<Target<D>>,
}

impl<const D: usize> Forecast<D> {
    pub const NEVER: Self = Self { time: f64::INFINITY, target: None };

    fn sooner(&mut self, time: f64, target: Option<Target<D>>) {
        if time < self.time {
            *self = Self { time, target };
        }
    }
}

impl<const D: usize> Exact<D> {
    /// Works out what grain i meets next, as long as it and the others fly freely.
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
        let reach = self.grains[i].radius + self.grains[j].radius;
        let (period, speed) = (self.periods(), length(&v));
        let shortest = period.iter().filter(|p| **p > 0.0).fold(f64::INFINITY, |m, p| m.min(*p));
        let mut travel = [0.0; D];
        if shortest.is_finite() && speed > 0.0 {
            next.sooner(self.now + shortest / speed, None);
            travel = v.map(|v| v / speed * shortest);
        }
        for shift in Shifts::new(&d, &travel, reach, period) {
            if let Some(dt) = meeting(&minus(&d, &shift), &v, reach) {
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

/// The first time at which |d + v t| has come down to `reach`; at once if they overlap and approach.
fn meeting<const D: usize>(d: &Vector<D>, v: &Vector<D>, reach: f64) -> Option<f64> {
    let approach = dot(d, v);
    if approach >= 0.0 {
        return None;
    }
    let distance = length(d);
    if distance <= reach {
        return Some(0.0);
    }
    quadratic(dot(v, v), 2.0 * approach, (distance - reach) * (distance + reach))[0]
}
