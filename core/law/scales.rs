//! Which scales does a force law set? Reads material and impact; writes T, X and c_dis.

use super::embedded::history;
use super::rule::{ContactForce, Impact, Outcome};
use crate::error::{Error, Subject};
use crate::scalar::{Scalar, WideProduct};
use carom_tables::read::{Compression, Groups, Law, ScaledRestitution};

/// The scales of one impact (MP13, Sec. V).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Scales<S> {
    /// The unit of time T.
    pub time: S,
    /// The unit of length X = T v_n.
    pub length: S,
    /// The scaled dissipation c_dis.
    pub c_dis: S,
}

impl<S: Scalar> Scales<S> {
    /// A scaled outcome in the units of the impact: τ = ε_t T (MP13 Eq. 20), the rest as it is.
    pub fn outcome(&self, scaled: &ScaledRestitution<S>) -> Outcome<S> {
        Outcome {
            duration: scaled.tau * self.time,
            restitution: scaled.speed,
            separation: scaled.separation,
            angle: scaled.angle,
        }
    }

    /// The first scale of an impact that does not fit a fixed-point number. A contact that never ends,
    /// because nothing approaches, is none of these.
    pub(super) fn overflow(&self, impact: &Impact<S>) -> Option<&'static str> {
        if S::RANGE.is_none() || !(impact.normal_speed > S::zero()) {
            return None;
        }
        let named = [
            (self.time, "stiffness over mass"),
            (self.length, "length"),
            (self.c_dis, "scaled dissipation"),
        ];
        if self.time == S::zero() {
            return Some("contact time");
        }
        named.into_iter().find_map(|(scale, name)| (!scale.is_finite()).then_some(name))
    }
}

impl<S: Scalar> Impact<S> {
    /// The scaled groups: e = sin α, cos α, η = X/l = 1/l̃ and c_dis (MP13 Eqs. 43, 45, 47).
    pub fn groups(&self, scales: &Scales<S>) -> Groups<S> {
        let (n, t) = (self.normal_speed, self.tangential_speed);
        let (eta, c_dis) = (scales.length / self.contact_distance, scales.c_dis);
        if !(t > S::zero()) {
            return Groups { sin: S::zero(), cos: S::one(), eta, c_dis };
        }
        // The larger of the two is divided out first: the squares can neither overflow nor vanish.
        let large = n.max(t);
        let (a, b) = (n / large, t / large);
        let norm = (a.times(a) + b.times(b)).sqrt();
        Groups { sin: b / norm, cos: a / norm, eta, c_dis }
    }
}

/// A normal force law between smooth spheres.
pub trait ForceLaw<S: Scalar> {
    /// Which of the tabulated laws this is.
    const LAW: Law;
    /// The scales it sets in an impact.
    fn scales(&self, impact: &Impact<S>) -> Scales<S>;
    /// The force of two bodies that overlap by this much.
    fn force(&self, impact: &Impact<S>, overlap: S) -> ContactForce<S>;
    /// How a contact that nothing turns goes over time, in the unit T; none where its dissipation is beyond what is
    /// tabulated.
    fn course(&self, impact: &Impact<S>) -> Option<(S, Compression<S>)> {
        let scales = self.scales(impact);
        let history = match Self::LAW {
            Law::LinearDashpot => &history::LINEAR_DASHPOT,
            Law::Viscoelastic => &history::VISCOELASTIC,
        };
        Some((scales.time, history.at(scales.c_dis)?))
    }
    /// How long a contact of the two lasts without damping, at the speed of this impact or already
    /// pressed together by this much, whichever makes it shorter.
    fn contact_time(&self, impact: &Impact<S>, overlap: S) -> S;
    /// Whether the parameters make sense.
    ///
    /// # Errors
    /// A [`Error::Input`] that names the parameter.
    fn check(&self) -> Result<(), Error>;
}

/// Linear spring-dashpot: F_n = k (l − r) − γ ṙ (MP13 Eq. 40).
///
/// # Units
/// `stiffness` k in N/m, `damping` γ in kg/s.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LinearDashpot<S> {
    /// Spring constant k > 0.
    pub stiffness: S,
    /// Dissipative parameter γ ≥ 0.
    pub damping: S,
}

/// Viscoelastic spheres: F_n = ρ (l − r)^{3/2} − (3/2) A ρ ṙ (l − r)^{1/2} (MP13 Eq. 51).
///
/// # Units
/// `young` Y in Pa, `poisson` ν without unit, `dissipation` A in s.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Viscoelastic<S> {
    /// Young's modulus Y > 0.
    pub young: S,
    /// Poisson's ratio −1 < ν ≤ 1/2.
    pub poisson: S,
    /// Dissipative parameter A ≥ 0.
    pub dissipation: S,
}

