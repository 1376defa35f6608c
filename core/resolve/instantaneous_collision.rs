//! What does an instantaneous collision leave? Reads two bodies or a body and a plane; writes velocities.
//!
//! Two rules can make it elastic: the TC rule, if the last collision is less than t_c ago (Luding &
//! McNamara, Granul. Matter 1, 113, 1998), and, so that no collapse goes on for ever, a limit to the
//! collisions that follow each other within the rounding of positions.

use super::context::Context;
use super::effects::{EventOutcome, Incident};
use super::impact_frame::ImpactFrame;
use super::support::BEFORE_LANDING;
use super::{rest, wake};
use crate::error::Error;
use crate::particle::{Body, Partner};
use crate::scalar::{Scalar, Vector, dot, max_abs, norm};

/// After so many collisions right after each other they are elastic.
const fn max_consecutive<const D: usize>() -> u16 {
    if D == 1 { 2048 } else { 256 }
}

/// After so many, elastic ones included, the world is stuck.
const STUCK_AFTER: u16 = u16::MAX - 1;

/// An instantaneous collision of two grains (MP13 Eq. 63 with the signs right; BSFP14 Eq. 5).
pub(super) fn collide<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    who: [usize; 2],
    pair: &[Body<S, D>; 2],
    frame: &ImpactFrame<S, D>,
    (restitution, is_slow): (S, bool),
) -> Result<EventOutcome<S>, Error> {
    let [a, b] = pair;
    let [i, k] = who;
    let speed = -frame.radial;
    let [x, y] = [a, b].map(|body| count_with_this(context, body, speed, is_slow));
    let last = a.last_collision().max(b.last_collision());
    let lossy = restitution < S::one();
    let hop = if is_slow { context.parameters.min_hop_time } else { S::zero() };
    let restitution = final_restitution::<S, D>(context, restitution, (last, hop), x.max(y));
    // Hops that lose nothing only because they are slow may end on an elastic plane, too.
    let is_hopping = is_slow && lossy && restitution == S::one();
    let [x, y] = [x, y].map(|n| if is_hopping { n.max(BEFORE_LANDING) } else { n });
    if x.min(y) >= STUCK_AFTER {
        return Err(stuck(context, i, Partner::grain(k), x.min(y)));
    }
    let least = min_parting_speed(&a.velocity) + min_parting_speed(&b.velocity);
    let away = (restitution * speed).max(least);
    let change = frame.along(speed + away);
    let mass = a.mass + b.mass;
    wake::kick(context, i, &counted(a, x), change * (b.mass / mass));
    wake::kick(context, k, &counted(b, y), -change * (a.mass / mass));
    Ok(EventOutcome::Collision { restitution })
}

/// A reflection at plane `p`, that may move, with this speed of approach.
pub(super) fn reflect<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    (i, p): (usize, usize),
    (body, may_rest): (&Body<S, D>, bool),
    [speed, restitution]: [S; 2],
) -> Result<EventOutcome<S>, Error> {
    let Some(plane) = context.domain.boundary.planes().get(p) else {
        return Ok(EventOutcome::Unchanged);
    };
    let normal = plane.normal;
    let is_slow = speed + speed <= norm(context.domain.gravity()) * context.parameters.min_hop_time;
    let mut count = count_with_this(context, body, speed, is_slow);
    if is_slow && context.parameters.lossy_hops {
        count = count.max((count + 1).min(BEFORE_LANDING));
    }
    if count >= STUCK_AFTER {
        return Err(stuck(context, i, Partner::plane(p), count));
    }
    let after = [speed * restitution, restitution, S::zero()];
    if may_rest && rest::comes_to_rest_on(context, body, p, after) {
        return Ok(rest::lay_on_plane(context, i, body, p));
    }
    let hop = if may_rest { S::zero() } else { rest::short_hop(context, body, p, speed) };
    let last = (body.last_collision(), hop);
    let restitution = final_restitution::<S, D>(context, restitution, last, count);
    let away = (speed * restitution).max(S::zero());
    let mut change = normal * (speed + away);
    if dot(&normal, &(body.velocity + change)) < context.domain.plane_speed(p, context.now()) {
        change += normal * min_parting_speed(&body.velocity);
    }
    wake::kick(context, i, &counted(body, count), change);
    Ok(EventOutcome::Collision { restitution })
}

/// The smallest change of a velocity that its rounding does not swallow. Grains part at least this
/// fast: with ε = 0, else, rounding could leave them approaching, and the collision would repeat itself.
fn min_parting_speed<S: Scalar, const D: usize>(velocity: &Vector<S, D>) -> S {
    max_abs(velocity).rounding() * S::from_f32(4.0)
}

/// The body with this count of collisions. One that sleeps goes on until it is kicked.
#[inline]
fn counted<S: Scalar, const D: usize>(body: &Body<S, D>, count: u16) -> Body<S, D> {
    let consecutive_collisions = if body.is_asleep() { body.consecutive_collisions } else { count };
    Body { consecutive_collisions, ..*body }
}

/// How many collisions the body has had right after each other, this one included: it flew less than
/// the rounding of its position since the last. Slow ones have been counted already.
fn count_with_this<S: Scalar, const D: usize>(
    context: &Context<'_, '_, S, D>,
    body: &Body<S, D>,
    speed: S,
    is_slow: bool,
) -> u16 {
    let far = body.position.iter().fold(body.radius, |far, x| far.max(x.abs()));
    let last = body.last_collision();
    let flown = if last > -S::NEVER { (context.now() - last) * speed } else { S::NEVER };
    if body.is_asleep() || !(flown <= far.rounding() * S::from_f32(4.0)) {
        return if is_slow { body.consecutive_collisions } else { 0 };
    }
    (body.consecutive_collisions + 1).min(STUCK_AFTER)
}

/// The coefficient of restitution after both rules, the first of them for a hop that is too short to be one, too.
fn final_restitution<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    restitution: S,
    (last, hop): (S, S),
    count: u16,
) -> S {
    let t_c = context.parameters.t_c.max(hop);
    let soon = last > -S::NEVER && context.now() - last < t_c;
    let endless = count >= max_consecutive::<D>();
    if restitution < S::one() && (soon || endless) {
        context.parameters.lossy_hops |= soon;
        context.count(if soon { Incident::WithinTc } else { Incident::Collapse });
        return S::one();
    }
    restitution
}

fn stuck<S: Scalar, const D: usize>(
    context: &Context<'_, '_, S, D>,
    grain: usize,
    with: Partner,
    events: u16,
) -> Error {
    Error::Stuck { grain, with, at: context.clock.instant(), events: u32::from(events) }
}
