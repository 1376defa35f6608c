//! What force do two overlapping grains feel? Reads a force law, radii and masses; writes the normal force.

use crate::contact_law::ContactLaw;
use crate::error::{ReferenceError, positive, zero_or_more};

/// A contact force law, with its material parameters.
///
/// Grains do not rotate; only L94's law has a tangential force. Radii and masses belong to the
/// grains, so one law serves grains of any size; [`ForceLaw::pair`] and [`ForceLaw::wall`] put both
/// together.
///
/// # Units
///
/// SI, or any consistent set.
///
/// # Examples
///
/// ```
/// use carom_reference::ForceLaw;
/// let law = ForceLaw::Viscoelastic { young: 1e9, poisson: 0.4, dissipation: 0.0 };
/// let contact = law.pair([0.1, 0.1], [4.775, 4.775]);
/// assert!(contact.force(1e-3, 0.0) > 0.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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
    /// L94's general law, F_n = K x^{1+β} + D_n m_ij x^γ ẋ, with the tangential force
    /// F_t = −D_t m_ij v_t (L94 Eqs. 2–4, 8 and those of Sec. IV B).
    ///
    /// Between grains m_ij is twice the reduced mass, at a wall the grain's mass, so that μ = D_n
    /// for a pair and D_n/2 at a wall, with the same K (L94 Sec. III A). L94 Eq. (4) has the mass
    /// of one grain in the place of m_ij; for equal grains both are the same, for others only m_ij
    /// obeys Newton's third law.
    PowerLaw {
        /// Elastic constant K, > 0 (N/m^{1+β}). L94 Eq. (8): K = E d^{1−β}.
        stiffness: f64,
        /// Elastic exponent β, ≥ 0.
        beta: f64,
        /// Normal dissipation D_n, ≥ 0 (1/(s m^γ)). L94 Eq. (8): D_n m_ij = η d^{1−γ}.
        damping: f64,
        /// Dissipative exponent γ, from 0 to 1 + β.
        gamma: f64,
        /// Tangential dissipation D_t, ≥ 0 (1/s).
        tangential: f64,
    },
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
            Self::PowerLaw { stiffness, beta, damping, gamma, tangential } => {
                positive("stiffness", stiffness)?;
                zero_or_more("beta", beta)?;
                zero_or_more("damping", damping)?;
                zero_or_more("tangential", tangential)?;
                if !(0.0..=1.0 + beta).contains(&gamma) {
                    return Err(ReferenceError::parameter("gamma", gamma, "from 0 to 1 + beta"));
                }
                Ok(())
            }
        }
    }

    /// L94's spring and dashpot (β = γ = 0) of which a pair of grains of this mass has the contact
    /// time t_c and the coefficient of restitution ε (L94 Eqs. 6, 7, with [`End::Overlap`](crate::End::Overlap)).
    ///
    /// # Units
    ///
    /// Mass in kg, contact time in s.
    ///
    /// # Errors
    ///
    /// [`ReferenceError::Parameter`] unless mass and contact time are positive and 0 < ε ≤ 1.
    ///
    /// # Examples
    ///
    /// ```
    /// use carom_reference::ForceLaw;
    /// let steel = ForceLaw::spring_of(1.38e-5, 4.6e-6, 0.9)?;
    /// let ForceLaw::PowerLaw { stiffness, damping, .. } = steel else { unreachable!() };
    /// // L94 Sec. III B: ω0 ≈ 6.8e5 1/s, μ ≈ 2.3e4 1/s.
    /// assert!(((2.0 * stiffness / 1.38e-5_f64).sqrt() / 6.8e5 - 1.0).abs() < 0.01);
    /// assert!((damping / 2.3e4 - 1.0).abs() < 0.01);
    /// # Ok::<(), carom_reference::ReferenceError>(())
    /// ```
    pub fn spring_of(
        mass: f64,
        contact_time: f64,
        restitution: f64,
    ) -> Result<Self, ReferenceError> {
        positive("mass", mass)?;
        positive("contact_time", contact_time)?;
        if !(restitution > 0.0 && restitution <= 1.0) {
            let wanted = "above 0 and at most 1";
            return Err(ReferenceError::parameter("restitution", restitution, wanted));
        }
        let mu = -libm::log(restitution) / contact_time;
        let frequency = std::f64::consts::PI / contact_time;
        let stiffness = 0.5 * mass * (frequency * frequency + mu * mu);
        Ok(Self::PowerLaw { stiffness, beta: 0.0, damping: mu, gamma: 0.0, tangential: 0.0 })
    }

    /// The law between two grains of the given radii and masses.
    #[inline]
    pub fn pair(&self, radii: [f64; 2], masses: [f64; 2]) -> ContactLaw {
        let reduced = |a: [f64; 2]| a[0] * (a[1] / (a[0] + a[1]));
        let mass = reduced(masses);
        self.between(reduced(radii), mass, 2.0 * mass)
    }

    /// The law between a grain and a plane wall: R_eff = R, m_eff = m.
    #[inline]
    pub fn wall(&self, radius: f64, mass: f64) -> ContactLaw {
        self.between(radius, mass, mass)
    }

    /// `twice` is L94's m_ij.
    #[inline]
    fn between(&self, radius: f64, mass: f64, twice: f64) -> ContactLaw {
        match *self {
            Self::LinearDashpot { stiffness, damping } => {
                ContactLaw::new(mass, [stiffness, damping], [0.0, 0.0])
            }
            Self::Viscoelastic { young, poisson, dissipation } => {
                let stiffness = 2.0 * young * radius.sqrt() / (3.0 * (1.0 - poisson * poisson));
                ContactLaw::new(mass, [stiffness, 1.5 * dissipation * stiffness], [0.5, 0.5])
            }
            Self::PowerLaw { stiffness, beta, damping, gamma, tangential } => {
                let law = ContactLaw::new(mass, [stiffness, damping * twice], [beta, gamma]);
                law.rubbing(tangential * twice)
            }
        }
    }
}
