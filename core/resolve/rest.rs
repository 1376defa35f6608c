//! How do grains come to rest? Reads supports; writes bodies at rest.
//!
//! A grain whose next hop could not be told from lying still is laid still.
//! * On a plane: a hop lower than the rounding of its position, or shorter than the contact itself (of
//!   a soft law, or t_c). It may still slide; the plane takes what gravity presses into it.
//! * Among planes and grains at rest that hold it on all sides to which gravity pushes it: it falls asleep.
//!   A column comes to rest as one, from below.
//! * In two and three dimensions, where grains hold each other up in all directions: a grain that has had
//!   64 slow collisions in a row, is itself slow and is supported by such as it. A pile comes to rest as
//!   one; what it weighs on its neighbours is taken by them as by static friction.
//!
//! What lets them go is in [`super::wake`]. All this is for smooth grains: rough ones hop on.
//! Slow is a speed that gravity takes away within the contact duration (of a soft law or t_c), or
//! within the hop time of [`super::support::min_hop_time`].

use super::context::Context;
use super::effects::{EventOutcome, Incident};
use super::impact_frame::ImpactFrame;
use super::support::{
    BEFORE_LANDING, BEFORE_SLEEP, carrier_velocity, coordinate_scale, effective_gravity,
    is_negligible, min_hop_time, rounding_height, unsupported_part,
};
use crate::law::Rule;
use crate::particle::Body;
use crate::scalar::{Scalar, dot, norm, reject};
use crate::space::flight;

/// Whether grains come to rest by these rules. They know nothing of friction: rough grains go on in hops, elastic
/// along the normal where those are shorter than t_c or [`min_hop_time`].
#[inline(always)]
pub(super) fn may_rest<S: Scalar>(rule: &impl Rule<S>) -> bool {
    rule.inertia().is_none()
}

/// Whether a rebound with this speed under this weight is too low or too short to be one.
fn is_rest<S: Scalar>(speed: S, weight: S, height: S, duration: S) -> bool {
    weight > S::zero()
        && (speed.times(speed) <= (weight + weight).times(height)
            || speed + speed <= weight * duration)
}

/// Whether a grain that leaves plane `p` at this speed comes to rest on it.
pub(super) fn comes_to_rest_on<S: Scalar, const D: usize>(
    context: &Context<'_, '_, S, D>,
    body: &Body<S, D>,
    p: usize,
    [speed, restitution, duration]: [S; 3],
) -> bool {
    let Some(plane) = context.domain.boundary.planes().get(p) else { return false };
    let pull = dot(&plane.normal, &flight::acceleration(body, context.domain));
    let weight = plane.motion(context.now()).acceleration - pull;
    let hopping = body.consecutive_collisions >= BEFORE_LANDING;
    let lossy = restitution < S::one() || speed == S::zero() || duration > S::zero() || hopping;
    let hop = if hopping { context.parameters.min_hop_time } else { S::zero() };
    let duration = duration.max(context.parameters.t_c).max(hop);
    lossy && is_rest(speed, weight, rounding_height(coordinate_scale(body)), duration)
}

/// How long a hop of a rough grain is on plane `p` that is too short to be one, if this one is; else zero.
///
/// It is (R/g)^½/64, g what presses the grain onto the plane: the weight on a plate that accelerates.
pub(super) fn short_hop<S: Scalar, const D: usize>(
    context: &Context<'_, '_, S, D>,
    body: &Body<S, D>,
    p: usize,
    speed: S,
) -> S {
    let Some(plane) = context.domain.boundary.planes().get(p) else { return S::zero() };
    let pull = dot(&plane.normal, context.domain.gravity());
    let weight = plane.motion(context.now()).acceleration - pull;
    let hop = min_hop_time::<S, D>(&(plane.normal * weight), body.radius);
    if weight > S::zero() && speed + speed <= weight * hop { hop } else { S::zero() }
}

/// Lays a grain onto plane `p`: it has the plane's speed along the normal, and keeps what is across.
pub(super) fn lay_on_plane<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    i: usize,
    body: &Body<S, D>,
    p: usize,
) -> EventOutcome<S> {
    let Some(plane) = context.domain.boundary.planes().get(p) else {
        return EventOutcome::Unchanged;
    };
    let speed = plane.motion(context.now()).speed;
    let velocity = reject(&body.velocity, &plane.normal) + plane.normal * speed;
    let planes = body.planes & square_to(context, p);
    let corner = planes != body.planes && !body.is_asleep();
    let planes = if body.is_asleep() { body.planes } else { planes };
    let at_rest = Body { velocity, planes, reference_time: context.now(), ..*body }.resting_on(p);
    let g = effective_gravity(context, &at_rest);
    let wedged = corner && is_negligible(&unsupported_part(context, (i, &at_rest), g, None), &g);
    if wedged && fall_asleep(context, i, &at_rest, &at_rest, S::zero()) {
        return EventOutcome::CameToRest;
    }
    context.count(Incident::Rest);
    context.replace(i, at_rest);
    EventOutcome::CameToRest
}

/// The planes at right angles to plane `p`, as bits: sliding along one of two others leads off or into it.
fn square_to<S: Scalar, const D: usize>(context: &Context<'_, '_, S, D>, p: usize) -> u8 {
    let Some(plane) = context.domain.boundary.planes().get(p) else { return 0 };
    let planes = context.domain.boundary.planes().iter().enumerate();
    let square = planes.filter(|(_, q)| dot(&q.normal, &plane.normal).abs() <= S::from_f32(1e-6));
    square.fold(0, |bits, (q, _)| bits | 1_u8.checked_shl(q as u32).unwrap_or(0))
}

