//! For which collisions does a table answer? Reads the scaled groups; writes yes or no, or the nearest collision inside.

use super::groups::Groups;
use super::real::Real;
use super::stored::StoredNumber;

/// Only above this `eta` is the eccentricity limited from below: the centres of a softer pair may pass each other.
pub(crate) const SOFT_ETA: f32 = 0.5;

/// The groups for which a table answers; none of the limits has a unit.
///
/// Softness here is `eta / cos(alpha)`, which does not depend on the angle for the linear law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain<C = f64> {
    /// Largest softness `eta / cos(alpha)`, one over the smallest `l~ cos(alpha)`.
    pub softness_max: C,
    /// Largest `c_dis`.
    pub c_dis_max: C,
    /// Smallest `cos(alpha)`: the most grazing collision.
    pub cos_min: C,
    /// Smallest eccentricity where `eta > 0.5`: there the centres of a central collision may pass each other.
    pub sin_min: C,
    /// Largest product of damping and softness, `c_dis eta / cos(alpha)`.
    pub c_dis_softness_max: C,
}

impl<C: StoredNumber> Domain<C> {
    /// Whether these groups are inside; `false` for NaN.
    pub fn contains<S: Real>(&self, g: &Groups<S>) -> bool {
        let (zero, one) = (S::from_f32(0.0), S::from_f32(1.0));
        g.sin >= zero
            && g.sin <= one
            && g.cos >= self.cos_min.get()
            && g.cos <= one
            && g.eta >= zero
            && g.eta <= self.softness_max.get::<S>() * g.cos
            && g.c_dis >= zero
            && g.c_dis <= self.c_dis_max.get()
            && g.c_dis * g.eta <= self.c_dis_softness_max.get::<S>() * g.cos
            && (g.eta <= S::from_f32(SOFT_ETA) || g.sin >= self.sin_min.get())
    }

    /// The nearest groups inside, axis by axis; NaN becomes the lower limit.
    pub fn clamp<S: Real>(&self, g: &Groups<S>) -> Groups<S> {
        if self.contains(g) {
            return *g;
        }
        let (zero, one) = (S::from_f32(0.0), S::from_f32(1.0));
        let mut sin = between(g.sin, zero, one);
        let mut cos = between(g.cos, self.cos_min.get(), one);
        if g.cos < cos {
            sin = (one - cos * cos).sqrt();
        }
        let mut eta = between(g.eta, zero, self.softness_max.get::<S>() * cos);
        if eta > S::from_f32(SOFT_ETA) && sin < self.sin_min.get() {
            sin = self.sin_min.get();
            cos = (one - sin * sin).sqrt();
            eta = between(eta, zero, self.softness_max.get::<S>() * cos);
        }
        let mut c_dis = between(g.c_dis, zero, self.c_dis_max.get());
        let limit = self.c_dis_softness_max.get::<S>() * cos;
        if c_dis * eta > limit {
            c_dis = limit / eta * S::from_f32(0.999_999);
        }
        Groups { sin, cos, eta, c_dis }
    }
}

fn between<S: Real>(value: S, low: S, high: S) -> S {
    if value >= high {
        high
    } else if value > low {
        value
    } else {
        low
    }
}
