//! With what force do two bodies press on each other? Reads the rule, or what stands in for it; writes nothing.

use super::settings::Settings;
use crate::law::{ContactForce, Impact, Response, Rule};
use crate::scalar::Scalar;

/// Two that overlap by more than this do not collide at once, however fast they near each other: something presses
/// them together, and collisions between what has no room only add energy. In units of the radius; from here on the
/// stand-in grows stiffer.
pub(super) const PRESSED: f32 = 1.0 / 32.0;

/// Two bodies that overlap, in what their force depends on.
pub(super) struct Touching<S> {
    pub impact: Impact<S>,
    /// The smaller radius.
    pub radius: S,
    /// How deep they overlap in the middle of the step, and how fast that grows.
    pub overlap: S,
    pub rate: S,
    /// The coefficient of restitution of a hard plane.
    pub hard: Option<S>,
    /// Whether one of them cannot collide at once any more in this step.
    pub only_forces: bool,
}

impl<S: Scalar> Touching<S> {
    /// The mean force over a step: touches and ends within it are located.
    ///
    /// A pair whose overlap is less than it changes in a step has touched within the last step's length, or
    /// will part within the next: its force acts from there to the end of the step (or from its
    /// beginning), and is taken at the middle of that span. Nothing is counted twice or left out.
    pub fn mean_force<R: Rule<S>>(&self, rule: &R, settings: &Settings<S>, step: S) -> Mean<S> {
        let (depth, share) = self.span(step);
        let Some((force, frequency)) = self.force(rule, settings, depth) else {
            let zero = S::zero();
            return Mean { force: zero, frequency: zero, share, depth, elastic: zero };
        };
        let elastic = force.elastic;
        // A dashpot stronger than a step can resolve is as strong as it can.
        let most = self.impact.reduced_mass / (step * S::from_f32(4.0));
        let force = ContactForce { damping: force.damping.min(most), ..force };
        Mean { force: force.at_rate(self.rate) * share, frequency, share, depth, elastic }
    }

    /// How deep the two are in the middle of the part of the step in which they touch, and which part that is.
    #[inline(always)]
    pub fn span(&self, step: S) -> (S, S) {
        let change = self.rate.abs() * step;
        if change > self.overlap {
            let span = self.overlap + change * S::half();
            (span * S::half(), span / change)
        } else {
            (self.overlap, S::one())
        }
    }

    /// The force at this depth: the rule's, or the stand-in's and its ω, but for two that collide at once.
    fn force<R: Rule<S>>(
        &self,
        rule: &R,
        settings: &Settings<S>,
        depth: S,
    ) -> Option<(ContactForce<S>, S)> {
        let own = if self.hard.is_none() { rule.force(&self.impact, depth) } else { None };
        if let Some(force) = own {
            return Some((force, S::zero()));
        }
        let slow = settings.slow_speed(self.radius);
        let pressed = self.radius * S::from_f32(PRESSED);
        if self.rate.abs() > slow && !self.only_forces && depth <= pressed {
            return None;
        }
        let restitution = self.hard.unwrap_or_else(|| restitution(rule, &self.impact, slow));
        let stiffer = stiffening(depth / self.radius);
        let frequency = settings.frequency(self.radius);
        let stiffness = self.impact.reduced_mass * frequency * (S::one() + stiffer);
        let force = ContactForce {
            elastic: stiffness * (frequency * depth),
            damping: stiffness * scaled_damping(restitution) * self.resting(slow),
        };
        let swing = S::one() + stiffer * S::from_f32(5.0);
        Some((force, if stiffer > S::one() { frequency * swing.sqrt() } else { frequency }))
    }

    /// By how much the stand-in's dashpot is stronger at this rate: up to 9 times from an eighth of what is
    /// slow downwards. What is so slow is no collision but a heap that settles: ε says nothing about it.
    fn resting(&self, slow: S) -> S {
        let [eight, none] = [S::from_f32(8.0), S::zero()];
        let moving = (self.rate.abs() * eight).min(slow);
        S::one() + eight * ((slow - moving) / slow).max(none)
    }
}

/// A force over a step, and ω of the stand-in's spring as stiff as it is there; zero for a rule's own force.
pub(super) struct Mean<S> {
    pub force: S,
    pub frequency: S,
    /// For which part of the step the two touch.
    pub share: S,
    /// How deep they overlap where the force is taken, and what the overlap alone gives there.
    pub depth: S,
    pub elastic: S,
}

impl<S: Scalar> Mean<S> {
    /// What two that lie still hold each other with, at this depth.
    pub fn at_rest(force: S, depth: S) -> Self {
        let elastic = force.max(S::zero());
        Self { force, frequency: S::zero(), share: S::one(), depth, elastic }
    }
}

/// By how much the stand-in's spring is stiffer this deep, in units of the radius: (32 x/R)⁴, up to 39.
///
/// Slow collisions reach x = R/200 and do not feel it. Under a column of a hundred, or a few that are a
/// hundred times as heavy, x stays below R/12.
fn stiffening<S: Scalar>(depth: S) -> S {
    let deep = (depth * S::from_f32(32.0)).min(S::from_f32(2.5));
    let square = deep * deep;
    square * square
}

/// The rule's coefficient of restitution at this speed; 1 if it refuses to say.
fn restitution<S: Scalar, R: Rule<S>>(rule: &R, impact: &Impact<S>, speed: S) -> S {
    let slow = Impact { normal_speed: speed, tangential_speed: S::zero(), ..*impact };
    match rule.collide(&slow).response {
        Response::Instantaneous(restitution) => restitution,
        Response::Lasting(outcome) => outcome.restitution,
        Response::Refused { .. } | Response::Overflow(_) => S::one(),
    }
}

/// c_dis of the linear spring-dashpot with this coefficient of restitution, its contact ending with its
/// force: to 0.0013 of ε, of our own making from its closed form. Below ε = 0.01 as for that.
pub(super) fn scaled_damping<S: Scalar>(restitution: S) -> S {
    let e = restitution.max(S::from_f32(0.01)).min(S::one());
    let s = e.sqrt();
    let curve = S::from_f64(-0.232_747) + S::from_f64(0.208_143) * s;
    (S::one() - e) / s * (S::one() + s * (S::from_f64(-0.335_562) + s * curve))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ε of x″ + c x′ + x = 0, x(0) = 0, at the instant when x + c x′ = 0.
    fn restitution_of(c: f64) -> f64 {
        let b = c / 2.0;
        if b < 1.0 {
            let w = (1.0 - b * b).sqrt();
            let a = libm::atan2(2.0 * b * w, 2.0 * b * b - 1.0);
            -libm::exp(-b * a / w) * (libm::cos(a) - b / w * libm::sin(a))
        } else {
            let w = (b * b - 1.0).sqrt();
            let a = libm::atanh(2.0 * b * w / (2.0 * b * b - 1.0));
            -libm::exp(-b * a / w) * (libm::cosh(a) - b / w * libm::sinh(a))
        }
    }

    #[test]
    fn the_stand_in_has_the_rules_restitution() {
        for percent in 2..=100 {
            let wanted = f64::from(percent) / 100.0;
            let is = restitution_of(scaled_damping(wanted));
            assert!((is - wanted).abs() < 1.4e-3, "{wanted}: {is}");
        }
        assert_eq!(scaled_damping(1.0), 0.0);
    }
}
