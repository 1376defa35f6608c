//! What does a contact do? Force laws, tables and rules; reads an encounter, writes its outcome.

pub mod force;
mod hard;
mod material;
mod soft;
pub mod tables;

pub use force::{LinearDashpot, Viscoelastic};
pub use hard::{Central, HardSphere};
pub use material::ByMaterial;
pub use soft::{Outside, Soft};

use crate::fault::Fault;
use crate::number::Scalar;

/// Two bodies at the instant they touch, in all that a rule may depend on.
///
/// Against a plane, the reduced mass and both radii are the grain's own and there is no tangential speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Encounter<S> {
    /// l = R₁ + R₂.
    pub reach: S,
    /// R_eff = R₁ R₂ / (R₁ + R₂), MP13 below Eq. (52).
    pub effective_radius: S,
    /// m_eff = m₁ m₂ / (m₁ + m₂), MP13 Eq. (5).
    pub reduced_mass: S,
    /// The speed of approach v_n = −ṙ(0) ≥ 0.
    pub normal_speed: S,
    /// The speed across, l φ̇(0) ≥ 0.
    pub tangential_speed: S,
    /// The materials of the two; a plane is of the grain's own.
    pub materials: [u8; 2],
}

/// A lasting contact's whole outcome: the matrix of restitution (MP13 Eq. 23) and the duration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome<S> {
    /// The contact duration τ = ε_t T.
    pub duration: S,
    /// −ε_ṙ ≥ 0: the speed of separation in units of the speed of approach.
    pub restitution: S,
    /// ε_r: the distance at the end in units of l.
    pub separation: S,
    /// ε_φ: by how much the line of centres turns, in radians.
    pub angle: S,
}

/// What two bodies that touch do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Response<S> {
    /// An instantaneous collision with this coefficient of restitution.
    Instant(S),
    /// A contact that lasts and turns (eMD*).
    Lasting(Outcome<S>),
    /// No answer: outside the table's domain, and the user asked not to guess.
    Refused {
        /// η = 1/l̃.
        eta: S,
        /// Scaled dissipation.
        c_dis: S,
    },
    /// No answer: this quantity does not fit the number type.
    Overflow(&'static str),
}

/// How far an answer can be trusted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trust {
    /// The encounter lies inside the domain of the law's table, or needs none.
    Inside,
    /// It lies outside; the nearest encounter inside was used.
    Clamped,
    /// It lies outside; the hard-sphere rule was used.
    HardSphere,
}

/// A response and how far it can be trusted. The world counts what is not [`Trust::Inside`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer<S> {
    /// What happens.
    pub response: Response<S>,
    /// How well it is known.
    pub trust: Trust,
}

impl<S> Answer<S> {
    /// An answer from inside the domain.
    pub fn sure(response: Response<S>) -> Self {
        Self { response, trust: Trust::Inside }
    }
}

/// A collision rule: what two bodies do when they touch.
///
/// Implement it to bring your own; the host brings one that integrates the contact directly.
pub trait Rule<S: Scalar> {
    /// What these two do. Called once for each contact.
    fn meet(&self, encounter: &Encounter<S>) -> Answer<S>;

    /// Whether the rule's parameters make sense; asked once, when a world starts.
    ///
    /// # Errors
    /// A [`Fault::Input`] that names the parameter.
    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }
}

impl<S: Scalar, R: Rule<S> + ?Sized> Rule<S> for &R {
    fn meet(&self, encounter: &Encounter<S>) -> Answer<S> {
        (**self).meet(encounter)
    }
    fn check(&self) -> Result<(), Fault> {
        (**self).check()
    }
}
