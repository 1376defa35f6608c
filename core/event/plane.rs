//! What happens when a grain touches a plane? Reads the grain, the plane and the rule; writes the grain.

use super::apply::{Deed, ask, unbroken, without};
use super::scene::Scene;
use crate::fault::Fault;
use crate::law::{Encounter, Outcome, Response, Rule};
use crate::matter::{Body, Partner, Plane, Surface};
use crate::number::Scalar;

/// A grain touches a plane.
pub(super) fn meet<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    rule: &impl Rule<S>,
    i: usize,
    p: usize,
) -> Result<Deed<S>, Fault> {
    let Some(plane) = scene.boundary.planes().get(p).copied() else { return Ok(Deed::Wander) };
    let mut body = scene.present(i);
    let radial = plane.normal.dot(&body.velocity);
    if radial > S::zero() {
        // The peak of a flight below the surface, where only rounding is left of the speed.
        body.velocity = without(&body.velocity, &plane.normal);
    }
    let radial = radial.smaller(S::zero());
    let response = match plane.surface {
        Surface::Hard(restitution) => Response::Instant(restitution),
        Surface::Rule => {
            let encounter = encounter(&body, -radial, plane.normal.dot(&scene.gravity));
            ask(rule, &encounter, &mut scene.counters, (i, Partner::plane(p)))?
        }
    };
    scene.counters.plane_collisions += 1;
    match response {
        Response::Lasting(outcome) => Ok(contact(scene, (i, p), &body, &plane, &outcome)),
        Response::Instant(restitution) => Ok(bounce(scene, i, &body, &plane, restitution)),
        Response::Refused { .. } => Ok(Deed::Wander),
    }
}

/// Against a plane the other body is infinitely heavy and flat, and nothing turns.
///
/// Under gravity a contact slower than the fall through 5e-7 R is given the duration of that speed:
/// below it the weight, not the impact, decides how long a contact lasts.
fn encounter<S: Scalar, const D: usize>(body: &Body<S, D>, speed: S, g: S) -> Encounter<S> {
    let floor = S::from_f64(1e-3) * (g.magnitude() * body.radius).sqrt();
    Encounter {
        reach: body.radius,
        effective_radius: body.radius,
        reduced_mass: body.mass,
        normal_speed: speed.larger(floor),
        tangential_speed: S::zero(),
        materials: [body.material; 2],
    }
}

fn bounce<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    i: usize,
    body: &Body<S, D>,
    plane: &Plane<S, D>,
    restitution: S,
) -> Deed<S> {
    let radial = plane.normal.dot(&body.velocity);
    let change = plane.normal * (-(S::one() + restitution) * radial);
    scene.place(i, Body { velocity: body.velocity + change, ..*body });
    Deed::Collision { restitution }
}

/// E^φ against a plane: the grain stays at ε_r R from it for the contact duration; the motion along
/// the plane goes on. If it cannot be put there it stays where it is.
///
/// So that gravity does not press the grain into the plane meanwhile, it starts with the normal
/// velocity −g_n τ/2 and is back where it was at the end. The momentum m g τ that gravity brings
/// during a real contact is left out: an error of gτ in the velocity, gτ/v_n relative to the impact.
fn contact<S: Scalar, const D: usize>(
    scene: &mut Scene<'_, S, D>,
    (i, p): (usize, usize),
    body: &Body<S, D>,
    plane: &Plane<S, D>,
    outcome: &Outcome<S>,
) -> Deed<S> {
    let n = &plane.normal;
    let radial = n.dot(&body.velocity);
    let shift =
        body.radius * (outcome.separation - S::one()) - plane.gap(&body.position, body.radius);
    let mut position = body.position + n * shift;
    if !scene.is_free(i, position, Partner::plane(p)) {
        scene.counters.rotation_refused += 1;
        position = body.position;
    }
    let hold = -n.dot(&scene.gravity) * outcome.duration * S::half();
    let bound = Body {
        position,
        velocity: without(&body.velocity, n) + n * hold,
        release: n * (-radial * outcome.restitution),
        release_at: scene.now + outcome.duration,
        unbroken_until: unbroken(scene.now, outcome.duration),
        partner: Partner::plane(p),
        ..*body
    };
    scene.relocate(i, bound);
    Deed::Contact(*outcome)
}
