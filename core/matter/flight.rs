//! Where is a grain at a time? Free flight, sliding on planes, riding on plates: the only place where time moves a position.

use super::boundary::Boundary;
use super::grain::Body;
use super::plane::Plane;
use crate::number::{Scalar, Vector, dot};

/// What moves grains between events: gravity, and the planes that hold those at rest on them.
#[derive(Clone, Copy)]
pub struct Field<'a, S: Scalar, const D: usize> {
    /// Uniform gravity.
    pub gravity: &'a Vector<S, D>,
    /// Whether gravity is zero: what a flight need not be asked.
    pub weightless: bool,
    /// The planes, and how they move.
    pub boundary: &'a Boundary<'a, S, D>,
}

/// Whether there is no gravity.
pub fn is_weightless<S: Scalar, const D: usize>(gravity: &Vector<S, D>) -> bool {
    gravity.iter().all(|&g| g == S::zero())
}

/// The grain's constant acceleration: gravity, less what holds it.
pub fn acceleration<S: Scalar, const D: usize>(
    body: &Body<S, D>,
    field: Field<'_, S, D>,
) -> Vector<S, D> {
    if !body.is_held() {
        return *field.gravity;
    }
    if body.is_frozen() {
        return Vector::zeros();
    }
    let mut held = *field.gravity;
    // A second round is for planes that are not at right angles.
    for _ in 0..2 {
        for (p, plane) in field.boundary.planes().iter().enumerate() {
            let pushed = dot(&plane.normal, &held);
            if body.rests_on(p) && (pushed < S::zero() || plane.vibration.is_some()) {
                held -= plane.normal * pushed;
            }
        }
    }
    held
}

/// The vibrating plates that carry a body: more than one in a corner.
pub fn plates<'a, S: Scalar, const D: usize>(
    body: &Body<S, D>,
    field: Field<'a, S, D>,
) -> impl Iterator<Item = &'a Plane<S, D>> {
    let on = if body.is_held() { body.planes } else { 0 };
    let planes = field.boundary.planes().iter().enumerate();
    let carries =
        move |p: usize| u32::try_from(p).is_ok_and(|p| on.checked_shr(p).unwrap_or(0) & 1 == 1);
    planes
        .filter(move |&(p, plane)| plane.vibration.is_some() && carries(p))
        .map(|(_, plane)| plane)
}

/// The body at time `now`, its clock set there; everything else as it was: r + v t + g t²/2.
pub fn at<S: Scalar, const D: usize>(
    body: &Body<S, D>,
    field: Field<'_, S, D>,
    now: S,
) -> Body<S, D> {
    let span = now - body.clock;
    if !body.is_held() {
        let (position, velocity) = free(body, field, now);
        return Body { position, velocity, clock: now, ..*body };
    }
    let (position, velocity) = after(body, &acceleration(body, field), field.boundary, span);
    let mut there = Body { position, velocity, clock: now, ..*body };
    for plate in plates(body, field) {
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
    field: Field<'_, S, D>,
    now: S,
) -> (Vector<S, D>, Vector<S, D>) {
    let span = now - body.clock;
    if field.weightless {
        let way = field.boundary.on_lattice(body.velocity * span);
        return (body.position + way, body.velocity);
    }
    after(body, field.gravity, field.boundary, span)
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
pub fn advance<S: Scalar, const D: usize>(body: &mut Body<S, D>, field: Field<'_, S, D>, now: S) {
    *body = at(body, field, now);
}
