//! For which collisions does a table answer? Reads the scaled groups; writes yes or no, or the nearest collision inside.

use super::{Groups, Stored};
use crate::number::Real;

/// Above this `eta` the smallest eccentricity counts: below it no pair comes near its centre.
pub const SOFT: f32 = 0.5;

/// The groups for which a table answers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain<C = f64> {
    /// Largest `eta / cos(alpha)`, one over the smallest `l~ cos(alpha)`.
    pub softness_max: C,
    /// Largest `c_dis`.
    pub c_dis_max: C,
    /// Smallest `cos(alpha)`: the most grazing collision.
    pub cos_min: C,
    /// Smallest eccentricity where `eta > 0.5`: there a central collision may pass through.
    pub sin_min: C,
    /// Largest `c_dis eta / cos(alpha)`.
    pub stick_max: C,
}

impl<C: Stored> Domain<C> {
    /// Are these groups inside? `false` for NaN.
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
            && g.c_dis * g.eta <= self.stick_max.get::<S>() * g.cos
            && (g.eta <= S::from_f32(SOFT) || g.sin >= self.sin_min.get())
    }

    /// The nearest groups inside, axis by axis; NaN becomes the lower end.
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
        if eta > S::from_f32(SOFT) && sin < self.sin_min.get() {
            sin = self.sin_min.get();
            cos = (one - sin * sin).sqrt();
            eta = between(eta, zero, self.softness_max.get::<S>() * cos);
        }
        let mut c_dis = between(g.c_dis, zero, self.c_dis_max.get());
        let stick = self.stick_max.get::<S>() * cos;
        if c_dis * eta > stick {
            c_dis = stick / eta * S::from_f32(0.999_999);
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
