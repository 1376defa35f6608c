//! What lets a grain at rest go? Reads supports; writes bodies that are supported no longer.
//!
//! It wakes when it is hit faster than slowly, when what supports it moves, or when its plate falls away.

use super::context::Context;
use super::effects::{EventOutcome, Incident};
use super::support::{
    coordinate_scale, effective_gravity, is_negligible, rounding_height, unsupported_part,
};
use crate::particle::Body;
use crate::scalar::{Scalar, Vector, dot, norm};

/// Adds to a body's velocity. What it was pushed off or into supports it no longer.
pub(super) fn kick<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    x: usize,
    body: &Body<S, D>,
    change: Vector<S, D>,
) {
    if body.is_asleep() && !(norm(&change) > S::zero()) {
        return;
    }
    let now = context.now();
    let mut pushed = Body { velocity: body.velocity + change, reference_time: now, ..*body };
    if body.is_supported() {
        let was_asleep = body.is_asleep();
        pushed = pushed.awake();
        for (p, plane) in context.domain.boundary.planes().iter().enumerate() {
            let near = rounding_height(coordinate_scale(body)) * S::from_f32(8.0);
            let lies = plane.gap(&body.position, body.radius, now) <= near;
            if body.rests_on(p) && lies && dot(&plane.normal, &change) == S::zero() {
                pushed = pushed.resting_on(p);
            }
        }
        if was_asleep || pushed.planes != body.planes {
            woke(context, x);
        }
    }
    context.replace(x, pushed);
}

/// A grain that was at rest is not any more.
pub(super) fn woke<S: Scalar, const D: usize>(context: &mut Context<'_, '_, S, D>, x: usize) {
    context.count(Incident::TakeOff);
    context.effects.wake(x);
}

/// Nothing supports grain `i` any longer.
pub(crate) fn let_go<S: Scalar, const D: usize>(context: &mut Context<'_, '_, S, D>, i: usize) {
    let free = context.present(i).awake();
    context.replace(i, free);
    woke(context, i);
}

/// The plate that carries grain `i` falls away faster than the grain does.
pub(super) fn take_off<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    i: usize,
) -> EventOutcome<S> {
    context.effects.predict_anew(i);
    let_go(context, i);
    EventOutcome::TookOff
}

/// Something next to grain `i` has moved: is it still supported?
pub(super) fn check_support<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    i: usize,
) -> EventOutcome<S> {
    context.effects.predict_anew(i);
    let body = context.present(i);
    let g = effective_gravity(context, &body);
    if !body.is_asleep() || is_negligible(&unsupported_part(context, (i, &body), g, None), &g) {
        return EventOutcome::Unchanged;
    }
    take_off(context, i)
}
