//! Could a third body disturb a contact of two? Reads who is near; writes nothing.

use crate::particle::{Body, Partner};
use crate::scalar::{Scalar, Vector, WideProduct, dot, norm};
use crate::space::{Domain, Particles, Plane, crowd_gap, flight};

/// A grain that takes part in a contact.
#[derive(Clone, Copy)]
pub(crate) struct Party<'a, S: Scalar, const D: usize> {
    pub grain: usize,
    /// As it is now.
    pub body: &'a Body<S, D>,
    /// The velocity of the centre of those that take part, in its image.
    pub velocity: Vector<S, D>,
    /// The largest speed that the contact gives it against that centre.
    pub speed: S,
}

/// With what a contact is besides, and how long.
#[derive(Clone, Copy)]
pub(crate) struct Course<S> {
    /// The plane that takes part; nothing if grains only do.
    pub with: Partner,
    pub duration: S,
}

/// Whether something else could touch those that take part in a contact before it ends: a bound on the paths of
/// all that are near. What comes from further off breaks the contact off when it touches.
pub(crate) fn is_crowded<S: Scalar, const D: usize>(
    particles: &Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    now: S,
    parties: &[Party<'_, S, D>],
    course: &Course<S>,
) -> bool {
    let crowd =
        Crowd { particles, domain, now, course, fall: norm(domain.gravity()) * course.duration };
    if parties.iter().any(|party| crowd.plane_nears(party) || crowd.obstacle_nears(party)) {
        return true;
    }
    let mut crowded = false;
    for (n, Party { body, .. }) in parties.iter().enumerate() {
        // Of two in one cell the larger sees further.
        let has_seen = |other: &Body<S, D>| other.cell == body.cell && other.radius >= body.radius;
        if parties.iter().take(n).any(|other| has_seen(other.body)) {
            continue;
        }
        particles.cells.for_each_near(body.cell, body.radius, |k| {
            let is_third = parties.iter().all(|party| party.grain != k);
            crowded = crowded || is_third && crowd.nears(parties, k);
        });
    }
    crowded
}

struct Crowd<'a, S: Scalar, const D: usize> {
    particles: &'a Particles<'a, S, D>,
    domain: &'a Domain<'a, S, D>,
    now: S,
    course: &'a Course<S>,
    /// What gravity adds to a speed meanwhile.
    fall: S,
}

impl<S: Scalar, const D: usize> Crowd<'_, S, D> {
    fn plane_nears(&self, party: &Party<'_, S, D>) -> bool {
        let planes = self.domain.boundary.planes().iter().enumerate();
        let mut others = planes.filter(|&(p, _)| Partner::plane(p) != self.course.with);
        others.any(|(_, plane)| self.is_near(party, plane))
    }

    /// A contact with an obstacle is never one of two alone: none takes part.
    #[inline(always)]
    fn obstacle_nears(&self, party: &Party<'_, S, D>) -> bool {
        let position = &party.body.position;
        self.domain.boundary.obstacles().is_some_and(|obstacles| {
            let mut planes = obstacles
                .near(position, self.now)
                .filter_map(|k| self.domain.boundary.facet_plane(k, position, self.now));
            planes.any(|plane| self.is_near(party, &plane))
        })
    }

    #[inline(always)]
    fn is_near(&self, party: &Party<'_, S, D>, plane: &Plane<S, D>) -> bool {
        let shaken = plane.peak_speed() + plane.peak_speed();
        let nears = -dot(&plane.normal, &party.velocity) + self.fall + shaken;
        let room = (party.speed + nears.max(S::zero())) * self.course.duration;
        plane.gap(&party.body.position, party.body.radius, self.now) < room
    }

    /// Whether grain `k` comes as near as that to one of them.
    fn nears(&self, parties: &[Party<'_, S, D>], k: usize) -> bool {
        let Some(other) = self.particles.body(k) else { return false };
        let (position, velocity, sinks) = if other.is_supported() {
            let there = flight::at(other, self.domain, self.now);
            (there.position, there.velocity, self.fall)
        } else {
            let (position, velocity) = flight::free(other, self.domain, self.now);
            (position, velocity, S::zero())
        };
        parties.iter().any(|Party { body, velocity: centre, speed, .. }| {
            let relative = [body.position - position, centre - velocity];
            let [apart, moves] = self.domain.boundary.relative(relative, self.now);
            let (touching, most) =
                (body.radius + other.radius, crowd_gap(body.radius.max(other.radius)));
            // Most are further off: seen without a root. Rounding is the exact test's affair.
            let far = (touching + most) * (S::one() + S::from_f32(1.0 / 64.0));
            if S::dot(&apart, &apart) > far.times(far) {
                return false;
            }
            let distance = norm(&apart);
            let nears = S::dot(&apart, &-moves).divided_by(distance);
            let room = (*speed + nears.max(S::zero()) + sinks) * self.course.duration;
            distance - touching < room.min(most)
        })
    }
}
