//! Which of several collisions at one instant comes first? Reads the scene and the queue; writes nothing.
//!
//! The fastest: largest relative velocity first (LRV; Clément et al., Int. J. Mod. Phys. B 7, 1807,
//! 1993; L94 §II.B). Time alone does not order exactly simultaneous collisions, and the grains'
//! numbers mean nothing physical. They decide only between equal speeds. What is no collision (a
//! contact's end, a take-off, a look around) comes before: it says who collides at all.

use super::predict;
use super::queue::{Kind, Queue, Slot};
use super::scene::Scene;
use crate::matter::{Partner, flight};
use crate::number::{Product, Scalar, dot, norm};

/// Of more simultaneous events than this only so many are looked at: the work of one event is bounded.
const MOST: usize = 256;

/// The grain whose event comes first among those at the time of `slot`, the event of `grain`.
///
/// # Errors
/// A grain whose event at this time is void.
pub(crate) fn fastest<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    queue: &Queue<'_, S>,
    grain: usize,
    slot: &Slot<S>,
) -> Result<usize, usize> {
    if predict::is_stale(scene, slot) {
        return Err(grain);
    }
    if slot.kind != Kind::Meet {
        return Ok(grain);
    }
    if queue.at_once() <= 1 + u32::from(is_said_twice(queue, grain, slot)) {
        return Ok(grain);
    }
    let (mut stale, mut other, mut count) = (None, None, 0);
    queue.tied(slot.time, &mut |k| {
        let tied = queue.slot(k);
        count += 1;
        if predict::is_stale(scene, &tied) {
            stale = Some(k);
        } else if tied.kind != Kind::Meet {
            other = Some(k);
        }
        stale.is_none() && other.is_none() && count < MOST
    });
    match (stale, other) {
        (Some(stale), _) => Err(stale),
        (None, Some(other)) => Ok(other),
        (None, None) if count < 2 => Ok(grain),
        (None, None) => Ok(first_of(scene, queue, grain, slot.time)),
    }
}

/// Whether the partner's event is the same meeting.
fn is_said_twice<S: Scalar>(queue: &Queue<'_, S>, grain: usize, slot: &Slot<S>) -> bool {
    slot.partner.as_grain().is_some_and(|k| {
        let other = queue.slot(k);
        other.with() == Partner::grain(grain) && other.time == slot.time
    })
}

/// The fastest of several, the lowest number among equals.
fn first_of<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    queue: &Queue<'_, S>,
    grain: usize,
    time: S,
) -> usize {
    let (mut best, mut count) = ((grain, None::<S>), 0);
    queue.tied(time, &mut |k| {
        let tied = queue.slot(k);
        if tied.kind == Kind::Meet {
            let speed = closing_speed(scene, (k, tied.partner), tied.time);
            let equal = Some(speed) == best.1 && k < best.0;
            if equal || best.1.is_none_or(|most| speed > most) {
                best = (k, Some(speed));
            }
        }
        count += 1;
        count < MOST
    });
    best.0
}

/// The speed at which a grain and its partner approach each other at a time.
pub(super) fn closing_speed<S: Scalar, const D: usize>(
    scene: &Scene<'_, S, D>,
    (grain, partner): (usize, Partner),
    time: S,
) -> S {
    let at = |i: usize| scene.body(i).map(|body| flight::at(body, scene.field(), time));
    let Some(me) = at(grain) else { return S::zero() };
    if let Some(plane) = partner.as_plane().and_then(|p| scene.boundary.planes().get(p)) {
        return plane.motion(time).speed - dot(&plane.normal, &me.velocity);
    }
    let Some(other) = partner.as_grain().and_then(at) else { return S::zero() };
    let apart = scene.separation(&me, &other);
    -S::dot(&apart, &(me.velocity - other.velocity)).over(norm(&apart))
}
