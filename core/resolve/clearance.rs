//! Is there room for a body somewhere? Reads bodies and planes; writes nothing.

use crate::particle::{Body, Partner};
use crate::scalar::{Scalar, Vector};
use crate::space::{Domain, Particles, flight};

/// What room there is for a grain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Room {
    /// It would overlap something.
    None,
    /// It can stand there.
    Enough,
    /// And no other grain is nearer to touching it than by a margin.
    Alone,
}

/// Whether a grain can stand at `position`: it overlaps nothing but `except` more than it does now.
pub(super) fn is_free<S: Scalar, const D: usize>(
    particles: &Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    now: S,
    (grain, position, except): (usize, Vector<S, D>, Partner),
) -> bool {
    let me = particles.present(grain, domain, now);
    room(particles, domain, now, ((grain, &me), position, except), None) != Room::None
}

/// The same of a grain as it is now, and whether others are near there: by less than this margin, which is at most a 64th of the radius.
pub(super) fn room<S: Scalar, const D: usize>(
    particles: &Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    now: S,
    ((grain, me), position, except): ((usize, &Body<S, D>), Vector<S, D>, Partner),
    margin: Option<S>,
) -> Room {
    let inside = domain.boundary.place_inside(position, now);
    let radii = [me.radius, particles.largest_radius];
    let is_free = is_free_of_planes(domain, now, me, (position, except))
        && is_free_of_obstacles(domain, now, me, position);
    if !is_free {
        return Room::None;
    }
    let mut room = if margin.is_some() { Room::Alone } else { Room::Enough };
    let margin = margin.unwrap_or(S::zero());
    particles.cells.for_each_touching(&inside, radii, |k| {
        let other = particles.body(k).filter(|_| k != grain && Partner::grain(k) != except);
        let Some(other) = other else { return };
        room = match room_beside(domain, now, (me, margin), (position, other)) {
            Room::Alone => room,
            Room::Enough if room != Room::None => Room::Enough,
            _ => Room::None,
        };
    });
    room
}

/// Whether `me` at `position` keeps clear of another body, wherever that is now.
fn room_beside<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    now: S,
    (me, margin): (&Body<S, D>, S),
    (position, other): (Vector<S, D>, &Body<S, D>),
) -> Room {
    let there = place_of(domain, now, other);
    let reach = me.radius + other.radius;
    let nearest = |apart| {
        let [nearest, _] = domain.boundary.relative([apart, Vector::zeros()], now);
        nearest
    };
    let then = nearest(position - there);
    let (apart, near) = (S::dot(&then, &then), reach + margin);
    if apart >= near.times(near) {
        return Room::Alone;
    }
    if apart >= reach.times(reach) {
        return Room::Enough;
    }
    let before = nearest(me.position - there);
    if apart >= S::dot(&before, &before) { Room::Enough } else { Room::None }
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

fn is_free_of_obstacles<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    now: S,
    me: &Body<S, D>,
    position: Vector<S, D>,
) -> bool {
    let Some(obstacles) = domain.boundary.obstacles() else { return true };
    obstacles.near(&position, now).all(|k| {
        let distance = |at| obstacles.distance(k, at, now).unwrap_or(S::NEVER);
        let then = distance(&position);
        then >= me.radius || then >= distance(&me.position)
    })
}
