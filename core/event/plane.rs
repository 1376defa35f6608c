//! What happens when a grain touches a plane? Reads the grain, the plane and the rule; writes the grain.

use super::apply::{Affected, Deed, ask, without};
use super::contact::unbroken;
use super::scene::Scene;
use super::{bounce, rest};
use crate::fault::Fault;
use crate::law::{Encounter, Outcome, Response, Rule};
use crate::matter::{Body, Partner, Plane, Surface};
use crate::number::{Product, Scalar, dot};

/// A grain touches a plane.
pub(super) fn meet<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    rule: &impl Rule<S>,
    i: usize,
    p: usize,
    affected: &mut Affected,
) -> Result<Deed<S>, Fault> {
    let Some(plane) = scene.boundary.planes().get(p).copied() else { return Ok(Deed::Wander) };
    let mut body = scene.present(i);
    let mut speed = plane.motion(scene.now).speed - dot(&plane.normal, &body.velocity);
    if speed < S::zero() {
        // The peak of a flight below the surface, where only rounding is left of the speed.
        body.velocity += plane.normal * speed;
        speed = S::zero();
    }
    let response = match plane.surface {
        Surface::Hard(restitution) => Response::Instant(restitution),
        Surface::Rule => {
            let weight = plane.motion(scene.now).acceleration - dot(&plane.normal, &scene.gravity);
            let encounter = encounter(&body, speed, weight);
            ask(rule, &encounter, &mut scene.counters, (i, Partner::plane(p)))?
        }
    };
    scene.counters.plane_collisions += 1;
    match response {
        Response::Lasting(outcome) => {
            let after = [speed * outcome.restitution, outcome.restitution, outcome.duration];
            if rest::settles(scene, &body, p, after) {
                return Ok(rest::settle(scene, i, &body, p));
            }
            if is_pulled_off(scene, &body, &plane, outcome.duration) {
                scene.counters.hard_sphere += 1;
                return bounce::plane(scene, (i, p), &body, [speed, outcome.restitution], affected);
            }
            Ok(contact(scene, (i, p), &body, &plane, (speed, &outcome)))
        }
        Response::Instant(restitution) => {
            bounce::plane(scene, (i, p), &body, [speed, restitution], affected)
        }
        Response::Refused { .. } | Response::Overflow(_) => Ok(Deed::Wander),
    }
}

/// Against a plane the other body is infinitely heavy and flat, and nothing turns.
///
/// Under gravity a contact slower than the fall through 5e-7 R is given the duration of that speed:
/// below it the weight, not the impact, decides how long a contact lasts.
fn encounter<S: Scalar, const D: usize>(body: &Body<S, D>, speed: S, g: S) -> Encounter<S> {
    let floor = S::from_f64(1e-3) * g.magnitude().times(body.radius).root();
    Encounter {
        reach: body.radius,
        effective_radius: body.radius,
        reduced_mass: body.mass,
        normal_speed: speed.larger(floor),
        tangential_speed: S::zero(),
        materials: [body.material; 2],
    }
}

/// Whether gravity points away from a plane and would move the grain visibly, by more than a 64th of its
/// radius, during the contact: g τ²/8 is how far the contact below would bend its path into the plane.
pub(super) fn is_pulled_off<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    body: &Body<S, D>,
    plane: &Plane<S, D>,
    duration: S,
) -> bool {
    let away = dot(&plane.normal, &scene.gravity) * duration;
    away > S::zero() && away.times(duration) > body.radius.times(S::from_f32(0.125))
}

/// E^φ against a plane: the grain stays at ε_r R from it for the contact duration; the motion along
/// the plane goes on. If it cannot be put there it stays where it is.
///
/// So that gravity and the plane's own motion do not press the grain into the plane meanwhile, it
/// starts with the normal velocity ż₀ + (z̈₀ − g_n) τ/2 and is at the same distance at the end. The
/// momentum that they bring during a real contact is left out: an error of (z̈₀ − g_n) τ in the
/// velocity. A grain too slow to outlast it comes to rest instead.
fn contact<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    (i, p): (usize, usize),
    body: &Body<S, D>,
    plane: &Plane<S, D>,
    (speed, outcome): (S, &Outcome<S>),
) -> Deed<S> {
    let n = &plane.normal;
    let shift = body.radius * (outcome.separation - S::one())
        - plane.gap(&body.position, body.radius, scene.now);
    let mut position = body.position + n * shift;
    if !scene.is_free(i, position, Partner::plane(p)) {
        scene.counters.rotation_refused += 1;
        position = body.position;
    }
    let release_at = scene.now + outcome.duration;
    let (now, later) = (plane.motion(scene.now), plane.motion(release_at));
    let along = match plane.vibration {
        Some(_) => (later.place - now.place) / outcome.duration.larger(scene.now.rounding()),
        None => S::zero(),
    };
    let hold = along - dot(n, &scene.gravity) * outcome.duration * S::half();
    let velocity = without(&body.velocity, n) + n * hold;
    let there = Body { position, velocity, ..*body };
    let bound = Body {
        release: n * (later.speed + speed * outcome.restitution),
        release_at,
        moment: unbroken(scene, &there, outcome.duration),
        partner: Partner::plane(p),
        ..there
    };
    scene.relocate(i, bound.let_go());
    Deed::Contact(*outcome)
}
