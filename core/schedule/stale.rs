//! Is a prediction void? Reads a scheduled event and its partner; writes nothing.

use crate::detect::ScheduledEvent;
use crate::scalar::Scalar;
use crate::space::Particles;

/// Whether a predicted event is void because the partner's trajectory has changed since.
pub(super) fn is_stale<S: Scalar, const D: usize>(
    particles: &Particles<'_, S, D>,
    event: &ScheduledEvent<S>,
) -> bool {
    let partner = event.with().as_grain().and_then(|k| particles.body(k));
    partner.is_some_and(|body| body.event_count != event.partner_event_count)
}
