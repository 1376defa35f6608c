//! What is the force of elastic spheres that stick? After Derjaguin, Muller & Toporov and after Johnson, Kendall & Roberts; reads an impact, writes a force.

use super::contact_law::{ContactLaw, Memory};
use super::rule::Impact;
use super::scales::{not_negative, positive};
use crate::error::{Error, Subject};
use crate::scalar::{Scalar, WideProduct};

/// What adhesive spheres are made of.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Adhesive<S> {
    /// Young's modulus Y > 0, Pa.
    pub young: S,
    /// Poisson's ratio −1 < ν ≤ 1/2.
    pub poisson: S,
    /// Dissipative parameter A ≥ 0, s: the force is that of the overlap x + A ẋ, to first order (MP13, Eq. 51).
    pub dissipation: S,
    /// Work of adhesion w ≥ 0, J/m².
    pub work: S,
}

impl<S: Scalar> Adhesive<S> {
    /// E* = Y/(2 (1 − ν²)) of two alike.
    fn modulus(&self) -> S {
        self.young * S::half() / (S::one() - self.poisson * self.poisson)
    }

    fn check(&self) -> Result<(), Error> {
        positive("young", self.young)?;
        not_negative("dissipation", self.dissipation)?;
        not_negative("work", self.work)?;
        let nu = self.poisson;
        if nu > -S::one() && nu <= S::half() {
            return Ok(());
        }
        Err(Error::input(Subject::Rule, "poisson", nu.to_f64(), "above -1 and at most 0.5"))
    }
}

/// An overlap at which there is a stiffness: at the touch there may be none; there it is a millionth of the distance.
fn deep<S: Scalar>(impact: &Impact<S>, overlap: S) -> S {
    overlap.max(impact.contact_distance * S::from_f64(1e-6))
}

/// π times this.
fn pi<S: Scalar>(times: f64) -> S {
    S::from_f64(core::f64::consts::PI * times)
}

/// Adhesion of small, stiff spheres: Hertz's force less 2 π w R_eff, as long as the two touch. (Derjaguin, Muller &
/// Toporov, J. Colloid Interface Sci. 53, 314, 1975.)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Dmt<S>(pub Adhesive<S>);

impl<S: Scalar> Dmt<S> {
    /// 2 E* √(R x).
    fn slope(&self, impact: &Impact<S>, overlap: S) -> S {
        let modulus = self.0.modulus();
        (modulus + modulus) * impact.effective_radius.times(overlap.max(S::zero())).sqrt()
    }
}

impl<S: Scalar> ContactLaw<S> for Dmt<S> {
    /// (4/3) E* √R x^(3/2) + 2 A E* √(R x) ẋ − 2 π w R.
    fn force(&self, impact: &Impact<S>, overlap: S, rate: S, _: &mut Memory<S>) -> S {
        let Self(of) = self;
        let radius = impact.effective_radius;
        let slope = self.slope(impact, overlap);
        let hertz = slope * (overlap * S::from_f64(2.0 / 3.0) + of.dissipation * rate);
        hertz.max(S::zero()) - pi::<S>(2.0) * of.work * radius
    }

    fn stiffness(&self, impact: &Impact<S>, overlap: S) -> S {
        self.slope(impact, deep(impact, overlap))
    }

    fn check(&self) -> Result<(), Error> {
        self.0.check()
    }
}

/// Adhesion of large, soft spheres. A contact begins at the touch and holds beyond it up to the pull-off; the strongest
/// pull is (3/2) π w R_eff. (Johnson, Kendall & Roberts, Proc. R. Soc. A 324, 301, 1971.)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Jkr<S>(pub Adhesive<S>);

impl<S: Scalar> Jkr<S> {
    /// √(2 π w/E*).
    fn stickiness(&self) -> S {
        (pi::<S>(2.0) * self.0.work / self.0.modulus()).sqrt()
    }

    /// The contact's radius at the pull-off: a³ = π w R²/(8 E*).
    fn smallest_radius(&self, radius: S) -> S {
        let quarter = self.stickiness() * radius * S::from_f32(0.25);
        // The cube root of its square, by Newton's method.
        let square = quarter * quarter;
        let mut a = radius;
        for _ in 0..64 {
            a = (a + a + square / (a * a)) * S::from_f64(1.0 / 3.0);
        }
        a
    }

    /// The contact's radius a at this overlap: x = a²/R − √(2 π w a/E*), the larger root.
    fn radius(&self, radius: S, overlap: S) -> S {
        let (c, least) = (self.stickiness(), self.smallest_radius(radius));
        let most = (overlap.max(S::zero()) * radius).sqrt() + least * S::from_f32(4.0);
        let mut a = most;
        for _ in 0..32 {
            let root = a.sqrt();
            let value = a * a / radius - c * root - overlap;
            let slope = (a + a) / radius - c * S::half() / root;
            let next = a - value / slope;
            if !(slope > S::zero()) || !(next < a) {
                break;
            }
            a = next.max(least);
        }
        a
    }
}

impl<S: Scalar> ContactLaw<S> for Jkr<S> {
    /// (4/3) E* a³/R − 2 √(2 π w E* a³) + 2 A E* a ẋ.
    fn force(&self, impact: &Impact<S>, overlap: S, rate: S, _: &mut Memory<S>) -> S {
        let Self(of) = self;
        let (radius, modulus) = (impact.effective_radius, of.modulus());
        let a = self.radius(radius, overlap);
        let pushed = S::from_f64(4.0 / 3.0) * modulus * a * a * a / radius;
        let held = (modulus + modulus) * self.stickiness() * a * a.sqrt();
        pushed - held + (modulus + modulus) * of.dissipation * a * rate
    }

    /// 2 E* a, of the slope of Hertz's force: that of this one is no larger by more than it is itself.
    fn stiffness(&self, impact: &Impact<S>, overlap: S) -> S {
        let modulus = self.0.modulus();
        (modulus + modulus) * self.radius(impact.effective_radius, deep(impact, overlap))
    }

    /// 3 a²/R at the pull-off.
    fn reach(&self, impact: &Impact<S>) -> S {
        let a = self.smallest_radius(impact.effective_radius);
        S::from_f32(3.0) * a * a / impact.effective_radius
    }

    fn check(&self) -> Result<(), Error> {
        self.0.check()
    }
}
