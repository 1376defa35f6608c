//! With what force do two bodies press on each other whose contact remembers? Reads the law; writes what the contact remembers.
//!
//! Under the laws that have tables nothing of this file is in the program.

use super::contact::{Mean, Touching};
use super::forces::{Forces, with_grain, with_plane};
use super::transfer::Receiver;
use crate::law::Rule;
use crate::particle::{Body, Partner};
use crate::scalar::{Scalar, Vector};
use crate::space::{Contacts, Obstacles, Particles, Plane};

impl<S: Scalar, const D: usize, R: Rule<S>, O: Receiver<S, D>> Forces<'_, '_, S, D, R, O> {
    /// The mean force over the step under a law of one's own; none under all others.
    #[inline(always)]
    pub(super) fn remembered(
        &mut self,
        touching: &Touching<S>,
        who: (usize, Partner),
    ) -> Option<Mean<S>> {
        let own = self.rule.remembers() && touching.hard.is_none();
        own.then(|| self.own_force(touching, who))
    }

    fn own_force(&mut self, touching: &Touching<S>, (i, with): (usize, Partner)) -> Mean<S> {
        // A contact that holds on beyond the touch does not end with it.
        let reach = self.rule.reach(&touching.impact);
        let goes_on = reach > S::zero() && self.particles.contacts.has(i, with);
        let (depth, share) =
            if goes_on { (touching.overlap, S::one()) } else { touching.span(self.step) };
        let nothing =
            Mean { force: S::zero(), frequency: S::zero(), share, depth, elastic: S::zero() };
        let state = match Contacts(&mut *self.particles.contacts.0).of(i, with) {
            Ok(state) => state,
            Err(full) => {
                self.full = self.full.or(Some(full));
                return nothing;
            }
        };
        let now = [depth, touching.rate];
        let force = self.rule.remembered_force(&touching.impact, now, state.remember());
        Mean { force: force * share, elastic: force.max(S::zero()), ..nothing }
    }

    /// How far beyond the touch two grains hold each other: not before they have touched.
    #[inline(always)]
    pub(super) fn reach(&self, (a, i): (&Body<S, D>, usize), (b, k): (&Body<S, D>, usize)) -> S {
        if !self.rule.remembers() {
            return S::zero();
        }
        let reach = self.rule.reach(&with_grain(a, b));
        let holds = reach > S::zero() && self.particles.contacts.has(i, Partner::grain(k));
        if holds { reach } else { S::zero() }
    }

    /// Whether a plane, or the facet whose plane it is, holds a grain that touches it no longer, and overlaps it by this little.
    #[inline(always)]
    pub(super) fn holds_at(
        &self,
        body: &Body<S, D>,
        plane: &Plane<S, D>,
        ((i, with), overlap): ((usize, Partner), S),
    ) -> bool {
        if !self.rule.remembers() {
            return false;
        }
        let impact = with_plane(body, plane, overlap, self.middle).impact;
        overlap > -self.rule.reach(&impact) && self.particles.contacts.has(i, with)
    }
}

impl<S: Scalar, const D: usize, R: Rule<S>, O> Forces<'_, '_, S, D, R, O> {
    /// A contact goes on from facet to facet: one that begins takes over what that remembers whose edge the body has left for
    /// a neighbour's, though it is still as near.
    #[inline(always)]
    pub(super) fn follow(
        &mut self,
        (i, position): (usize, &Vector<S, D>),
        (k, reach): (usize, S),
        obstacles: &Obstacles<'_, S, D>,
    ) {
        if !self.rule.remembers() && self.rule.inertia().is_none() {
            return;
        }
        let contacts = &mut self.particles.contacts;
        if contacts.has(i, Partner::facet(k)) {
            return;
        }
        let now = self.middle;
        let is_left = |p: &usize| {
            *p != k
                && contacts.has(i, Partner::facet(*p))
                && obstacles.distance(*p, position, now).is_some_and(|distance| distance < reach)
                && obstacles.touched(position, (*p, reach), now).is_none()
        };
        if let Some(p) = obstacles.near(position, now).find(is_left) {
            contacts.hand_over(i, [Partner::facet(p), Partner::facet(k)]);
        }
    }
}

/// Contacts that have ended are forgotten: those of two that sleep go on.
pub(super) fn forget<S: Scalar, const D: usize>(particles: &mut Particles<'_, S, D>) {
    let bodies = &*particles.bodies;
    let moves = |x: usize| bodies.get(x).is_some_and(|body: &Body<S, D>| !body.is_asleep());
    particles.contacts.forget(|first, second| moves(first) || second.as_grain().is_some_and(moves));
}
