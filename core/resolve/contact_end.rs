//! How does a lasting contact end, at its time or before? Reads bodies in contact; writes their velocities after it (E^v).

use super::context::Context;
use super::effects::{EventOutcome, Incident};
use super::parameters::Release;
use crate::particle::{Body, Partner};
use crate::scalar::{Scalar, Vector, reject};

/// Ends the contacts that the grains are in before their time (MP13 §VI.B.5, exception b).
///
/// Only that: if the two still approach each other afterwards, they collide again at this instant.
pub(super) fn interrupt<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    grains: [Option<usize>; 2],
) -> bool {
    let mut any = false;
    for i in grains.into_iter().flatten() {
        if let Some(body) = context.particles.body(i).filter(|body| body.in_contact()) {
            let is_deferred = context.now() <= body.uninterruptible_until();
            if is_deferred {
                context.count(Incident::Deferral);
            }
            context.count(Incident::Interruption);
            end(context, i);
            any = true;
        }
    }
    any
}

/// The contact of grain `i` ends at its time.
pub(super) fn end_in_time<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    i: usize,
) -> EventOutcome<S> {
    context.effects.predict_anew(i);
    context.count(Incident::Release);
    if end(context, i) {
        context.count(Incident::Release);
    }
    EventOutcome::ContactEnded
}

/// E^v for grain `i`, and for its partner too if they are released as a pair: then true.
pub(crate) fn end<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    i: usize,
) -> bool {
    let partner = context.particles.body(i).and_then(|body| body.partner.as_grain());
    let paired = context.parameters.release == Release::Paired;
    let partner = partner.filter(|&k| paired && context.particles.are_in_contact(i, k));
    if let Some(k) = partner {
        release(context, k);
        context.effects.predict_anew(k);
    }
    release(context, i);
    partner.is_some()
}

/// Gives a grain the velocity its contact left for it (MP13 §VI.B.3).
fn release<S: Scalar, const D: usize>(context: &mut Context<'_, '_, S, D>, i: usize) {
    let body = context.present(i);
    let planes = context.domain.boundary.planes();
    let velocity = match body.partner.as_plane().and_then(|p| planes.get(p)) {
        Some(plane) => reject(&body.velocity, &plane.normal) + body.velocity_change,
        None => body.velocity + body.velocity_change,
    };
    let free = Body {
        velocity,
        velocity_change: Vector::zeros(),
        contact_end: S::NEVER,
        reference_time: context.now(),
        partner: Partner::NOTHING,
        ..body
    };
    context.replace(i, free);
}
