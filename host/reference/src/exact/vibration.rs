//! When does a free grain touch a vibrating plate? Reads a flight and the plate; writes the first instant.

use std::f64::consts::{PI, TAU};

use super::run::Exact;
use crate::contact_law::End;
use crate::plate::Plate;
use crate::roots::{bracketed, quadratic};

/// The gap between a flight and a plate: c + b t + a t² − A_0 sin(θ + ω t).
struct Gap {
    flight: [f64; 3],
    amplitude: f64,
    omega: f64,
    theta: f64,
}

impl Gap {
    fn height(&self, t: f64) -> f64 {
        let [c, b, a] = self.flight;
        c + t * (b + t * a) - self.amplitude * libm::sin(self.theta + self.omega * t)
    }

    fn rate(&self, t: f64) -> f64 {
        let [_, b, a] = self.flight;
        b + 2.0 * a * t - self.amplitude * self.omega * libm::cos(self.theta + self.omega * t)
    }

    /// After this time the grain is above the plate's highest point for good, or has been below its
    /// lowest one.
    fn horizon(&self) -> f64 {
        let [c, b, a] = self.flight;
        let reaches = |level: f64| quadratic(a, b, c - level).into_iter().flatten().last();
        let period = TAU / self.omega;
        let last = if a < 0.0 || (a == 0.0 && b <= 0.0) {
            reaches(-self.amplitude)
        } else {
            reaches(self.amplitude)
        };
        last.unwrap_or(0.0) + period
    }

    /// The times in (0, end) at which the rate is largest or smallest: 2a + A_0 ω² sin(θ + ω t) = 0.
    fn inflections(&self, end: f64) -> Vec<f64> {
        let sine = -2.0 * self.flight[2] / (self.amplitude * self.omega * self.omega);
        if sine.abs() >= 1.0 {
            return Vec::new();
        }
        let (low, turns) = (libm::asin(sine), (end * self.omega / TAU).ceil() as i64 + 1);
        let mut times = Vec::new();
        for turn in -1..=turns {
            for angle in [low, PI - low] {
                let t = (angle - self.theta + TAU * turn as f64) / self.omega;
                if t > 0.0 && t < end {
                    times.push(t);
                }
            }
        }
        times.sort_by(f64::total_cmp);
        times
    }

    /// Times that part (0, end) into pieces in which the gap only grows or only shrinks.
    fn pieces(&self, end: f64) -> Vec<f64> {
        let mut knots = vec![0.0];
        knots.extend(self.inflections(end));
        knots.push(end);
        let mut times = vec![0.0];
        for knot in knots.windows(2) {
            let [p, q] = [knot[0], knot[1]];
            if (self.rate(p) > 0.0) != (self.rate(q) > 0.0) {
                times.push(bracketed(|t| self.rate(t), p, q));
            }
        }
        times.push(end);
        times
    }

    /// When the gap closes; at once if grain and plate overlap and approach. A gap that is not
    /// above 0 at the start counts as one that has just opened.
    fn closes(&self) -> Option<f64> {
        for piece in self.pieces(self.horizon()).windows(2) {
            let [p, q] = [piece[0], piece[1]];
            if q <= p || self.rate(0.5 * (p + q)) >= 0.0 || self.height(q) > 0.0 {
                continue;
            }
            if self.height(p) <= 0.0 {
                return Some(p);
            }
            return Some(bracketed(|t| self.height(t), p, q));
        }
        None
    }
}

impl<const D: usize> Exact<D> {
    /// When grain i, in free flight c + b t + a t² above the middle of the plate, touches it; or,
    /// where a contact has ended with some overlap left, when the force would push again.
    pub(super) fn plate_meeting(&self, i: usize, flight: [f64; 3], plate: &Plate) -> Option<f64> {
        let turns = plate.frequency * self.now + plate.phase;
        let gap = Gap {
            flight,
            amplitude: plate.amplitude,
            omega: TAU * plate.frequency,
            theta: TAU * (turns - turns.round()),
        };
        let back = gap.closes();
        if self.end == End::Overlap || gap.height(0.0) > 0.0 {
            return back;
        }
        let grain = &self.grains[i];
        let law = self.law.wall(grain.radius, grain.mass);
        let push = |t: f64| law.push(-gap.height(t), -gap.rate(t));
        let end = back?;
        let at = |k: u32| end * f64::from(k) / 64.0;
        let overlapped = |k: u32| gap.height(at(k)) < 0.0;
        let found = (1..=64).take_while(|k| overlapped(*k)).find(|k| push(at(*k)) > 0.0);
        let earlier = |k: u32| if k == 1 { at(1) } else { bracketed(push, at(k - 1), at(k)) };
        Some(found.map_or(end, earlier))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against a search in small steps.
    #[test]
    fn the_first_crossing_is_found() {
        for k in 0..300 {
            let part = |m: f64| (f64::from(k) * m).fract();
            let gap = Gap {
                flight: [1.0 + 1e-3 + part(0.618), 6.0 * part(0.7549) - 3.0, -0.5 - part(0.5698)],
                amplitude: part(0.819_17),
                omega: 0.3 + 12.0 * part(0.671_04),
                theta: TAU * part(0.549_7),
            };
            let step = 1e-4;
            let crossed = (0..200_000).map(|k| step * f64::from(k)).find(|t| gap.height(*t) <= 0.0);
            let found = gap.closes().expect("it falls");
            let crossed = crossed.expect("it falls");
            assert!(found <= crossed && crossed - found < 1.01 * step, "{found} {crossed}");
            assert!(gap.height(found).abs() < 1e-12);
        }
    }
}
