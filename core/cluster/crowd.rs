//! Could a third body disturb a contact of two? Reads who is near; writes nothing.

use crate::particle::{Body, Partner};
use crate::scalar::{Scalar, Vector, WideProduct, dot, norm};
use crate::space::{Domain, Particles};

/// Whether something besides `with` could touch grain `i`, standing as `body`, within so long: a bound on
/// the paths of all, with the largest speed that the contact gives the grain against the two's centre.
pub(crate) fn is_crowded<S: Scalar, const D: usize>(
    particles: &Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    now: S,
    (i, body, with): (usize, &Body<S, D>, Partner),
    (velocity, speed, duration): (Vector<S, D>, S, S),
) -> bool {
    let fall = norm(domain.gravity()) * duration;
    let mut crowded = false;
    for (p, plane) in domain.boundary.planes().iter().enumerate() {
        let shaken = plane.vibration.map_or(S::zero(), |v| v.peak_speed() + v.peak_speed());
        let nears = -dot(&plane.normal, &velocity) + fall + shaken;
        let room = (speed + nears.max(S::zero())) * duration;
        crowded |= Partner::plane(p) != with && plane.gap(&body.position, body.radius, now) < room;
    }
    particles.cells.for_each_near(body.cell, |k| {
        let other = particles.body(k).filter(|_| k != i && Partner::grain(k) != with && !crowded);
        let Some(other) = other else { return };
        let there = particles.present(k, domain, now);
        let apart = domain.separation(body, &there);
        let distance = norm(&apart);
        let gap = distance - body.radius - other.radius;
        let nears = S::dot(&apart, &(there.velocity - velocity)).divided_by(distance);
        let sinks = if other.is_supported() { fall } else { S::zero() };
        crowded |= gap < (speed + nears.max(S::zero()) + sinks) * duration;
    });
    crowded
}
