//! How do two grains move as they touch, and where does a contact leave them? Reads separation, velocity and outcome; writes those after it.

use super::surface_collision::Touch;
use crate::law::{Impact, Outcome};
use crate::particle::{Body, Partner};
use crate::scalar::{Scalar, Vector, dot, norm};

/// Two bodies as they touch: the relative coordinates of MP13, Eq. (5), seen from the second.
pub(crate) struct ImpactFrame<S: Scalar, const D: usize> {
    /// r₁ − r₂.
    separation: Vector<S, D>,
    /// The part of the relative velocity across the line of centres.
    across: Vector<S, D>,
    /// Distance of the centres.
    pub(super) distance: S,
    /// ṙ: negative.
    pub radial: S,
    /// |r φ̇|.
    tangential: S,
}

impl<S: Scalar, const D: usize> ImpactFrame<S, D> {
    /// From separation r₁ − r₂ and relative velocity v₁ − v₂; none if the centres coincide.
    pub fn new(separation: Vector<S, D>, velocity: Vector<S, D>) -> Option<Self> {
        let distance = norm(&separation);
        if !(distance > S::zero()) {
            return None;
        }
        // The sign is that of r·v, as in the prediction: else rounding could make an event of nothing.
        let radial = S::component(&separation, &velocity, distance);
        let across = velocity - S::along(&separation, radial, distance);
        let tangential = if D > 1 { norm(&across) } else { S::zero() };
        Some(Self { separation, across, distance, radial, tangential })
    }

    /// Unit vector from the second body to the first.
    pub fn e_r(&self) -> Vector<S, D> {
        self.separation / self.distance
    }

    /// Unit vector of the tangential motion; zero if there is none.
    fn e_t(&self) -> Vector<S, D> {
        let moves = self.tangential > S::zero();
        if moves { self.across / self.tangential } else { Vector::zeros() }
    }

    /// What a rule may know of the two.
    pub fn impact(&self, a: &Body<S, D>, b: &Body<S, D>) -> Impact<S> {
        Impact {
            contact_distance: a.radius + b.radius,
            effective_radius: a.radius / (a.radius + b.radius) * b.radius,
            reduced_mass: a.mass / (a.mass + b.mass) * b.mass,
            normal_speed: -self.radial,
            tangential_speed: self.tangential,
            acceleration: S::zero(),
            materials: [a.material, b.material],
        }
    }

    /// How the surfaces of these two touch, in a collision without duration.
    pub fn touch(&self, [grain, other]: [usize; 2], restitution: S) -> Touch<S, D> {
        let change = self.radial * -(S::one() + restitution);
        Touch { grain, with: Partner::grain(other), normal: self.e_r(), change }
    }

    /// A vector across the line of centres after that has turned by an angle.
    pub fn turned(&self, across: &Vector<S, D>, angle: S) -> Vector<S, D> {
        let ((sin, cos), e_t) = (angle.sin_cos(), self.e_t());
        let along = dot(across, &e_t);
        *across - e_t * along + (e_t * cos - self.e_r() * sin) * along
    }

    /// The vector of this magnitude from the second body to the first.
    pub fn along(&self, magnitude: S) -> Vector<S, D> {
        S::along(&self.separation, magnitude, self.distance)
    }

    /// Separation and relative velocity after the contact (MP13 Eqs. 24, 26, 28, 34–38).
    ///
    /// Distance and tangential speed change by ε_r and 1/ε_r, so angular momentum (Eq. 19) and, in an
    /// elastic contact, energy are kept to the last place. Only a pair that still overlaps from an
    /// interrupted contact is put where the contact's end belongs, ε_r l: overlaps cannot add up.
    pub fn after(&self, reach: S, outcome: &Outcome<S>) -> (Vector<S, D>, Vector<S, D>) {
        let (sin, cos) = outcome.angle.sin_cos();
        let e_t = self.e_t();
        let e_r = self.e_r() * cos + e_t * sin;
        let shallow = self.distance > reach * S::from_f64(1.0 - 1.0 / 1024.0);
        let before = if shallow { self.distance } else { reach };
        let distance = before * outcome.separation;
        let tangential = self.tangential * (self.distance / before) / outcome.separation;
        let radial = -self.radial * outcome.restitution;
        if !(self.tangential > S::zero()) {
            return (self.e_r() * distance, self.along(radial));
        }
        let (along, across) = (cos * radial - sin * tangential, sin * radial + cos * tangential);
        (e_r * distance, self.along(along) + e_t * across)
    }
}
