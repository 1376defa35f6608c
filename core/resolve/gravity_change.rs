//! How does a contact under way go on when gravity changes? Reads bodies in contact; writes when and how it ends.

use super::contact_begin::{is_pulled_off, uninterruptible_until};
use super::context::Context;
use crate::particle::Body;
use crate::scalar::{Scalar, Vector, dot};

/// Gravity has changed during the contact of grain `i`: a third body may end it in time again, and one
/// with a plane ends when, where and as fast as it would have, or at once if gravity pulls the grain off visibly
/// now.
pub(crate) fn continue_contact<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    i: usize,
    before: &Vector<S, D>,
) {
    let Some(body) = context.particles.body(i).copied().filter(Body::in_contact) else { return };
    let (mut body, now) = (body, context.now());
    let left = body.contact_end - now;
    let planes = context.domain.boundary.planes();
    if let Some(plane) = body.partner.as_plane().and_then(|p| planes.get(p)) {
        let n = &plane.normal;
        body.velocity += n * (dot(n, &(before - context.domain.gravity())) * left * S::half());
        if is_pulled_off(context, &body, plane, left) {
            (body.contact_end, body.reference_time) = (now, now);
        }
    }
    body.reference_time = body.reference_time.min(uninterruptible_until(context, &body, left));
    context.replace(i, body);
}
