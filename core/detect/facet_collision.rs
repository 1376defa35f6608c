//! When does a body touch a facet? Reads both; writes nothing.
//!
//! BSFP14's rule (Eq. 10) for f = distance − R. Along a flight the distance to a facet is a convex function of time, but
//! for gravity: f̈ ≥ −g. So the search with brackets finds the first event wherever it is, at the face, an edge or a
//! corner, and steps over none. Before it comes the closed form: the distance to a facet is at least that to the plane
//! through it, so nothing happens before that plane is touched, and it happens then if that is beside the face.

use super::bracketed_root::{Found, Search};
use super::root;
use crate::particle::Body;
use crate::scalar::{Scalar, Vector, WideProduct, dot, max_abs, norm};
use crate::space::{Domain, Facet};

/// So often a search goes on where it paused.
const ROUNDS: usize = 16;

/// What the closed form says of a facet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Face<S> {
    /// It is touched then, beside its face.
    Touched(S),
    /// Its edges may be touched.
    EdgesPerhaps {
        /// When the plane through it is touched: where a search begins, whatever is known to come first.
        plane: S,
        /// Not before this.
        after: S,
    },
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
        Face::EdgesPerhaps { after, .. } if after > S::zero() && after >= limit => {
            return Found::Nothing;
        }
        Face::EdgesPerhaps { plane, .. } => plane,
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
    Flight { me, acceleration: domain.gravity() }.face(facet, limit)
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

    /// When the body touches the face of a facet, or else when it may touch its edges.
    fn face(&self, facet: &Facet<S, D>, limit: S) -> Face<S> {
        let Self { me, acceleration } = self;
        let height = facet.height(&me.position);
        let gap = height.abs() - me.radius;
        if !(gap > S::zero()) && !facet.is_beside_face(&me.position) {
            let beside = facet.beside_by(&me.position).unwrap_or(S::zero());
            return self.edges(S::zero(), [beside, gap], limit);
        }
        let side = if height < S::zero() { -S::one() } else { S::one() };
        let [v, a] = [&me.velocity, *acceleration].map(|x| dot(facet.normal(), x) * side);
        let margin = me.radius * S::from_f32(1.0 / 256.0);
        if root::stays_above(margin, [gap, v, a], limit) {
            return Face::Missed;
        }
        let Some(span) = root::plane(gap, v, a).filter(|span| *span <= limit) else {
            return Face::Missed;
        };
        let (there, _) = self.at(span);
        match facet.beside_by(&there) {
            None => Face::Touched(span),
            // What overlaps, and rises, may do so still when it falls again.
            Some(beside) => self.edges(span, [beside, gap.min(S::zero())], limit),
        }
    }

    /// When the body may touch the edges of a facet, after a span at the end of which it is so far beside its face, and
    /// its distance from the plane through it is by so much more than its radius; that is not positive. Its distance
    /// from the edges shrinks no faster than it flies.
    fn edges(&self, span: S, [beside, gap]: [S; 2], limit: S) -> Face<S> {
        let radius = self.me.radius;
        // d − R of a distance d ≤ R + beside, whose square is (R + gap)² + beside².
        let squares = beside.times(beside) + gap.times(radius + radius + gap);
        let way = squares.divided_by(radius + radius + beside);
        let (there, velocity) = self.at(span);
        let fall = self.acceleration * (limit - span);
        let fast = velocity.iter().chain(fall.iter()).fold(S::zero(), |sum, v| sum + v.abs());
        let later = way / fast * S::from_f32(1.0 - 1.0 / 64.0);
        // What rounding may have made is the search's affair, and what is no number says nothing.
        let rounding = max_abs(&there).rounding() * S::from_f32(64.0);
        let after = if way > rounding && later > S::zero() { span + later } else { span };
        if after > limit { Face::Missed } else { Face::EdgesPerhaps { plane: span, after } }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::particle::Grain;
    use crate::space::Surface;
    use proptest::{prelude::*, test_runner::TestCaseError};

    /// What the closed form says is true at 200 instants of the flight.
    fn is_true<const D: usize>(
        corners: [[f64; D]; D],
        [at, velocity, gravity]: [[f64; D]; 3],
        [radius, limit]: [f64; 2],
    ) -> Result<(), TestCaseError> {
        let facet = Facet::new(corners, Surface::Rule);
        prop_assume!(facet.is_valid());
        let me = Body::new(&Grain::with_mass(radius, 1.0).at(at).moving(velocity));
        let acceleration = Vector::from(gravity);
        let flight = Flight { me: &me, acceleration: &acceleration };
        let gap = |t: f64| facet.nearest(&flight.at(t).0).distance - radius;
        // Of what overlaps at the start nothing is said until it parts.
        prop_assume!(gap(0.0) > 0.0);
        let clear = match flight.face(&facet, limit) {
            Face::Touched(span) => {
                prop_assert!(gap(span).abs() < 1e-9, "{} at {span}", gap(span));
                span
            }
            Face::EdgesPerhaps { plane, after } => {
                prop_assert!(plane <= after);
                after
            }
            Face::Missed => limit,
        };
        for t in (0..200).map(|k| clear * f64::from(k) / 200.0) {
            prop_assert!(gap(t) > -1e-9, "{} at {t} of {clear}", gap(t));
        }
        Ok(())
    }

    proptest! {
        #[test]
        fn no_segment_is_touched_before_it_is_said(
            corners: [[i8; 2]; 2], flight in prop::array::uniform3([-1.0..1.0, -1.0..1.0_f64]), sizes in [0.01..1.0_f64, 0.01..2.0],
        ) {
            is_true(corners.map(|corner| corner.map(|x| f64::from(x) / 128.0)), flight, sizes)?;
        }

        #[test]
        fn nor_is_a_triangle(
            corners: [[i8; 3]; 3], flight in prop::array::uniform3([-1.0..1.0, -1.0..1.0, -1.0..1.0_f64]), sizes in [0.01..1.0_f64, 0.01..2.0],
        ) {
            is_true(corners.map(|corner| corner.map(|x| f64::from(x) / 128.0)), flight, sizes)?;
        }
    }
}
