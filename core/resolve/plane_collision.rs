//! What happens when a grain touches a plane? Reads the grain, the plane and the rule; writes the grain.

use super::accept_answer::ask;
use super::context::Context;
use super::effects::{EventOutcome, Incident};
use super::surface_collision::Touch;
use super::{contact_begin, instantaneous_collision, rest, surface_collision};
use crate::error::Error;
use crate::law::{Impact, Response, Rule};
use crate::particle::{Body, Partner};
use crate::scalar::{Scalar, WideProduct, dot};
use crate::space::{Plane, Surface};

/// Grain `i` touches plane `p`.
pub(super) fn collide<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    rule: &impl Rule<S>,
    (i, p): (usize, usize),
) -> Result<EventOutcome<S>, Error> {
    let Some(plane) = context.domain.boundary.planes().get(p) else {
        return Ok(EventOutcome::Unchanged);
    };
    let mut body = context.present(i);
    let mut speed = plane.motion(context.now()).speed - dot(&plane.normal, &body.velocity);
    if speed < S::zero() {
        // The peak of a flight below the surface, where only rounding is left of the speed.
        body.velocity += plane.normal * speed;
        speed = S::zero();
    }
    let response = match plane.surface {
        Surface::Hard(restitution) => Response::Instantaneous(restitution),
        Surface::Rule | Surface::Material(_) => {
            let fall = dot(&plane.normal, context.domain.gravity());
            let weight = plane.motion(context.now()).acceleration - fall;
            let impact = impact(&body, plane, speed, weight);
            ask(rule, &impact, context.effects, (i, Partner::plane(p)))?
        }
    };
    context.count(Incident::PlaneCollision);
    let outcome =
        respond(context, (i, p), (&body, plane, rest::may_rest(rule)), (speed, response))?;
    if let EventOutcome::Collision { restitution } = outcome {
        let who = (i, Partner::plane(p));
        surface_collision::act(context, rule, || touch(who, plane, speed, restitution));
    }
    Ok(outcome)
}

/// How the surfaces of a grain and a plane touch, in a collision without duration; or of a grain and a facet, whose plane
/// it is.
pub(super) fn touch<S: Scalar, const D: usize>(
    (grain, with): (usize, Partner),
    plane: &Plane<S, D>,
    speed: S,
    restitution: S,
) -> Touch<S, D> {
    let change = speed * (S::one() + restitution);
    Touch { grain, with, normal: plane.normal, change }
}

fn respond<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    (i, p): (usize, usize),
    (body, plane, may_rest): (&Body<S, D>, &Plane<S, D>, bool),
    (speed, response): (S, Response<S>),
) -> Result<EventOutcome<S>, Error> {
    match response {
        Response::Lasting(outcome) => {
            let after = [speed * outcome.restitution, outcome.restitution, outcome.duration];
            if may_rest && rest::comes_to_rest_on(context, body, p, after) {
                return Ok(rest::lay_on_plane(context, i, body, p));
            }
            if contact_begin::is_pulled_off(context, body, plane, outcome.duration) {
                context.count(Incident::HardSphere);
                return instantaneous_collision::reflect(
                    context,
                    (i, p),
                    (body, may_rest),
                    [speed, outcome.restitution],
                );
            }
            Ok(contact_begin::begin_with_plane(context, (i, p), body, plane, (speed, &outcome)))
        }
        Response::Instantaneous(restitution) => instantaneous_collision::reflect(
            context,
            (i, p),
            (body, may_rest),
            [speed, restitution],
        ),
        Response::Refused { .. } | Response::Overflow(_) => Ok(EventOutcome::Unchanged),
    }
}

/// Against a plane the other body is infinitely heavy and flat, and nothing turns; `g` presses the two together.
///
/// Under gravity a contact slower than the fall through 5e-7 R is given the duration of that speed:
/// below it the weight, not the impact, decides how long a contact lasts.
pub(super) fn impact<S: Scalar, const D: usize>(
    body: &Body<S, D>,
    plane: &Plane<S, D>,
    speed: S,
    g: S,
) -> Impact<S> {
    let floor = S::from_f64(1e-3) * g.abs().times(body.radius).sqrt();
    Impact {
        contact_distance: body.radius,
        effective_radius: body.radius,
        reduced_mass: body.mass,
        normal_speed: speed.max(floor),
        tangential_speed: S::zero(),
        acceleration: g,
        materials: plane.surface.materials(body.material),
    }
}