impl<S: Scalar> ForceLaw<S> for LinearDashpot<S> {
    const LAW: Law = Law::LinearDashpot;

    /// T = 1/ω = sqrt(m_eff/k), c_dis = γ T/m_eff (MP13 Eqs. 41, 43).
    fn scales(&self, impact: &Impact<S>) -> Scales<S> {
        let time = impact.reduced_mass.sqrt_of_ratio(self.stiffness);
        let c_dis = self.damping.times(time).divided_by(impact.reduced_mass);
        Scales { time, length: time * impact.normal_speed, c_dis }
    }

    /// k x, γ.
    fn force(&self, _: &Impact<S>, overlap: S) -> ContactForce<S> {
        ContactForce { elastic: self.stiffness * overlap, damping: self.damping }
    }

    /// π T, at any speed.
    fn contact_time(&self, impact: &Impact<S>, _: S) -> S {
        S::from_f64(core::f64::consts::PI) * impact.reduced_mass.sqrt_of_ratio(self.stiffness)
    }

    fn check(&self) -> Result<(), Error> {
        positive("stiffness", self.stiffness)?;
        not_negative("damping", self.damping)
    }
}

impl<S: Scalar> ForceLaw<S> for Viscoelastic<S> {
    const LAW: Law = Law::Viscoelastic;

    /// T = k^{−2/5} v_n^{−1/5} with k = ρ/m_eff, c_dis = 3A/(2T) (MP13 Eqs. 52–54).
    fn scales(&self, impact: &Impact<S>) -> Scales<S> {
        let k = self.stiffness(impact) / impact.reduced_mass;
        let time = S::viscoelastic_time(k, impact.normal_speed);
        let c_dis = S::from_f64(1.5) * self.dissipation / time;
        Scales { time, length: time * impact.normal_speed, c_dis }
    }

    /// ρ x^{3/2}, (3/2) A ρ x^{1/2}.
    fn force(&self, impact: &Impact<S>, overlap: S) -> ContactForce<S> {
        let rigidity = self.stiffness(impact) * overlap.sqrt();
        ContactForce {
            elastic: rigidity * overlap,
            damping: S::from_f64(1.5) * self.dissipation * rigidity,
        }
    }

    /// 3.218 T (the elastic central collision's duration), or half a period about a static overlap.
    fn contact_time(&self, impact: &Impact<S>, overlap: S) -> S {
        let impulsive = match impact.normal_speed > S::zero() {
            true => S::from_f64(3.218_066) * self.scales(impact).time,
            false => S::NEVER,
        };
        let stiffness = S::from_f64(1.5) * self.stiffness(impact) * overlap.max(S::zero()).sqrt();
        if !(stiffness > S::zero()) {
            return impulsive;
        }
        let pressed = impact.reduced_mass.sqrt_of_ratio(stiffness);
        impulsive.min(S::from_f64(core::f64::consts::PI) * pressed)
    }

    fn check(&self) -> Result<(), Error> {
        positive("young", self.young)?;
        not_negative("dissipation", self.dissipation)?;
        let nu = self.poisson;
        if nu > -S::one() && nu <= S::half() {
            return Ok(());
        }
        Err(Error::input(Subject::Rule, "poisson", nu.to_f64(), "above -1 and at most 0.5"))
    }
}

impl<S: Scalar> Viscoelastic<S> {
    /// ρ = (2/3) Y √R_eff / (1 − ν²) (MP13, below Eq. 51).
    fn stiffness(&self, impact: &Impact<S>) -> S {
        let one = S::one();
        let two_thirds = S::from_f64(2.0 / 3.0);
        two_thirds * self.young * impact.effective_radius.sqrt()
            / (one - self.poisson * self.poisson)
    }
}

/// What is no number in fixed point is one that was too large.
fn fits<S: Scalar>(field: &'static str, value: S) -> Result<(), Error> {
    if S::RANGE.is_some() && !value.is_finite() {
        return Err(Error::overflow(Subject::Rule, field, S::NEVER.to_f64()));
    }
    Ok(())
}

pub(super) fn positive<S: Scalar>(field: &'static str, value: S) -> Result<(), Error> {
    fits(field, value)?;
    if value > S::zero() && value.is_finite() {
        return Ok(());
    }
    Err(Error::input(Subject::Rule, field, value.to_f64(), "finite and above 0"))
}

pub(super) fn not_negative<S: Scalar>(field: &'static str, value: S) -> Result<(), Error> {
    fits(field, value)?;
    if value >= S::zero() && value.is_finite() {
        return Ok(());
    }
    Err(Error::input(Subject::Rule, field, value.to_f64(), "finite and at least 0"))
}