/// Whether two grains touch so slowly that gravity decides what comes of it, not their collision.
///
/// In one dimension only grains of which one is supported can: the others fall together.
pub(super) fn is_slow<S: Scalar, const D: usize>(
    context: &Context<'_, '_, S, D>,
    [a, b]: &[Body<S, D>; 2],
    frame: &ImpactFrame<S, D>,
    [restitution, duration]: [S; 2],
) -> bool {
    if context.domain.is_weightless() && context.particles.supported == 0 {
        return false;
    }
    let supported = [a, b].into_iter().find(|body| body.is_supported());
    if D == 1 && supported.is_none() {
        return false;
    }
    let g = effective_gravity(context, supported.unwrap_or(a));
    let lossy = restitution < S::one() || duration > S::zero();
    let hop = if lossy {
        context.parameters.min_hop_time.max(context.parameters.t_c).max(duration)
    } else {
        S::zero()
    };
    let height = rounding_height(coordinate_scale(a).max(coordinate_scale(b)));
    // Where grains slide the approach says how fast they are, even if ε = 0.
    let speed = if D == 1 { -frame.radial * restitution } else { -frame.radial };
    is_rest(speed, norm(&g), height, hop)
}

/// The largest speed of a grain that can lie still.
fn max_sleep_speed<S: Scalar, const D: usize>(
    context: &Context<'_, '_, S, D>,
    body: &Body<S, D>,
    radial: S,
) -> S {
    let g = effective_gravity(context, body);
    let hop = context.parameters.min_hop_time.max(context.parameters.t_c) * norm(&g);
    hop.max(radial.abs()) * S::from_f32(2.0)
}

/// Counts slow collisions in a row. A grain that was about to sleep and is not any more supports nothing.
pub(super) fn count_slow_collision<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    (x, body): (usize, &Body<S, D>),
    (is_slow, radial): (bool, S),
) -> Body<S, D> {
    if D == 1 || body.is_asleep() || !is_slow && body.consecutive_collisions < BEFORE_SLEEP / 2 {
        return *body;
    }
    let moves = body.velocity - carrier_velocity(context, body);
    let limit = max_sleep_speed(context, body, radial);
    if is_slow && S::dot(&moves, &moves) <= limit.times(limit) {
        return Body {
            consecutive_collisions: (body.consecutive_collisions + 1)
                .min(BEFORE_SLEEP.max(body.consecutive_collisions)),
            ..*body
        };
    }
    if body.consecutive_collisions >= BEFORE_SLEEP / 2 {
        context.effects.wake(x);
    }
    if is_slow { Body { consecutive_collisions: 0, ..*body } } else { *body }
}

/// Two grains touch slowly: whoever cannot move, and whoever is supported on all sides, lies still.
pub(super) fn pair_comes_to_rest<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    who: [usize; 2],
    pair: &[Body<S, D>; 2],
    frame: &ImpactFrame<S, D>,
) -> bool {
    let [i, k] = who;
    let mut rested = false;
    for (x, body, other, push) in [(i, &pair[0], k, frame.e_r()), (k, &pair[1], i, -frame.e_r())] {
        let blocked = body.is_supported()
            && !body.is_asleep()
            && is_negligible(&unsupported_part(context, (x, body), push, Some(other)), &push);
        rested |= blocked && fall_asleep(context, x, body, body, frame.radial);
    }
    for (x, body, other) in [(i, &pair[0], k), (k, &pair[1], i)] {
        rested |= falls_asleep_against(context, (x, body), other, frame.radial);
    }
    rested
}

/// Lays a grain still that is supported on all sides, if the other one is asleep or it is slow itself.
fn falls_asleep_against<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    (x, body): (usize, &Body<S, D>),
    other: usize,
    radial: S,
) -> bool {
    let Some(support) = context.particles.body(other).copied() else { return false };
    let is_drowsy = D > 1 && body.consecutive_collisions >= BEFORE_SLEEP;
    if context.particles.body(x).is_some_and(Body::is_asleep) || !(support.is_asleep() || is_drowsy)
    {
        return false;
    }
    let g = effective_gravity(context, &support);
    is_negligible(&unsupported_part(context, (x, body), g, None), &g)
        && fall_asleep(context, x, body, &support, radial)
}

/// Lays a grain still, on the plate that carries its support; not if that falls away, nor if the grain
/// moves on across the contact.
fn fall_asleep<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    x: usize,
    body: &Body<S, D>,
    support: &Body<S, D>,
    radial: S,
) -> bool {
    let velocity = carrier_velocity(context, support);
    let moves = body.velocity - velocity;
    let limit = max_sleep_speed(context, support, radial);
    let falls = flight::carrying_plates(support, context.domain).any(|plate| {
        plate.motion(context.now()).acceleration < dot(&plate.normal, context.domain.gravity())
    });
    if falls || (D > 1 && S::dot(&moves, &moves) > limit.times(limit)) {
        return false;
    }
    let planes = body.planes | support.planes;
    let at_rest = Body { velocity, planes, reference_time: context.now(), ..*body }.asleep();
    context.count(Incident::Rest);
    context.replace(x, at_rest);
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A hop with speed v under weight g is v²/(2g) high and lasts 2v/g.
    #[test]
    fn a_hop_is_none_if_it_is_too_low_or_too_short() {
        let (g, height, duration) = (9.81_f64, 0.3, 0.7);
        let (low, short) = (libm::sqrt(2.0 * g * height), 0.5 * g * duration);
        assert!(is_rest(0.999 * low, g, height, 0.0) && !is_rest(1.001 * low, g, height, 0.0));
        assert!(is_rest(0.999 * short, g, 0.0, duration));
        assert!(!is_rest(1.001 * short, g, 0.0, duration));
        // Nothing presses it onto anything.
        assert!(!is_rest(0.0, 0.0, height, duration) && !is_rest(0.0, -g, height, duration));
    }
}
