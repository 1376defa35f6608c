//! What happens when a grain touches a facet of an obstacle? Reads the grain, the facet and the rule; writes the grain.
//!
//! It touches the plane across the way from the nearest point of the facet. Where the rule has forces they decide, step by
//! step: beside an edge or a corner that plane turns while the contact lasts.

use super::accept_answer::ask;
use super::context::Context;
use super::crowded_collision::{break_off, is_held, join, kick, min_parting_speed};
use super::effects::{EventOutcome, Incident};
use super::{plane_collision, surface_collision};
use crate::error::Error;
use crate::law::{Response, Rule};
use crate::particle::Partner;
use crate::scalar::{Scalar, dot};

/// After so many fast collisions each soon after the last, forces decide. A narrow corner gives many before it lets a grain
/// out again, π over its angle, and forces would not hold one that is fast.
const MAX_FAST: u16 = 4096;

/// The facet that is touched, if there are any.
#[inline(always)]
pub(super) fn touched<S: Scalar, const D: usize>(
    context: &Context<'_, '_, S, D>,
    partner: Partner,
) -> Option<usize> {
    context.domain.boundary.obstacles().and_then(|_| partner.as_facet())
}

/// Grain `i` touches facet `k`.
#[inline(never)]
pub(super) fn touch<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    rule: &impl Rule<S>,
    (i, k): (usize, usize),
) -> Result<EventOutcome<S>, Error> {
    if let Some(joined) = break_off(context, rule, [Some(i), None]) {
        return Ok(joined);
    }
    let (domain, body) = (context.domain, context.present(i));
    let Some(plane) = domain.boundary.facet_plane(k, &body.position, context.now()) else {
        return Ok(EventOutcome::Unchanged);
    };
    let speed = plane.motion(context.now()).speed - dot(&plane.normal, &body.velocity);
    let speed = speed.max(S::zero());
    let weight = -dot(&plane.normal, domain.gravity());
    let impact = plane_collision::impact(&body, &plane, speed, weight);
    let restitution = plane.surface.restitution();
    let lasts = restitution.is_none() && rule.force(&impact, S::zero()).is_some();
    let is_slow = speed <= context.parameters.settings.slow_speed(body.radius);
    let may_be_held = is_slow || body.consecutive_collisions >= MAX_FAST;
    if lasts || may_be_held && is_held(context, [&body], (speed, body.radius)) {
        return Ok(join(context, [Some(i), None]));
    }
    let with = Partner::facet(k);
    let response = match restitution {
        Some(restitution) => Response::Instantaneous(restitution),
        None => ask(rule, &impact, context.effects, (i, with))?,
    };
    let restitution = match response {
        Response::Instantaneous(restitution) => restitution,
        // What lasts, but has no force law by which it could go on, happens at once.
        Response::Lasting(outcome) => outcome.restitution,
        Response::Refused { .. } | Response::Overflow(_) => return Ok(EventOutcome::Unchanged),
    };
    context.count(Incident::PlaneCollision);
    let least = min_parting_speed(&body.velocity);
    let away = (speed * restitution).max(least) + speed;
    kick(context, (i, &body, body.radius), plane.normal * away);
    surface_collision::act(context, rule, || {
        plane_collision::touch((i, with), &plane, speed, restitution)
    });
    Ok(EventOutcome::Collision { restitution })
}
