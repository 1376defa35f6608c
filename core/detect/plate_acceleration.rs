//! How strongly can plates accelerate the bodies they carry? Reads bodies and plates; writes nothing.

use crate::particle::Body;
use crate::scalar::{Scalar, Vector, dot};
use crate::space::{Domain, flight};

/// The size of the acceleration that the plates carrying a body can give it; 0 if none does.
pub(super) fn peak_acceleration<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    me: &Body<S, D>,
) -> S {
    let vibrations = flight::carrying_plates(me, domain).filter_map(|plate| plate.vibration());
    vibrations.fold(S::zero(), |sum, v| sum + v.peak_acceleration())
}

/// The same along a direction.
pub(super) fn peak_acceleration_along<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    me: &Body<S, D>,
    n: &Vector<S, D>,
) -> S {
    flight::carrying_plates(me, domain).fold(S::zero(), |sum, plate| {
        let peak = plate.vibration().map_or(S::zero(), |v| v.peak_acceleration());
        sum + peak * dot(&plate.normal, n).abs()
    })
}

/// Whether a plate shakes the body along an axis.
pub(super) fn is_shaken<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    me: &Body<S, D>,
    axis: usize,
) -> bool {
    let mut plates = flight::carrying_plates(me, domain);
    plates.any(|p| p.normal.get(axis).is_some_and(|&n| n != S::zero()))
}
