//! When must a body be looked at so that no number leaves its range unseen? Reads its motion; writes nothing.

use super::queue::Slot;
use super::scene::Scene;
use crate::matter::{Body, flight};
use crate::number::{Scalar, largest};

/// A body that may leave the range of its number type is looked at again before it can.
#[inline]
pub(super) fn within<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    body: &Body<S, D>,
    first: Option<(S, u8)>,
) -> Option<(S, u8)> {
    if S::RANGE.is_none() {
        return first;
    }
    let (_, velocity) = flight::free(body, scene.field(), scene.now);
    let horizon = S::horizon(largest(&velocity), largest(&scene.gravity));
    match (first, horizon) {
        (Some((span, _)), Some(horizon)) if span <= horizon => first,
        (_, Some(horizon)) => Some((horizon, Slot::<S>::NO_FACE)),
        _ => first,
    }
}
