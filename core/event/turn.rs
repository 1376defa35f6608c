//! Where does a contact leave its two grains? Reads separation, velocity and outcome; writes those after it.

use crate::law::{Encounter, Outcome};
use crate::matter::Body;
use crate::number::{Scalar, Vector};

/// Two bodies as they touch: the relative coordinates of MP13, Eq. (5), seen from the second.
pub(crate) struct Touch<S: Scalar, const D: usize> {
    /// Unit vector from the second body to the first.
    pub e_r: Vector<S, D>,
    /// Unit vector of the tangential motion; zero if there is none.
    e_t: Vector<S, D>,
    /// Distance of the centres.
    distance: S,
    /// ṙ: negative.
    pub radial: S,
    /// |r φ̇|.
    tangential: S,
}

impl<S: Scalar, const D: usize> Touch<S, D> {
    /// From separation r₁ − r₂ and relative velocity v₁ − v₂; none if the centres coincide.
    pub fn new(separation: Vector<S, D>, velocity: Vector<S, D>) -> Option<Self> {
        let distance = separation.dot(&separation).sqrt();
        if !(distance > S::zero()) {
            return None;
        }
        let e_r = separation / distance;
        let radial = e_r.dot(&velocity);
        let across = velocity - e_r * radial;
        let tangential = if D > 1 { across.dot(&across).sqrt() } else { S::zero() };
        let e_t = if tangential > S::zero() { across / tangential } else { Vector::zeros() };
        Some(Self { e_r, e_t, distance, radial, tangential })
    }

    /// What a rule may know of the two.
    pub fn encounter(&self, a: &Body<S, D>, b: &Body<S, D>) -> Encounter<S> {
        Encounter {
            reach: a.radius + b.radius,
            effective_radius: a.radius / (a.radius + b.radius) * b.radius,
            reduced_mass: a.mass / (a.mass + b.mass) * b.mass,
            normal_speed: -self.radial,
            tangential_speed: self.tangential,
            materials: [a.material, b.material],
        }
    }

    /// Separation and relative velocity after the contact (MP13 Eqs. 24, 26, 28, 34–38).
    ///
    /// The distance becomes ε_r l whatever the rounding of the distance before was, and the
    /// tangential velocity follows from the angular momentum L = m_eff r v_t exactly (Eq. 19).
    pub fn after(&self, reach: S, outcome: &Outcome<S>) -> (Vector<S, D>, Vector<S, D>) {
        let (sin, cos) = outcome.angle.sine_cosine();
        let e_r = self.e_r * cos + self.e_t * sin;
        let e_t = self.e_t * cos - self.e_r * sin;
        let distance = reach * outcome.separation;
        let tangential = self.tangential * (self.distance / distance);
        let radial = -self.radial * outcome.restitution;
        if !(self.tangential > S::zero()) {
            return (self.e_r * distance, self.e_r * radial);
        }
        (e_r * distance, e_r * radial + e_t * tangential)
    }
}
