//! When does a body touch a facet? Reads both; writes nothing.
//!
//! BSFP14's rule (Eq. 10) for f = distance − R. Along a flight the distance to a facet is a convex function of time, but
//! for gravity: f̈ ≥ −g. So the search with brackets finds the first event wherever it is, at the face, an edge or a
//! corner, and steps over none. Before it comes the closed form: the distance to a facet is at least that to the plane
//! through it, so nothing happens before that plane is touched, and it happens then if that is beside the face.

use super::bracketed_root::{Found, Search};
use super::root;
use crate::particle::Body;
use crate::scalar::{Scalar, Vector, WideProduct, component, dot, norm};
use crate::space::{Domain, Facet};

/// So often a search goes on where it paused.
const ROUNDS: usize = 16;

/// What the closed form says of a facet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Face<S> {
    /// It is touched then, beside its face.
    Touched(S),
    /// Its edges may be touched, not before this.
    PerhapsAfter(S),
    /// It is not touched before the limit.
    Missed,
}

/// How long after its own clock a body that flies freely touches a facet: BSFP14's rule. After a limit nobody asks.
pub(super) fn body_and_facet<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    me: &Body<S, D>,
    (facet, limit): (&Facet<S, D>, S),
) -> Found<S> {
    let mut from = match body_and_face(domain, me, (facet, limit)) {
        Face::Touched(span) => return Found::Event(span),
        Face::Missed => return Found::Nothing,
        // What begins with the earliest event known comes too late.
        Face::PerhapsAfter(span) if span > S::zero() && span >= limit => return Found::Nothing,
        Face::PerhapsAfter(span) => span,
    };
    let flight = Flight { me, acceleration: domain.gravity() };
    for _ in 0..ROUNDS {
        match flight.search(facet, (from, limit)) {
            Found::Event(span) => return Found::Event(from + span),
            Found::Nothing => return Found::Nothing,
            Found::NotBefore(span) => from += span,
        }
    }
    Found::NotBefore(from)
}

/// The same of its face alone, in closed form.
pub(super) fn body_and_face<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    me: &Body<S, D>,
    (facet, limit): (&Facet<S, D>, S),
) -> Face<S> {
    let flight = Flight { me, acceleration: domain.gravity() };
    let height = facet.height(&me.position);
    let gap = height.abs() - me.radius;
    if gap > S::zero() || facet.is_beside_face(&me.position) {
        let side = if height < S::zero() { -S::one() } else { S::one() };
        let [v, a] = [&me.velocity, flight.acceleration].map(|x| dot(facet.normal(), x) * side);
        let margin = me.radius * S::from_f32(1.0 / 256.0);
        if root::stays_above(margin, [gap, v, a], limit) {
            return Face::Missed;
        }
        let Some(span) = root::plane(gap, v, a).filter(|span| *span <= limit) else {
            return Face::Missed;
        };
        let (there, _) = flight.at(span);
        return match flight.is_far(facet, (span, limit)) {
            true => Face::Missed,
            false if facet.is_beside_face(&there) => Face::Touched(span),
            false => Face::PerhapsAfter(span),
        };
    }
    match flight.is_far(facet, (S::zero(), limit)) {
        true => Face::Missed,
        false => Face::PerhapsAfter(S::zero()),
    }
}

/// A body that flies freely, from its own clock on.
struct Flight<'a, S: Scalar, const D: usize> {
    me: &'a Body<S, D>,
    acceleration: &'a Vector<S, D>,
}

impl<S: Scalar, const D: usize> Flight<'_, S, D> {
    /// Position and velocity after a span.
    fn at(&self, span: S) -> (Vector<S, D>, Vector<S, D>) {
        let way = (self.me.velocity + self.acceleration * (span * S::half())) * span;
        (self.me.position + way, self.me.velocity + self.acceleration * span)
    }

    /// Whether the body cannot touch a facet from one span to another: along some axis it does not come as near.
    fn is_far(&self, facet: &Facet<S, D>, (from, limit): (S, S)) -> bool {
        let (there, velocity) = self.at(from);
        let left = limit - from;
        let [low, high] = facet.extent();
        let slack = S::one() + S::from_f32(1.0 / 64.0);
        (0..D).any(|axis| {
            let [x, v, a] =
                [&there, &velocity, self.acceleration].map(|vector| component(vector, axis));
            let way = (v.abs() + a.abs() * S::half() * left) * left;
            let reach = (self.me.radius + way) * slack;
            // What is no number, as a time without end times zero, says nothing.
            x - component(&high, axis) > reach || component(&low, axis) - x > reach
        })
    }

    /// How long after a span the body touches a facet.
    fn search(&self, facet: &Facet<S, D>, (from, limit): (S, S)) -> Found<S> {
        let radius = self.me.radius;
        let bound = norm(self.acceleration).max(S::negligible_acceleration(radius));
        let (_, v) = self.at(from);
        // Where it passes an edge or a corner the distance grows by v²/r.
        let most = bound + S::dot(&v, &v).divided_by(radius);
        Search::new([bound, most], radius, limit - from).first(|t| {
            let (position, velocity) = self.at(from + t);
            facet.nearest(&position).overlap(radius, &velocity)
        })
    }
}
