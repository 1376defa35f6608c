//! Is there room for a body somewhere? Reads bodies and planes; writes nothing.

use crate::particle::{Body, Partner};
use crate::scalar::{Scalar, Vector};
use crate::space::{Domain, Particles, flight};

/// Whether a grain can stand at `position`: it overlaps nothing but `except` more than it does now.
pub(super) fn is_free<S: Scalar, const D: usize>(
    particles: &Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    now: S,
    (grain, position, except): (usize, Vector<S, D>, Partner),
) -> bool {
    let me = particles.present(grain, domain, now);
    let inside = domain.boundary.wrap(position);
    let radii = [me.radius, particles.largest_radius];
    is_free_of_planes(domain, now, &me, (position, except)) && {
        let mut free = true;
        particles.cells.for_each_touching(&inside, radii, |k| {
            let other = particles.body(k).filter(|_| k != grain && Partner::grain(k) != except);
            free &= other.is_none_or(|other| is_free_of(domain, now, &me, (position, other)));
        });
        free
    }
}

/// Whether `me` at `position` keeps clear of another body, wherever that is now.
fn is_free_of<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    now: S,
    me: &Body<S, D>,
    (position, other): (Vector<S, D>, &Body<S, D>),
) -> bool {
    let there = place_of(domain, now, other);
    let reach = me.radius + other.radius;
    let then = domain.boundary.nearest(position - there);
    if S::dot(&then, &then) >= reach.times(reach) {
        return true;
    }
    let before = domain.boundary.nearest(me.position - there);
    S::dot(&then, &then) >= S::dot(&before, &before)
}

/// Where a body is: most fly freely, and of those nothing else is needed.
#[inline]
fn place_of<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    now: S,
    body: &Body<S, D>,
) -> Vector<S, D> {
    if body.is_supported() {
        return flight::at(body, domain, now).position;
    }
    flight::free(body, domain, now).0
}

fn is_free_of_planes<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    now: S,
    me: &Body<S, D>,
    (position, except): (Vector<S, D>, Partner),
) -> bool {
    let planes = domain.boundary.planes().iter().enumerate();
    planes.filter(|&(p, _)| Partner::plane(p) != except).all(|(_, plane)| {
        let then = plane.gap(&position, me.radius, now);
        then >= S::zero() || then >= plane.gap(&me.position, me.radius, now)
    })
}
