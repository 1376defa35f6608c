//! What force do bodies feel that hold each other, or remember how deep they were? Reads a law's constants and a pair's sizes; writes the normal force.

use crate::contact_law::ContactLaw;
use crate::error::{ReferenceError, positive, zero_or_more};
use std::f64::consts::PI;

/// A normal force of a kind that [`ForceLaw`](crate::ForceLaw) has not; one that holds is negative.
///
/// # Units
///
/// SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GeneralLaw {
    /// F = k x^β + γ x^γ′ ẋ, never below zero (L94, Appendix).
    Power {
        /// k > 0 (N/m^β).
        stiffness: f64,
        /// β ≥ 1.
        exponent: f64,
        /// γ ≥ 0 (N s/m^(1 + γ′)).
        damping: f64,
        /// γ′ ≥ 0.
        damping_exponent: f64,
    },
    /// k₁ x while x grows; k₂ (x − x₀), never below zero, while it does not (Walton & Braun, J. Rheol. 30, 949, 1986).
    WaltonBraun {
        /// k₁ > 0 (N/m).
        loading: f64,
        /// k₂ ≥ k₁ (N/m).
        unloading: f64,
    },
    /// Hertz's force with the dissipation of viscoelastic spheres, never below zero, less 2 π w R_eff (Derjaguin, Muller &
    /// Toporov, J. Colloid Interface Sci. 53, 314, 1975).
    Dmt(Sticky),
    /// Spheres that hold each other beyond the touch, to the pull-off (Johnson, Kendall & Roberts, Proc. R. Soc. A 324,
    /// 301, 1971), with dissipation as the contact's radius grows.
    Jkr(Sticky),
}

/// Two spheres of one material that stick.
///
/// # Units
///
/// SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sticky {
    /// Young's modulus Y > 0 (Pa).
    pub young: f64,
    /// Poisson's ratio −1 < ν ≤ 1/2.
    pub poisson: f64,
    /// A ≥ 0 (s).
    pub dissipation: f64,
    /// Work of adhesion w ≥ 0 (J/m²).
    pub work: f64,
}

impl Sticky {
    /// 1/E* = (1 − ν²)/Y of either.
    fn modulus(&self) -> f64 {
        1.0 / (2.0 * (1.0 - self.poisson * self.poisson) / self.young)
    }

    fn validate(&self) -> Result<(), ReferenceError> {
        positive("young", self.young)?;
        zero_or_more("dissipation", self.dissipation)?;
        zero_or_more("work", self.work)?;
        if self.poisson > -1.0 && self.poisson <= 0.5 {
            return Ok(());
        }
        Err(ReferenceError::parameter("poisson", self.poisson, "above -1 and at most 0.5"))
    }
}

impl GeneralLaw {
    /// Checks the parameters.
    ///
    /// # Errors
    ///
    /// [`ReferenceError::Parameter`] naming the parameter, its value and what would be right.
    pub fn validate(&self) -> Result<(), ReferenceError> {
        match *self {
            Self::Power { stiffness, exponent, damping, damping_exponent } => {
                positive("stiffness", stiffness)?;
                zero_or_more("damping", damping)?;
                zero_or_more("damping_exponent", damping_exponent)?;
                if (1.0..=16.0).contains(&exponent) {
                    return Ok(());
                }
                Err(ReferenceError::parameter("exponent", exponent, "between 1 and 16"))
            }
            Self::WaltonBraun { loading, unloading } => {
                positive("loading", loading)?;
                if unloading >= loading && unloading.is_finite() {
                    return Ok(());
                }
                let wanted = "finite and at least that of loading";
                Err(ReferenceError::parameter("unloading", unloading, wanted))
            }
            Self::Dmt(of) | Self::Jkr(of) => of.validate(),
        }
    }
}

/// A law between two given bodies.
pub(crate) enum Normal {
    /// The contact ends when the force vanishes.
    Plain(ContactLaw),
    /// It ends when nothing can hold the two any more.
    General(Bound),
}

/// A law, a constant force that holds, R_eff and m_eff.
pub(crate) struct Bound {
    pub law: GeneralLaw,
    pub cohesion: f64,
    pub radius: f64,
    pub mass: f64,
}

impl Normal {
    /// The force at this overlap, which has been as deep as that.
    pub fn force(&self, overlap: f64, rate: f64, deepest: f64) -> f64 {
        match self {
            Self::Plain(law) => law.force(overlap.max(0.0), rate),
            Self::General(bound) => bound.force(overlap, rate, deepest.max(overlap)),
        }
    }

    /// How fast the force grows with the overlap and with its rate.
    pub fn slopes(&self, [x, u]: [f64; 2], deepest: f64) -> [f64; 2] {
        let h = 1e-6;
        let du = h * u.abs().max(1e-300);
        match self {
            Self::Plain(law) => {
                let force = |x: f64, u| law.force(x.max(0.0), u);
                [
                    (force(x * (1.0 + h), u) - force(x * (1.0 - h), u)) / (2.0 * h * x),
                    (force(x, u + du) - force(x, u - du)) / (2.0 * du),
                ]
            }
            Self::General(bound) => {
                // The way the contact goes: what stays pressed has another slope back.
                let dx = h * x.abs().copysign(u);
                let force = |x: f64, u| bound.uncut(x, u, deepest.max(x));
                let here = force(x, u);
                [(force(x + dx, u) - here) / dx, (force(x, u + du) - here) / du]
            }
        }
    }

