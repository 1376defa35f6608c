//! Which of several collisions at one instant comes first? Reads bodies and the queue; writes nothing.
//!
//! The fastest: largest relative velocity first (LRV; Clément et al., Int. J. Mod. Phys. B 7, 1807,
//! 1993; L94 §II.B). Time alone does not order exactly simultaneous collisions, and the grains'
//! numbers mean nothing physical. They decide only between equal speeds. What is no collision (a
//! contact's end, a take-off, a recheck) comes before: it says who collides at all.

use super::queue::EventQueue;
use super::stale::is_stale;
use crate::detect::{EventKind, ScheduledEvent, closing_speed};
use crate::particle::Partner;
use crate::scalar::Scalar;
use crate::space::{Domain, Particles};

/// Of more simultaneous events than this only so many are looked at: the work of one event is bounded.
const MAX_TIED: usize = 256;

/// The grain whose event comes first among those at the time of `event`, the event of `grain`.
///
/// # Errors
/// A grain whose event at this time is stale.
pub(crate) fn first_of_instant<S: Scalar, const D: usize>(
    particles: &Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    queue: &EventQueue<'_, S>,
    (grain, event): (usize, &ScheduledEvent<S>),
) -> Result<usize, usize> {
    if is_stale(particles, event) {
        return Err(grain);
    }
    if event.kind != EventKind::Collision {
        return Ok(grain);
    }
    if !is_tied(queue, (grain, event)) {
        return Ok(grain);
    }
    let (mut stale, mut other, mut count) = (None, None, 0);
    queue.tied(event.time, &mut |k| {
        let tied = queue.event(k);
        count += 1;
        if is_stale(particles, &tied) {
            stale = Some(k);
        } else if tied.kind != EventKind::Collision {
            other = Some(k);
        }
        stale.is_none() && other.is_none() && count < MAX_TIED
    });
    match (stale, other) {
        (Some(stale), _) => Err(stale),
        (None, Some(other)) => Ok(other),
        (None, None) if count < 2 => Ok(grain),
        (None, None) => Ok(fastest(particles, domain, queue, (grain, event.time))),
    }
}

/// Whether another collision is at the time of this one, the earliest of all.
pub(crate) fn is_tied<S: Scalar>(
    queue: &EventQueue<'_, S>,
    (grain, event): (usize, &ScheduledEvent<S>),
) -> bool {
    queue.simultaneous() > 1 + u32::from(is_also_the_partners(queue, grain, event))
}

/// Whether the partner's event is the same collision.
fn is_also_the_partners<S: Scalar>(
    queue: &EventQueue<'_, S>,
    grain: usize,
    event: &ScheduledEvent<S>,
) -> bool {
    event.with().as_grain().is_some_and(|k| {
        let other = queue.event(k);
        other.with() == Partner::grain(grain) && other.time == event.time
    })
}

/// The fastest of several, the lowest number among equals.
fn fastest<S: Scalar, const D: usize>(
    particles: &Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    queue: &EventQueue<'_, S>,
    (grain, time): (usize, S),
) -> usize {
    let (mut best, mut count) = ((grain, None::<S>), 0);
    queue.tied(time, &mut |k| {
        let tied = queue.event(k);
        if tied.kind == EventKind::Collision {
            let speed = closing_speed(particles, domain, (k, tied.partner), tied.time);
            let equal = Some(speed) == best.1 && k < best.0;
            if equal || best.1.is_none_or(|most| speed > most) {
                best = (k, Some(speed));
            }
        }
        count += 1;
        count < MAX_TIED
    });
    best.0
}
