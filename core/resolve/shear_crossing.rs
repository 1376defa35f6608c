//! What happens to a grain that leaves a sheared box? It comes in at the other side; reads images, writes the grain.

use super::context::Context;
use super::effects::EventOutcome;
use crate::particle::Body;
use crate::scalar::{Scalar, component};

/// Grain `i` leaves the box through a sheared face. From now on it is its image inside that moves: displaced along the
/// flow, and with another velocity. What it was in contact with stays so.
pub(super) fn cross<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    i: usize,
) -> EventOutcome<S> {
    let Some(images) = context.domain.boundary.images() else { return EventOutcome::Unchanged };
    context.effects.predict_anew(i);
    let body = context.present(i);
    // Its place is at the face to rounding: only which way it flies says which.
    let up = component(&body.velocity, images.shear.gradient) > S::zero();
    let rows = if up { S::one() } else { -S::one() };
    let [place, moves] = images.image(rows, context.now());
    let (position, velocity) = (body.position - place, body.velocity - moves);
    context.put_inside(i, Body { position, velocity, ..body });
    EventOutcome::ShearCrossed
}