    /// Whether the contact is over.
    pub fn is_over(&self, [overlap, rate]: [f64; 2], force: f64) -> bool {
        match self {
            Self::Plain(_) => force <= 0.0 || overlap <= 0.0,
            Self::General(bound) => overlap <= -bound.reach() && rate < 0.0,
        }
    }

    /// A time in which a contact at this speed changes, and a length.
    pub fn scales(&self, speed: f64) -> [f64; 2] {
        match self {
            Self::Plain(law) => [law.time_scale(speed), speed * law.time_scale(speed)],
            Self::General(bound) => {
                let speed = speed.max(bound.held_speed());
                [bound.time_scale(speed), speed * bound.time_scale(speed)]
            }
        }
    }
}

impl Bound {
    fn force(&self, x: f64, u: f64, deepest: f64) -> f64 {
        let pushed = self.uncut(x, u, deepest);
        match self.law {
            GeneralLaw::Jkr(_) => pushed - self.cohesion,
            GeneralLaw::Dmt(of) => {
                pushed.max(0.0) - 2.0 * PI * of.work * self.radius - self.cohesion
            }
            _ => pushed.max(0.0) - self.cohesion,
        }
    }

    /// What pushes, before it is cut where it would hold; of JKR what holds, too.
    fn uncut(&self, x: f64, u: f64, deepest: f64) -> f64 {
        match self.law {
            GeneralLaw::Power { stiffness, exponent, damping, damping_exponent } => {
                let x = x.max(0.0);
                stiffness * x.powf(exponent) + damping * x.powf(damping_exponent) * u
            }
            GeneralLaw::WaltonBraun { loading, unloading } => {
                // The line of unloading meets zero at x₀.
                let lost = deepest * (1.0 - loading / unloading);
                unloading * (x - lost)
            }
            GeneralLaw::Dmt(of) => {
                let a = (x.max(0.0) * self.radius).sqrt();
                let hertz = 4.0 / 3.0 * of.modulus() * a * x.max(0.0);
                hertz + 2.0 * of.modulus() * of.dissipation * a * u
            }
            GeneralLaw::Jkr(of) => {
                let (a, modulus) = (self.contact_radius(&of, x), of.modulus());
                let held = (8.0 * PI * of.work * modulus * a * a * a).sqrt();
                4.0 / 3.0 * modulus * a * a * a / self.radius - held
                    + 2.0 * modulus * of.dissipation * a * u
            }
        }
    }

    /// a³ = π w R²/(8 E*): below it no contact is.
    fn least_radius(&self, of: &Sticky) -> f64 {
        (PI * of.work * self.radius * self.radius / (8.0 * of.modulus())).cbrt()
    }

    /// The larger a with x = a²/R − √(2 π w a/E*), by halving.
    fn contact_radius(&self, of: &Sticky, x: f64) -> f64 {
        let c = (2.0 * PI * of.work / of.modulus()).sqrt();
        let least = self.least_radius(of);
        let (mut low, mut high) = (least, (x.max(0.0) * self.radius).sqrt() + 4.0 * least);
        loop {
            let a = 0.5 * (low + high);
            if !(low < a && a < high) {
                return a;
            }
            if a * a / self.radius - c * a.sqrt() < x { low = a } else { high = a }
        }
    }

    /// Up to which gap the two hold each other: 3 a²/R at the pull-off.
    fn reach(&self) -> f64 {
        match self.law {
            GeneralLaw::Jkr(of) => 3.0 * self.least_radius(&of).powi(2) / self.radius,
            _ => 0.0,
        }
    }

    /// k and β of about k x^β.
    fn power(&self) -> [f64; 2] {
        match self.law {
            GeneralLaw::Power { stiffness, exponent, .. } => [stiffness, exponent],
            GeneralLaw::WaltonBraun { unloading, .. } => [unloading, 1.0],
            GeneralLaw::Dmt(of) | GeneralLaw::Jkr(of) => {
                [4.0 / 3.0 * of.modulus() * self.radius.sqrt(), 1.5]
            }
        }
    }

    /// x/v with m v² = k x^(1 + β).
    fn time_scale(&self, speed: f64) -> f64 {
        let [k, beta] = self.power();
        (self.mass * speed * speed / k).powf(1.0 / (1.0 + beta)) / speed
    }

    /// A speed that what holds gives to the two: m v² = k x^(1 + β) where k x^β is as strong.
    fn held_speed(&self) -> f64 {
        let work = match self.law {
            GeneralLaw::Dmt(of) | GeneralLaw::Jkr(of) => of.work,
            _ => 0.0,
        };
        let [k, beta] = self.power();
        let force = self.cohesion + 2.0 * PI * work * self.radius;
        (k * (force / k).powf(1.0 + 1.0 / beta) / self.mass).sqrt()
    }
}
