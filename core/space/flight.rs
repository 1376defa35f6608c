//! Where is a grain at a time? Free flight, sliding on planes, riding on plates: the only place where time moves a position.

use super::boundary::Boundary;
use super::domain::Domain;
use super::plane::Plane;
use crate::particle::Body;
use crate::scalar::{Scalar, Vector, dot};

/// The grain's constant acceleration: gravity, less what holds it.
pub fn acceleration<S: Scalar, const D: usize>(
    body: &Body<S, D>,
    domain: &Domain<'_, S, D>,
) -> Vector<S, D> {
    if !body.is_supported() {
        return *domain.gravity();
    }
    if body.is_asleep() {
        return Vector::zeros();
    }
    let (mut left, mut taken) = (*domain.gravity(), [S::zero(); u8::BITS as usize]);
    // A second round is for planes that are not quite at right angles: there a plane gives back what it
    // has taken too much.
    for _ in 0..2 {
        let planes = domain.boundary.planes().iter().enumerate();
        for ((p, plane), taken) in planes.zip(&mut taken) {
            if !body.rests_on(p) {
                continue;
            }
            let pushed = dot(&plane.normal, &left);
            let takes = if plane.vibration().is_some() { pushed } else { pushed.min(*taken) };
            left -= plane.normal * takes;
            *taken -= takes;
        }
    }
    left
}

/// The vibrating plates that carry a body: more than one in a corner.
pub fn carrying_plates<'a, S: Scalar, const D: usize>(
    body: &Body<S, D>,
    domain: &'a Domain<'_, S, D>,
) -> impl Iterator<Item = &'a Plane<S, D>> {
    let on = if body.is_supported() { body.planes } else { 0 };
    let planes = domain.boundary.planes().iter().enumerate();
    let carries =
        move |p: usize| u32::try_from(p).is_ok_and(|p| on.checked_shr(p).unwrap_or(0) & 1 == 1);
    planes.filter(move |&(p, plane)| plane.moves() && carries(p)).map(|(_, plane)| plane)
}

/// The body at time `now`, its clock set there; everything else as it was: r + v t + g t²/2.
#[cfg_attr(target_pointer_width = "64", inline)]
#[cfg_attr(not(target_pointer_width = "64"), inline(never))]
pub fn at<S: Scalar, const D: usize>(
    body: &Body<S, D>,
    domain: &Domain<'_, S, D>,
    now: S,
) -> Body<S, D> {
    let mut there = *body;
    advance(&mut there, domain, now);
    there
}

/// The same for a body that something supports.
#[inline(never)]
fn held<S: Scalar, const D: usize>(
    body: &Body<S, D>,
    domain: &Domain<'_, S, D>,
    now: S,
) -> Body<S, D> {
    let span = now - body.clock;
    let (position, velocity) = after(body, &acceleration(body, domain), &domain.boundary, span);
    let mut there = Body { position, velocity, clock: now, ..*body };
    for plate in carrying_plates(body, domain) {
        // Along the normal it moves as the plate does, not by a velocity of its own: rounding cannot add up.
        let (then, later, n) = (plate.motion(body.clock), plate.motion(now), &plate.normal);
        let speed = dot(n, &body.velocity);
        there.position += n * ((later.place - then.place) - speed * span);
        there.velocity += n * (later.speed - speed);
    }
    there
}

/// Position and velocity of a body that nothing holds: r + v t + g t²/2 and v + g t.
#[inline]
pub fn free<S: Scalar, const D: usize>(
    body: &Body<S, D>,
    domain: &Domain<'_, S, D>,
    now: S,
) -> (Vector<S, D>, Vector<S, D>) {
    let span = now - body.clock;
    if domain.is_weightless() {
        let way = domain.boundary.on_lattice(body.velocity * span);
        return (body.position + way, body.velocity);
    }
    after(body, domain.gravity(), &domain.boundary, span)
}

#[inline]
fn after<S: Scalar, const D: usize>(
    body: &Body<S, D>,
    a: &Vector<S, D>,
    boundary: &Boundary<S, D>,
    span: S,
) -> (Vector<S, D>, Vector<S, D>) {
    let way = (body.velocity + a * (span * S::half())) * span;
    (body.position + boundary.on_lattice(way), body.velocity + a * span)
}

/// Lets the grain move until `now`.
#[cfg_attr(target_pointer_width = "64", inline)]
#[cfg_attr(not(target_pointer_width = "64"), inline(never))]
pub fn advance<S: Scalar, const D: usize>(
    body: &mut Body<S, D>,
    domain: &Domain<'_, S, D>,
    now: S,
) {
    if body.is_supported() {
        *body = held(body, domain, now);
        return;
    }
    (body.position, body.velocity) = free(body, domain, now);
    body.clock = now;
}
