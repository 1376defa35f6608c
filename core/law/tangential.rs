//! What do rough surfaces do across the line of centres? Coefficients and laws of friction; reads an impact, writes nothing.

use crate::error::{Error, Subject};
use crate::scalar::Scalar;

/// What the surfaces of two grains that touch do to each other's rotation.
///
/// At the contact the surfaces move against each other with g_t, the relative velocity of the centres across the line
/// of centres plus what both rotations add. All three laws are about what becomes of it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Tangential<S> {
    /// A constant coefficient of tangential restitution: g_t becomes −β g_t. β = −1 is smooth, 1 perfectly rough.
    /// (Jenkins & Richman, Phys. Fluids 28, 3485, 1985.)
    Constant {
        /// −1 ≤ β ≤ 1.
        beta: S,
    },
    /// Walton's rule: surfaces slide under Coulomb's friction μ, or, where that is enough to stop them, stick and part
    /// with −β₀ g_t. (Foerster, Louge, Chang & Allia, Phys. Fluids 6, 1108, 1994.)
    Walton {
        /// The coefficient of friction μ ≥ 0.
        mu: S,
        /// The coefficient of tangential restitution of surfaces that stick: −1 ≤ β₀ ≤ 1.
        beta_0: S,
    },
    /// A linear spring and a dashpot across the line of centres for as long as the contact lasts, their force held to
    /// μ times the normal force; the spring is cut where it is held. (Cundall & Strack, Géotechnique 29, 47, 1979.)
    ///
    /// # Units
    /// Force over length; force over speed.
    Spring {
        /// The coefficient of friction μ ≥ 0.
        mu: S,
        /// The stiffness k_t > 0.
        stiffness: S,
        /// The dashpot γ_t ≥ 0.
        damping: S,
    },
}

impl<S: Scalar> Tangential<S> {
    /// Whether the parameters make sense.
    ///
    /// # Errors
    /// [`Error::Input`] that names the parameter.
    pub(super) fn check(&self) -> Result<(), Error> {
        let within = |field, x: S, low: S, high: S, wanted| match x >= low && x <= high {
            true => Ok(()),
            false => Err(Error::input(Subject::Rule, field, x.to_f64(), wanted)),
        };
        let (zero, one, most) = (S::zero(), S::one(), S::from_f32(16.0));
        let friction = |mu| within("mu", mu, zero, most, "between 0 and 16");
        match *self {
            Self::Constant { beta } => within("beta", beta, -one, one, "between -1 and 1"),
            Self::Walton { mu, beta_0 } => {
                friction(mu)?;
                within("beta_0", beta_0, -one, one, "between -1 and 1")
            }
            Self::Spring { mu, stiffness, damping } => {
                friction(mu)?;
                if !(stiffness > zero && stiffness.is_finite()) {
                    let wanted = "finite and above 0";
                    let value = stiffness.to_f64();
                    return Err(Error::input(Subject::Rule, "tangential stiffness", value, wanted));
                }
                let wanted = "finite and at least 0";
                within("tangential damping", damping, zero, S::NEVER, wanted)
            }
        }
    }

    /// How much of m_t |g_t| the impulse of an instantaneous contact is, which has this much of m_t |g_t| as the most
    /// that friction can do per unit of μ: 1 + β.
    ///
    /// A spring without a duration sticks without loss.
    pub(crate) fn impulse(&self, most: S) -> S {
        let one = S::one();
        match *self {
            Self::Constant { beta } => one + beta,
            Self::Walton { mu, beta_0 } => (one + beta_0).min(mu * most),
            Self::Spring { mu, .. } => (one + one).min(mu * most),
        }
    }
}
