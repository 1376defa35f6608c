//! How far does a run in fixed steps go, and where may it pause? Reads an instant and how many steps may be taken; goes on, and tells what contacts do.

use super::leg::Leg;
use super::told::{ContactStep, Other, Tell};
use super::verlet::Verlet;
use crate::error::ReferenceError;
use crate::exact::Partner;
use crate::vector::{Vector, plus};

impl<const D: usize> Verlet<D> {
    /// Goes on to time t in equal steps, none longer than [`Verlet::time_step`].
    ///
    /// # Errors
    ///
    /// [`ReferenceError::Parameter`] if t is before now or not finite,
    /// [`ReferenceError::Unresolved`] if a velocity is no longer finite.
    pub fn advance_to(&mut self, t: f64) -> Result<(), ReferenceError> {
        self.advance_observed(t, u64::MAX, None).map(drop)
    }

    /// As [`Verlet::advance_to`], but after so many steps it pauses: false if it has not arrived then.
    /// In how many calls it arrives changes no bit. `tell` is called for each contact in each step.
    ///
    /// # Errors
    ///
    /// As [`Verlet::advance_to`].
    ///
    /// # Examples
    ///
    /// Momentum that the left grain is given adds up to what it has in the end.
    ///
    /// ```
    /// use carom_reference::{Boundary, ContactStep, End, ForceLaw, Grain, System, Verlet, VerletOptions};
    /// let grain = |x: f64, v: f64| Grain { radius: 0.1, mass: 1.0, position: [x], velocity: [v] };
    /// let system = System::new(vec![grain(0.0, 0.0), grain(1.0, -1.0)], [Boundary::Open], [0.0])?;
    /// let law = ForceLaw::LinearDashpot { stiffness: 1e4, damping: 1.0 };
    /// let mut run = Verlet::new(&system, law, End::Force, VerletOptions::default())?;
    /// let mut given = 0.0;
    /// let mut tell = |contact: &ContactStep<1>| given += contact.force[0] * contact.step;
    /// while !run.advance_observed(2.0, 10, Some(&mut tell))? {}
    /// assert!((given - run.velocity(0)[0]).abs() < 1e-12);
    /// # Ok::<(), carom_reference::ReferenceError>(())
    /// ```
    pub fn advance_observed(
        &mut self,
        t: f64,
        steps: u64,
        mut tell: Tell<'_, D>,
    ) -> Result<bool, ReferenceError> {
        if self.leg.is_some_and(|leg| leg.to != t) {
            self.break_off();
        }
        if !(t.is_finite() && t >= self.now) {
            return Err(ReferenceError::parameter("t", t, "finite and at least the present time"));
        }
        let mut left = steps;
        while self.now < t {
            let mut leg = match self.leg.take() {
                Some(leg) => leg,
                None => self.depart(t, &mut tell),
            };
            if !self.go(&mut leg, &mut left, &mut tell) {
                self.leg = Some(leg);
                return Ok(false);
            }
            (self.now, self.clock) = (leg.now(), leg.now());
            if !self.fastest.is_finite() {
                let why = "its velocity is no longer finite";
                return Err(ReferenceError::Unresolved { time: self.now, grain: 0, why });
            }
        }
        Ok(true)
    }

    /// Velocities go half a step ahead.
    fn depart(&mut self, t: f64, tell: &mut Tell<'_, D>) -> Leg {
        let left = t - self.now;
        let count = (left / self.step).ceil().max(1.0);
        let leg = Leg { from: self.now, to: t, step: left / count, count: count as u64, done: 0 };
        if let Some(tell) = tell {
            self.tell(0.5 * leg.step, 0.0, self.statistics.steps == 0, *tell);
        }
        self.kick(0.5 * leg.step);
        leg
    }

    /// The leg ends where it has come to.
    fn break_off(&mut self) {
        if let Some(leg) = self.leg.take() {
            self.kick(-0.5 * leg.step);
            (self.now, self.clock) = (leg.now(), leg.now());
        }
    }

    /// At most so many steps of a leg; whether it is over, as it also is when the step must shrink.
    fn go(&mut self, leg: &mut Leg, left: &mut u64, tell: &mut Tell<'_, D>) -> bool {
        let h = leg.step;
        while *left > 0 {
            self.drift(h);
            let shrunk = self.used > self.skin && self.prepare();
            self.push_all(h);
            self.virial[1] += h * self.virial[0];
            self.statistics.steps += 1;
            (leg.done, *left) = (leg.done + 1, *left - 1);
            let is_over = leg.done == leg.count || shrunk || !self.fastest.is_finite();
            let kick = if is_over { 0.5 * h } else { h };
            if let Some(tell) = tell {
                self.tell(kick, 0.5 * h, true, *tell);
            }
            self.kick(kick);
            if is_over {
                return true;
            }
        }
        false
    }

    /// The velocity of grain i at the time of its position.
    pub(super) fn present_velocity(&self, i: usize) -> Vector<D> {
        let Some(leg) = self.leg else { return self.velocities[i] };
        let acceleration = plus(&self.gravity, 1.0, &self.accelerations[i]);
        plus(&self.velocities[i], -0.5 * leg.step, &acceleration)
    }

    /// Tells of all contacts before a kick of this length, `behind` after which velocities are those of the positions' time.
    fn tell(&self, kick: f64, behind: f64, is_new: bool, tell: &mut dyn FnMut(&ContactStep<D>)) {
        for push in &self.pushes {
            let began = is_new && self.touching[0].binary_search(&push.key()).is_err();
            let grain = push.grain as usize;
            let (partner, other) = match push.other {
                Other::Grain(other) => {
                    (Partner::Grain(other as usize), self.kicked(other as usize, behind))
                }
                Other::Wall { axis, upper, velocity } => {
                    let of = |k: usize| if k == axis { velocity } else { 0.0 };
                    (Partner::Wall { axis, upper }, std::array::from_fn(of))
                }
            };
            let velocities = [self.kicked(grain, behind), other];
            tell(&ContactStep {
                grain,
                partner,
                force: push.force,
                position: self.positions[grain],
                separation: push.separation,
                velocities,
                step: kick,
                began,
            });
        }
    }

    /// The velocity of grain i after a kick by what acts on it now.
    fn kicked(&self, i: usize, h: f64) -> Vector<D> {
        let acceleration = plus(&self.gravity, 1.0, &self.accelerations[i]);
        plus(&self.velocities[i], h, &acceleration)
    }
}
