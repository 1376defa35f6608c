//! Who may sleep? Reads bodies that touch; writes nothing.

use super::settings::Settings;
use crate::particle::Body;
use crate::scalar::Scalar;
use crate::space::{Domain, Particles};

/// Whether a clustered grain has been slow for ten contact times, and whoever it touches for half of that.
pub(super) fn may_sleep<S: Scalar, const D: usize>(
    particles: &Particles<'_, S, D>,
    domain: &Domain<'_, S, D>,
    settings: &Settings<S>,
    (i, body, now): (usize, &Body<S, D>, S),
) -> bool {
    let long = settings.sleep_time(body.radius);
    if now - body.reference_time < long || body.contact_end < now {
        return false;
    }
    let mut may = true;
    particles.cells.for_each_near(body.cell, |k| {
        let Some(other) = particles.body(k).filter(|other| k != i && !other.is_asleep()) else {
            return;
        };
        let (apart, reach) = (domain.separation(body, other), body.radius + other.radius);
        let touches = S::dot(&apart, &apart) < reach.times(reach);
        let is_slow = other.is_clustered() && now - other.reference_time >= long * S::half();
        may &= is_slow || !touches;
    });
    may
}
