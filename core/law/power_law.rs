//! What is the force of bodies of any shape? Powers of the overlap; reads an impact, writes a force.

use super::contact_law::{ContactLaw, Memory};
use super::rule::Impact;
use super::scales::{not_negative, positive};
use crate::error::{Error, Subject};
use crate::scalar::Power;

/// F = k x^β + γ x^γ′ ẋ, and never an attraction: the general law of Luding et al. (Phys. Rev. E 50, 4113, 1994),
/// Appendix. Scaling makes of it ε = 1 − O(v^ν) with ν = (2 (γ′ + 1) − (β + 1))/(β + 1), and a contact lasts as
/// v^((1 − β)/(1 + β)).
///
/// # Units
/// `stiffness` in N/m^β, `damping` in N s/m^(1 + γ′).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PowerLaw<S> {
    /// k > 0.
    pub stiffness: S,
    /// β ≥ 1: 1 for a linear spring, 3/2 for spheres (Hertz).
    pub exponent: S,
    /// γ ≥ 0.
    pub damping: S,
    /// γ′ ≥ 0: 0 for a linear dashpot, 1/2 for viscoelastic spheres.
    pub damping_exponent: S,
}

impl<S: Power> ContactLaw<S> for PowerLaw<S> {
    fn force(&self, _: &Impact<S>, overlap: S, rate: S, _: &mut Memory<S>) -> S {
        let elastic = self.stiffness * overlap.power(self.exponent);
        let dashpot = self.damping * overlap.power(self.damping_exponent);
        (elastic + dashpot * rate).max(S::zero())
    }

    /// k β x^(β − 1).
    fn stiffness(&self, impact: &Impact<S>, overlap: S) -> S {
        // At the touch it may be none: there that of a millionth of the distance.
        let deep = overlap.max(impact.contact_distance * S::from_f64(1e-6));
        self.stiffness * self.exponent * deep.power(self.exponent - S::one())
    }

    fn check(&self) -> Result<(), Error> {
        positive("stiffness", self.stiffness)?;
        not_negative("damping", self.damping)?;
        not_negative("damping_exponent", self.damping_exponent)?;
        let exponent = self.exponent;
        if exponent >= S::one() && exponent <= S::from_f32(16.0) {
            return Ok(());
        }
        Err(Error::input(Subject::Rule, "exponent", exponent.to_f64(), "between 1 and 16"))
    }
}
