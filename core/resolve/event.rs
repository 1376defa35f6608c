//! What does an event do? Reads the event and the rule; writes the bodies it concerns.

use super::context::Context;
use super::effects::EventOutcome;
use super::{
    contact_end, crowded_collision, grain_collision, obstacle_collision, plane_collision,
    shear_crossing, wake,
};
use crate::detect::{EventKind, ScheduledEvent};
use crate::error::Error;
use crate::law::Rule;
use crate::particle::Partner;
use crate::scalar::Scalar;
use crate::space::CellFace;

/// The event of a grain happens. What it leaves to be done stands in the context's effects.
///
/// # Errors
/// What the rule refuses, and what it cannot answer for.
#[inline]
pub(crate) fn resolve<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    rule: &impl Rule<S>,
    (grain, event): (usize, &ScheduledEvent<S>),
) -> Result<EventOutcome<S>, Error> {
    match event.kind {
        EventKind::Collision => touch(context, rule, (grain, event.partner)),
        EventKind::ContactEnd => Ok(contact_end::end_in_time(context, grain)),
        EventKind::TakeOff => Ok(wake::take_off(context, grain)),
        EventKind::SupportCheck => Ok(wake::check_support(context, grain)),
        EventKind::CellCrossing => Ok(cross(context, grain, event.face)),
        EventKind::ShearCrossing => Ok(shear_crossing::cross(context, grain)),
        EventKind::Recheck if event.is_pause() => Ok(go_on(context, grain)),
        EventKind::BoundarySentinel | EventKind::Recheck | EventKind::Step | EventKind::Nothing => {
            Ok(EventOutcome::Unchanged)
        }
    }
}

/// Grain `i` touches its partner. If either is still in another contact, that is all that ends.
#[inline]
fn touch<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    rule: &impl Rule<S>,
    (i, partner): (usize, Partner),
) -> Result<EventOutcome<S>, Error> {
    let other = partner.as_grain();
    context.effects.predict_anew(i);
    other.into_iter().for_each(|k| context.effects.predict_anew(k));
    if context.parameters.settings.is_integrated(rule) {
        if let Some(facet) = obstacle_collision::touched(context, partner) {
            return obstacle_collision::touch(context, rule, (i, facet));
        }
        return crowded_collision::touch(context, rule, (i, partner));
    }
    if contact_end::interrupt(context, [Some(i), other]) {
        return Ok(EventOutcome::ContactInterrupted);
    }
    match (other, partner.as_plane()) {
        (Some(k), _) => grain_collision::collide(context, rule, [i, k]),
        (None, Some(p)) => plane_collision::collide(context, rule, (i, p)),
        (None, None) => Ok(EventOutcome::Unchanged),
    }
}

/// A search paused: it goes on from here, as if the grain's motion began now.
fn go_on<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    grain: usize,
) -> EventOutcome<S> {
    let present = context.present(grain);
    context.replace(grain, present);
    EventOutcome::Unchanged
}

/// Grain `i` leaves its cell: other grains are near it now; its motion stays the same.
fn cross<S: Scalar, const D: usize>(
    context: &mut Context<'_, '_, S, D>,
    i: usize,
    face: u8,
) -> EventOutcome<S> {
    context.particles.cross(&context.domain.boundary, i, CellFace::from_code(face));
    EventOutcome::CellCrossed
}
