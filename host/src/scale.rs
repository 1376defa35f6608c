//! How do physical parameters become the scaled groups of a contact? Reads SI values; writes nothing, returns groups and scales.
//!
//! This is the only place in the host where the scaling of MP13 (Müller and Pöschel 2013,
//! doi:10.1103/PhysRevE.87.033301) is written down: Eqs. (41), (43), (52) and (53).

use carom_tables::read::{End, Groups, Law, ScaledRestitution};

/// A contact law with its material parameters.
///
/// # Units
/// SI: stiffness in N/m, damping in kg/s, Young modulus in Pa, dissipation in s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Contact {
    /// `F_n = k (l − r) − γ ṙ`, MP13 Eq. (40).
    LinearDashpot {
        /// Spring constant k.
        stiffness: f64,
        /// Dissipative parameter γ.
        damping: f64,
    },
    /// `F_n = ρ_el (l − r)^(3/2) − (3/2) A ρ_el ṙ √(l − r)`, MP13 Eqs. (51) and (52).
    Viscoelastic {
        /// Young modulus Y.
        young: f64,
        /// Poisson ratio ν.
        poisson: f64,
        /// Dissipative parameter A.
        dissipation: f64,
    },
}

impl Contact {
    /// Which scaled problem this law leads to.
    pub fn law(&self) -> Law {
        match self {
            Self::LinearDashpot { .. } => Law::LinearDashpot,
            Self::Viscoelastic { .. } => Law::Viscoelastic,
        }
    }

    /// Length and time scale and dissipation number for a normal impact speed: MP13 Eqs. (41),
    /// (43), (53).
    fn scales(&self, pair: &Pair, normal_speed: f64) -> Scales {
        let mass = pair.effective_mass();
        match *self {
            Self::LinearDashpot { stiffness, damping } => {
                let time = (mass / stiffness).sqrt();
                Scales { length: normal_speed * time, time, c_dis: damping * time / mass }
            }
            Self::Viscoelastic { young, poisson, dissipation } => {
                let rho = hertz(young, poisson, pair.effective_radius());
                let time = (rho / mass).powf(-0.4) * normal_speed.powf(-0.2);
                Scales { length: normal_speed * time, time, c_dis: 1.5 * dissipation / time }
            }
        }
    }
}

/// `ρ_el = 2 Y √R_eff / (3 (1 − ν²))`, MP13 Eq. (52).
fn hertz(young: f64, poisson: f64, effective_radius: f64) -> f64 {
    2.0 * young * effective_radius.sqrt() / (3.0 * (1.0 - poisson * poisson))
}

/// The two grains of a contact.
///
/// # Units
/// Radii in m, masses in kg.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// R1 and R2.
    pub radii: [f64; 2],
    /// m1 and m2.
    pub masses: [f64; 2],
}

impl Pair {
    /// `m_eff = m1 m2 / (m1 + m2)`, MP13 Eq. (5).
    pub fn effective_mass(&self) -> f64 {
        let [a, b] = self.masses;
        a * (b / (a + b))
    }

    /// `R_eff = R1 R2 / (R1 + R2)`.
    pub fn effective_radius(&self) -> f64 {
        let [a, b] = self.radii;
        a * (b / (a + b))
    }

    /// `l = R1 + R2`.
    pub fn contact_distance(&self) -> f64 {
        self.radii[0] + self.radii[1]
    }
}

struct Scales {
    length: f64,
    time: f64,
    c_dis: f64,
}

/// One impact in scaled form, with the scale that leads back to seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impact {
    /// The three numbers on which the matrix of restitution depends.
    pub groups: Groups<f64>,
    /// T: multiply ε_t by it to get the duration of the contact in seconds.
    pub time: f64,
}

impl Impact {
    /// Scales an impact of `pair` with relative speed `speed` and eccentricity `e = d/l = sin α`.
    ///
    /// The normal impact speed is `v √(1 − e²)`, written as a product so that it stays exact near
    /// grazing.
    ///
    /// # Units
    /// `speed` in m/s.
    ///
    /// ```
    /// use carom_host::scale::{Contact, Impact, Pair};
    /// // MP13 Fig. 6: l~ = 1.21359..., no damping.
    /// let pair = Pair { radii: [0.1; 2], masses: [4.775220833456486; 2] };
    /// let law = Contact::LinearDashpot { stiffness: 2000.0, damping: 0.0 };
    /// let impact = Impact::new(&law, &pair, 5.0, 0.3);
    /// assert!((1.0 / impact.groups.eta - 1.2135915964710113).abs() < 1e-14);
    /// assert_eq!(impact.groups.c_dis, 0.0);
    /// ```
    pub fn new(contact: &Contact, pair: &Pair, speed: f64, e: f64) -> Self {
        let cos = ((1.0 - e) * (1.0 + e)).sqrt();
        let scales = contact.scales(pair, speed * cos);
        let eta = scales.length / pair.contact_distance();
        let groups = Groups { sin: e, cos, eta, c_dis: scales.c_dis };
        Self { groups, time: scales.time }
    }

    /// `1 − ε_r` without cancellation.
    ///
    /// When the force vanishes at the end of the contact, `x = c_dis |x'|` holds there, so
    /// `1 − ε_r = η c_dis |ε_ṙ|`. When the contact ends at overlap zero, `ε_r = 1`.
    pub fn shortfall(&self, scaled: &ScaledRestitution<f64>, end: End) -> f64 {
        match end {
            End::Force => self.groups.c_dis * scaled.speed * self.groups.eta,
            End::Overlap => 0.0,
        }
    }
}
