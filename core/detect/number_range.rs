//! When must a body be looked at so that no number leaves its range unseen? Reads its motion; writes nothing.

use super::scheduled_event::{EventKind, ScheduledEvent};
use crate::particle::Body;
use crate::scalar::{Scalar, max_abs};
use crate::space::{Domain, flight};

/// When a body that may leave the range of its number type must be looked at again, if that is before
/// `first`; and what it does then.
#[inline]
pub(super) fn within<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    now: S,
    body: &Body<S, D>,
    first: Option<(S, EventKind, u8)>,
) -> Option<(S, EventKind, u8)> {
    if S::RANGE.is_none() {
        return first;
    }
    let (_, velocity) = flight::free(body, domain, now);
    let safe = S::time_in_range(max_abs(&velocity), max_abs(domain.gravity()));
    match (first, safe) {
        (Some((span, ..)), Some(safe)) if span <= safe => first,
        (_, Some(safe)) => Some((safe, EventKind::Recheck, ScheduledEvent::<S>::NO_FACE)),
        _ => first,
    }
}
