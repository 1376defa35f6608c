//! What force do two overlapping grains feel? Reads a force law, radii and masses; writes the normal force.

use super::error::{ReferenceError, positive, zero_or_more};

/// A contact force law, with its material parameters.
///
/// Both laws are purely normal (smooth grains). Radii and masses belong to the grains, so one law
/// serves grains of any size; [`ForceLaw::pair`] and [`ForceLaw::wall`] put both together.
///
/// # Units
///
/// SI, or any consistent set.
///
/// # Examples
///
/// ```
/// use carom_host::reference::ForceLaw;
/// let law = ForceLaw::Viscoelastic { young: 1e9, poisson: 0.4, dissipation: 0.0 };
/// let contact = law.pair([0.1, 0.1], [4.775, 4.775]);
/// assert!(contact.force(1e-3, 0.0) > 0.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ForceLaw {
    /// Linear spring and dashpot, F_n = k x + γ ẋ (MP13 Eq. 40; L94 Eq. 5).
    LinearDashpot {
        /// Spring constant k, > 0 (N/m).
        stiffness: f64,
        /// Dashpot constant γ, ≥ 0 (kg/s). L94's μ is γ / (2 m_eff): for equal grains μ at a wall
        /// is half of μ between grains, as in L94 Sec. III A.
        damping: f64,
    },
    /// Viscoelastic spheres, F_n = ρ x^{3/2} + (3/2) A ρ ẋ √x (MP13 Eq. 51), with
    /// ρ = 2 Y √R_eff / (3 (1 − ν²)).
    Viscoelastic {
        /// Young's modulus Y, > 0 (Pa).
        young: f64,
        /// Poisson's ratio ν, −1 < ν ≤ 0.5.
        poisson: f64,
        /// Dissipative constant A, ≥ 0 (s).
        dissipation: f64,
    },
}

/// When is a contact over?
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum End {
    /// When the normal force vanishes while the grains separate (MP13 Eq. 10): never attraction.
    /// The grains may still overlap; the force stays zero until it would push again.
    #[default]
    Force,
    /// When the overlap vanishes (L94 Eq. 6): until then the dashpot may pull.
    Overlap,
}

/// How the elastic force grows with the overlap.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Shape {
    /// Force ∝ x.
    Linear,
    /// Force ∝ x^{3/2}.
    Hertz,
}

/// A [`ForceLaw`] between two given partners: F_n = g(x) (x + θ ẋ).
///
/// Both laws have this form, with g = k and θ = γ/k (spring and dashpot), or g = ρ √x and
/// θ = 3A/2 (viscoelastic). F_n = 0 at x > 0 therefore means x + θ ẋ = 0 for both. L94's general
/// law (Eq. 8) needs a second exponent, x^s + θ ẋ, and fits in here.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactLaw {
    pub(super) stiffness: f64,
    pub(super) relaxation: f64,
    pub(super) mass: f64,
    pub(super) shape: Shape,
}

impl ForceLaw {
    /// Checks the parameters.
    ///
    /// # Errors
    ///
    /// [`ReferenceError::Parameter`] naming the parameter, its value and what would be right.
    pub fn validate(&self) -> Result<(), ReferenceError> {
        match *self {
            Self::LinearDashpot { stiffness, damping } => {
                positive("stiffness", stiffness)?;
                zero_or_more("damping", damping)
            }
            Self::Viscoelastic { young, poisson, dissipation } => {
                positive("young", young)?;
                if !(poisson > -1.0 && poisson <= 0.5) {
                    let wanted = "above -1 and at most 0.5";
                    return Err(ReferenceError::parameter("poisson", poisson, wanted));
                }
                zero_or_more("dissipation", dissipation)
            }
        }
    }

    /// The law between two grains of the given radii and masses.
    pub fn pair(&self, radii: [f64; 2], masses: [f64; 2]) -> ContactLaw {
        let reduced = |a: [f64; 2]| a[0] * (a[1] / (a[0] + a[1]));
        self.between(reduced(radii), reduced(masses))
    }

    /// The law between a grain and a plane wall: R_eff = R, m_eff = m.
    pub fn wall(&self, radius: f64, mass: f64) -> ContactLaw {
        self.between(radius, mass)
    }

    fn between(&self, radius: f64, mass: f64) -> ContactLaw {
        match *self {
            Self::LinearDashpot { stiffness, damping } => {
                let relaxation = damping / stiffness;
                ContactLaw { stiffness, relaxation, mass, shape: Shape::Linear }
            }
            Self::Viscoelastic { young, poisson, dissipation } => {
                let stiffness = 2.0 * young * radius.sqrt() / (3.0 * (1.0 - poisson * poisson));
                let relaxation = 1.5 * dissipation;
                ContactLaw { stiffness, relaxation, mass, shape: Shape::Hertz }
            }
        }
    }
}

impl ContactLaw {
    /// The normal force F_n at overlap x ≥ 0 and overlap rate ẋ; negative where the dashpot pulls.
    ///
    /// # Units
    ///
    /// Overlap in m, rate in m/s, force in N.
    pub fn force(&self, overlap: f64, rate: f64) -> f64 {
        self.gain(overlap.max(0.0).sqrt()) * (overlap + self.relaxation * rate)
    }

    /// The normal force as a contact with the given end feels it: [`End::Force`] never pulls.
    #[inline]
    pub fn force_until(&self, overlap: f64, rate: f64, end: End) -> f64 {
        match end {
            End::Force => self.force(overlap, rate).max(0.0),
            End::Overlap => self.force(overlap, rate),
        }
    }

    /// The elastic energy stored at overlap x ≥ 0: k x²/2, or (2/5) ρ x^{5/2}.
    pub fn elastic_energy(&self, overlap: f64) -> f64 {
        let x = overlap.max(0.0);
        match self.shape {
            Shape::Linear => 0.5 * self.stiffness * x * x,
            Shape::Hertz => 0.4 * self.stiffness * x * x * x.sqrt(),
        }
    }

    /// The time scale T of MP13 for an impact at normal speed v_n: √(m/k) (Eq. 41), or
    /// (m/ρ)^{2/5} v_n^{−1/5} (viscoelastic).
    pub fn time_scale(&self, speed: f64) -> f64 {
        match self.shape {
            Shape::Linear => (self.mass / self.stiffness).sqrt(),
            Shape::Hertz => (self.mass / self.stiffness).powf(0.4) * speed.powf(-0.2),
        }
    }

    /// A length of contact to choose steps by: π T or 3.218 T (undamped, central), shortened
    /// where the dashpot is the faster of the two.
    ///
    /// With c_dis = θ/T the velocity of a strongly damped contact decays within about T/c_dis
    /// (spring and dashpot) or T/c_dis^{2/3} (viscoelastic), which a step has to resolve.
    pub fn contact_time(&self, speed: f64) -> f64 {
        let scale = self.time_scale(speed);
        let damped = self.relaxation / scale;
        match self.shape {
            Shape::Linear => std::f64::consts::PI * scale / damped.max(1.0),
            Shape::Hertz => 3.218_066 * scale / damped.max(1.0).powf(2.0 / 3.0),
        }
    }

    /// g, given √x.
    #[inline]
    pub(super) fn gain(&self, root: f64) -> f64 {
        match self.shape {
            Shape::Linear => self.stiffness,
            Shape::Hertz => self.stiffness * root,
        }
    }

    /// x ω(x): the speed that goes with overlap x in an elastic oscillation.
    pub(super) fn speed_scale(&self, overlap: f64) -> f64 {
        let x = overlap.max(0.0);
        x * (self.gain(x.sqrt()) / self.mass).sqrt()
    }
}
