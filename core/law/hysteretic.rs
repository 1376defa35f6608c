//! What is the force of bodies that stay pressed? Springs that remember the deepest overlap; reads an impact, writes a force.

use super::contact_law::{ContactLaw, Memory};
use super::rule::Impact;
use super::scales::positive;
use crate::error::{Error, Subject};
use crate::scalar::Scalar;

/// Springs that stay pressed: loading by k₁ x, unloading and loading again by the stiffer k₂ (x − x₀), the force the
/// same where unloading began. ε = √(k₁/k₂) at every speed. (Walton & Braun, J. Rheol. 30, 949, 1986.)
///
/// # Units
/// Force over length.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct WaltonBraun<S> {
    /// k₁ > 0.
    pub loading: S,
    /// k₂ ≥ k₁.
    pub unloading: S,
}

impl<S: Scalar> ContactLaw<S> for WaltonBraun<S> {
    fn force(&self, _: &Impact<S>, overlap: S, _: S, [deepest, _]: &mut Memory<S>) -> S {
        *deepest = deepest.max(overlap);
        let back = self.unloading * (overlap - *deepest);
        (back + self.loading * *deepest).max(S::zero())
    }

    fn stiffness(&self, _: &Impact<S>, _: S) -> S {
        self.unloading
    }

    fn check(&self) -> Result<(), Error> {
        positive("loading", self.loading)?;
        if self.unloading >= self.loading && self.unloading.is_finite() {
            return Ok(());
        }
        let (value, wanted) = (self.unloading.to_f64(), "finite and at least that of loading");
        Err(Error::input(Subject::Rule, "unloading", value, wanted))
    }
}

/// Another law, and a constant force that holds two together as long as they touch.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cohesive<L, S> {
    /// What pushes them apart.
    pub law: L,
    /// The force that holds them, at least 0.
    ///
    /// # Units
    /// Force.
    pub cohesion: S,
}

impl<S: Scalar, L: ContactLaw<S>> ContactLaw<S> for Cohesive<L, S> {
    fn force(&self, impact: &Impact<S>, overlap: S, rate: S, memory: &mut Memory<S>) -> S {
        self.law.force(impact, overlap, rate, memory) - self.cohesion
    }

    fn stiffness(&self, impact: &Impact<S>, overlap: S) -> S {
        self.law.stiffness(impact, overlap)
    }

    fn reach(&self, impact: &Impact<S>) -> S {
        self.law.reach(impact)
    }

    fn check(&self) -> Result<(), Error> {
        super::scales::not_negative("cohesion", self.cohesion)?;
        self.law.check()
    }
}
