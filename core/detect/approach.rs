//! How fast do two bodies approach each other at a time? Reads bodies and boundaries; writes nothing.

use crate::particle::Partner;
use crate::scalar::{Scalar, WideProduct, dot, norm};
use crate::space::{Domain, Particles, flight};

/// The speed at which a grain and its partner approach each other at a time.
pub(crate) fn closing_speed<S: Scalar, const D: usize>(
    particles: &Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    (grain, partner): (usize, Partner),
    time: S,
) -> S {
    let at = |i: usize| particles.body(i).map(|body| flight::at(body, domain, time));
    let Some(me) = at(grain) else { return S::zero() };
    if let Some(plane) = partner.as_plane().and_then(|p| domain.boundary.planes().get(p)) {
        return plane.motion(time).speed - dot(&plane.normal, &me.velocity);
    }
    if let Some(facet) = partner.as_facet() {
        let plane = domain.boundary.facet_plane(facet, &me.position, time);
        return plane.map_or(S::zero(), |plane| {
            plane.motion(time).speed - dot(&plane.normal, &me.velocity)
        });
    }
    let Some(other) = partner.as_grain().and_then(at) else { return S::zero() };
    let [apart, velocity] = domain.relative(&me, &other, time);
    -S::dot(&apart, &velocity).divided_by(norm(&apart))
}
