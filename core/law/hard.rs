//! What do hard spheres do? Instantaneous collisions with constant or velocity-dependent restitution.

use super::enduring::Enduring;
use super::rule::{Answer, Impact, Response, Rule};
use super::tangential::Tangential;
use crate::error::{Error, Subject};
use crate::scalar::Scalar;

/// Hard spheres with a constant coefficient of restitution (eMD).
///
/// ```
/// use carom::law::HardSphere;
/// let steel = HardSphere { restitution: 0.95_f64 };
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct HardSphere<S> {
    /// Coefficient of restitution 0 ≤ ε ≤ 1.
    pub restitution: S,
}

impl<S: Scalar> Rule<S> for HardSphere<S> {
    fn collide(&self, _: &Impact<S>) -> Answer<S> {
        Answer::exact(Response::Instantaneous(self.restitution))
    }

    fn check(&self) -> Result<(), Error> {
        let e = self.restitution;
        if e >= S::zero() && e <= S::one() {
            return Ok(());
        }
        Err(Error::input(Subject::Rule, "restitution", e.to_f64(), "between 0 and 1"))
    }
}

/// Hard spheres with the coefficient of restitution ε(v_n) of another rule's central collision.
///
/// This is eMD as MP13 compares it with: the law's own ε, but no duration and no rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Central<R>(pub R);

impl<S: Scalar, R: Rule<S>> Rule<S> for Central<R> {
    #[inline(always)]
    fn enduring(&self) -> Option<Enduring> {
        self.0.enduring()
    }

    fn collide(&self, impact: &Impact<S>) -> Answer<S> {
        let zero = S::zero();
        let central = Impact { tangential_speed: zero, acceleration: zero, ..*impact };
        let answer = self.0.collide(&central);
        let response = match answer.response {
            Response::Lasting(outcome) => Response::Instantaneous(outcome.restitution),
            other => other,
        };
        Answer { response, ..answer }
    }

    fn adds_energy(&self) -> bool {
        self.0.adds_energy()
    }

    fn check(&self) -> Result<(), Error> {
        self.0.check()
    }

    #[inline(always)]
    fn inertia(&self) -> Option<S> {
        self.0.inertia()
    }
    #[inline(always)]
    fn tangential(&self, materials: [u8; 2]) -> Option<Tangential<S>> {
        self.0.tangential(materials)
    }
}
