//! How far does one step take grains in contact? Reads their state; writes their motion up to the next end of a contact.

use super::equations::{Motion, links_from, position, velocity};
use super::members::{Active, Cluster};
use crate::collocation::{Guess, NODES, Segment, node};
use crate::error::ReferenceError;
use crate::roots::bracketed;
use crate::vector::{Vector, length};

/// Last coefficients of an accepted step, relative: the step's truncation is smaller still.
const TOLERANCE: f64 = 2e-14;

impl Active {
    /// The step to try next. This one was accepted, so its error is small, or it is that of rounding (then it
    /// may be above the tolerance): a shorter one would be no better, and steps that shrink because of
    /// rounding would shrink for ever.
    fn next_length(&self) -> f64 {
        let is_rounding = self.segment.error > TOLERANCE;
        self.length * if is_rounding { 2.0 } else { growth(self.segment.error).clamp(1.0, 2.5) }
    }
}

/// How much longer a step may be, given the error of this one.
fn growth(error: f64) -> f64 {
    0.8 * libm::pow(TOLERANCE / error.max(1e-30), 1.0 / 16.0)
}

impl<const D: usize> Cluster<D> {
    /// Integrates one step ahead, unless one is under way.
    pub fn look_ahead(&mut self) -> Result<(), ReferenceError> {
        if self.active.is_some() {
            return Ok(());
        }
        let regular = self.regular();
        let (segment, length) = self.solve(regular)?;
        let (finish, ended) = match self.ending(&segment, regular) {
            Some((theta, link)) => (theta, Some(link)),
            None => (1.0, None),
        };
        let until = segment.one(finish, 0);
        if ended.is_none() && until <= self.elapsed * (1.0 + 4.0 * f64::EPSILON) {
            return Err(self.unresolved("its time step has become too small"));
        }
        if !self.motion(regular).agrees(&segment.at(finish), &self.radii) {
            return Err(self.unresolved("its centre passes through another one or a wall"));
        }
        let speeds = self.speed_bounds(&segment, finish);
        self.before = None;
        self.active = Some(Active { segment, regular, length, finish, ended, until, speeds });
        self.steps += 1;
        Ok(())
    }

    fn solve(&self, regular: Option<usize>) -> Result<(Segment, f64), ReferenceError> {
        let motion = self.motion(regular);
        let (start, scales) = (motion.pack(self), motion.scales(self));
        let rhs = |y: &[f64], f: &mut [f64]| motion.slopes(y, f);
        let before = self.before.as_ref().filter(|b| b.regular == regular);
        let mut h = before.map_or_else(|| self.first_step(regular), Active::next_length);
        let known = |b: &Active| (b.segment.clone(), b.length, 1.0);
        let mut known: Option<(Segment, f64, f64)> = before.map(known);
        let mut error = f64::INFINITY;
        for _ in 0..80 {
            let near = known.as_ref().filter(|k| h <= 1.5 * k.1);
            let guess =
                near.map(|(segment, of, from)| Guess { segment, from: *from, ratio: h / of });
            let Some(segment) = Segment::solve(&rhs, &start, h, &scales, guess) else {
                (h, error, known) = (0.3 * h, f64::INFINITY, None);
                continue;
            };
            let stuck = segment.error < 1e-12 && segment.error > 0.5 * error;
            if segment.error <= TOLERANCE || stuck {
                return Ok((segment, h));
            }
            error = segment.error;
            let shorter = h * growth(error).clamp(0.1, 0.8);
            known = Some((segment, h, 0.0));
            h = shorter;
        }
        Err(self.unresolved("no step converges"))
    }

    /// The first end of a contact within the step.
    fn ending(&self, segment: &Segment, regular: Option<usize>) -> Option<(f64, usize)> {
        let motion = self.motion(regular);
        let mut first: Option<(f64, usize)> = None;
        for link in 0..self.links.len() {
            let margin = |theta: f64| motion.margin(segment, theta, link, self.end);
            let mut before = 0.0;
            for theta in (0..NODES).map(node).chain([1.0]) {
                if first.is_some_and(|(found, _)| before >= found) {
                    break;
                }
                if margin(theta) <= 0.0 {
                    let root = bracketed(margin, before, theta);
                    if first.is_none_or(|(found, _)| root < found) {
                        first = Some((root, link));
                    }
                    break;
                }
                before = theta;
            }
        }
        first
    }

    fn speed_bounds(&self, segment: &Segment, finish: f64) -> Vec<f64> {
        let mut bounds = vec![0.0_f64; self.grains.len()];
        for theta in (0..NODES).map(node).chain([0.0, 1.0]) {
            let y = segment.at(theta * finish);
            for (a, bound) in bounds.iter_mut().enumerate() {
                *bound = bound.max(length(&velocity::<D>(&y, a)));
            }
        }
        bounds.iter().map(|b| 1.2 * b).collect()
    }

    fn motion(&self, regular: Option<usize>) -> Motion<'_, D> {
        let Self { masses, links, gravity, origin, .. } = self;
        Motion { masses, links, gravity, origin: *origin, regular }
    }

    /// Absolute time up to which the motion is known.
    pub fn known_until(&self) -> f64 {
        self.origin + self.active.as_ref().map_or(self.elapsed, |a| a.until)
    }

    pub fn speed_bound(&self, local: usize) -> f64 {
        self.active.as_ref().map_or(0.0, |a| a.speeds[local])
    }

    fn theta(&self, active: &Active, time: f64) -> f64 {
        let wanted = time - self.origin;
        if wanted >= active.until {
            return active.finish;
        }
        if wanted <= self.elapsed {
            return 0.0;
        }
        bracketed(|theta| active.segment.one(theta, 0) - wanted, 0.0, active.finish)
    }

    /// Position and velocity of a member at an absolute time within the known motion.
    pub fn state(&self, local: usize, time: f64) -> (Vector<D>, Vector<D>) {
        match &self.active {
            Some(active) => {
                let y = active.segment.at(self.theta(active, time));
                (position(&y, local), velocity(&y, local))
            }
            None => (self.positions[local], self.velocities[local]),
        }
    }

    /// Moves to the end of the step; says which contact ended there.
    pub fn finish(&mut self) -> Option<usize> {
        let active = self.active.take()?;
        self.settle(&active, active.finish);
        let ended = active.ended;
        self.before = ended.is_none().then_some(active);
        ended
    }

    /// Moves to an absolute time within the step and forgets what lies ahead.
    pub fn stop_at(&mut self, time: f64) {
        if let Some(active) = self.active.take() {
            let theta = self.theta(&active, time);
            self.settle(&active, theta);
        }
    }

    fn settle(&mut self, active: &Active, theta: f64) {
        let y = active.segment.at(theta);
        self.elapsed = y[0];
        for a in 0..self.grains.len() {
            self.positions[a] = position(&y, a);
            self.velocities[a] = velocity(&y, a);
        }
        let base = links_from::<D>(self.grains.len());
        for (c, link) in self.links.iter_mut().enumerate() {
            let compressed = y[base + 2 * c];
            let regular = active.regular == Some(c);
            let order = if regular { link.law.order() } else { 1 };
            link.overlap = compressed.powi(order);
            link.second = y[base + 2 * c + 1];
        }
    }

    fn unresolved(&self, why: &'static str) -> ReferenceError {
        let grain = self.grains[0];
        ReferenceError::Unresolved { time: self.origin + self.elapsed, grain, why }
    }
}
