//! Who may sleep? Reads bodies that touch; writes nothing.

use super::settings::Settings;
use crate::particle::Body;
use crate::scalar::{Scalar, norm};
use crate::space::{Domain, Particles};

/// Whether a clustered grain has been slow for ten contact times, and whoever it touches for half of that.
pub(super) fn may_sleep<S: Scalar, const D: usize>(
    particles: &Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    settings: &Settings<S>,
    (i, body): (usize, &Body<S, D>),
    [now, step]: [S; 2],
) -> bool {
    let long = settings.sleep_time(body.radius);
    if now - body.reference_time < long
        || body.contact_end < now
        || !is_balanced(domain, body, step)
    {
        return false;
    }
    let mut may = true;
    particles.cells.for_each_near(body.cell, body.radius, |k| {
        let Some(other) = particles.body(k).filter(|other| k != i && !other.is_asleep()) else {
            return;
        };
        let (apart, reach) = (domain.separation(body, other, now), body.radius + other.radius);
        let touches = S::dot(&apart, &apart) < reach.times(reach);
        let is_slow = other.is_clustered()
            && now - other.reference_time >= long * S::half()
            && is_balanced(domain, other, step);
        may &= is_slow || !touches;
    });
    may
}

/// Whether the forces on a clustered grain leave less than 2·10⁻⁴ of its weight, or than what rounding of its
/// position makes of them.
fn is_balanced<S: Scalar, const D: usize>(
    domain: &Domain<'_, S, D>,
    body: &Body<S, D>,
    step: S,
) -> bool {
    let coarse = coordinate_rounding(body) / step / step;
    norm(&body.velocity_change) <= (norm(domain.gravity()) * S::from_f64(2e-4)).max(coarse)
}

/// How fast a body at rest can seem to be by rounding: it stands until its speed moves it by its last place
/// in half a step.
pub(super) fn rounded_speed<S: Scalar, const D: usize>(body: &Body<S, D>, step: S) -> S {
    coordinate_rounding(body) * S::from_f32(2.0) / step
}

/// By how much rounding can move a body.
fn coordinate_rounding<S: Scalar, const D: usize>(body: &Body<S, D>) -> S {
    body.position.iter().fold(body.radius, |far, x| far.max(x.abs())).rounding()
}
