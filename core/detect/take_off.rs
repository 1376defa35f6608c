//! When does a plate fall away from under the grain it carries? Reads bodies and plates; writes nothing.

use super::bracketed_root::{Found, Search};
use crate::particle::Body;
use crate::scalar::{Scalar, dot};
use crate::space::{Domain, Plane, flight};

/// How long after its clock the plate that carries a body falls away faster than the body does: z̈₀ < g_n
/// (L94, Sec. II).
pub(super) fn take_off<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    me: &Body<S, D>,
) -> Found<S> {
    let leaves =
        flight::carrying_plates(me, domain).map(|plate| falls_away(domain, me.clock, plate));
    leaves.fold(Found::Nothing, |first, next| match (first, next) {
        (Found::Nothing, found) | (found, Found::Nothing) => found,
        (a, b) if b.time() < a.time() => b,
        (a, _) => a,
    })
}

fn falls_away<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    start: S,
    plate: &Plane<S, D>,
) -> Found<S> {
    let Some(vibration) = plate.vibration() else { return Found::Nothing };
    let falls = dot(&plate.normal, domain.gravity());
    let (omega, peak) = (vibration.angular_frequency(), vibration.peak_acceleration());
    if plate.motion(start).acceleration < falls {
        return Found::Event(S::zero());
    }
    if peak <= -falls || !(peak > S::zero()) {
        return Found::Nothing;
    }
    let sign = if vibration.swing() > S::zero() { S::one() } else { -S::one() };
    let search = Search::new([peak * omega * omega; 2], peak, S::NEVER);
    search.first(|t| {
        let (sin, cos) = vibration.phase_at(start + t);
        (-sign * peak * sin - falls, -sign * peak * cos * omega)
    })
}
