//! What force goes with an overlap and its rate? Reads one contact's constants and exponents; writes force, energy and time scales.

/// When is a contact over?
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum End {
    /// When the normal force vanishes while the grains separate (MP13 Eq. 10): never attraction.
    /// The grains may still overlap; the force stays zero until it would push again.
    #[default]
    Force,
    /// When the overlap vanishes (L94 Eq. 6): until then the dashpot may pull.
    Overlap,
}

/// A `ForceLaw` between two given partners: F_n = K x^{1+β} + C x^γ ẋ.
///
/// Written as F_n = K x^γ (x^s + θ ẋ) with s = 1 + β − γ and θ = C/K: F_n = 0 at x > 0 then means
/// x^s + θ ẋ = 0. MP13's laws both have s = 1: spring and dashpot β = γ = 0, viscoelastic spheres
/// β = γ = 1/2; L94 Eq. (8) leaves β and γ free.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ContactLaw {
    pub(crate) stiffness: f64,
    pub(crate) relaxation: f64,
    pub(crate) mass: f64,
    /// D_t m_ij.
    pub(crate) tangential: f64,
    beta: f64,
    gamma: f64,
    shape: Shape,
}

/// What the exponents are like: x = q^p makes the powers of x in the force powers of q.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
enum Shape {
    /// β = γ = 0.
    Linear,
    /// β = γ = 1/2.
    Hertz,
    /// β p, γ p integers (or nearly so), as exponents of q for x^γ and x^s.
    Power { p: i32, gain: i32, spring: i32 },
    /// No small p does.
    Any,
}

impl Shape {
    #[inline]
    fn of(beta: f64, gamma: f64) -> Self {
        if beta == gamma && (beta == 0.0 || beta == 0.5) {
            return if beta == 0.0 { Self::Linear } else { Self::Hertz };
        }
        let whole = |x: f64| (x - x.round()).abs() < 1e-12;
        let fits = |p: &i32| whole(beta * f64::from(*p)) && whole(gamma * f64::from(*p));
        let Some(p) = (1..=8).find(fits) else { return Self::Any };
        let [beta, gain] = [beta, gamma].map(|e| (e * f64::from(p)).round() as i32);
        Self::Power { p, gain, spring: p + beta - gain }
    }
}

impl ContactLaw {
    /// `constants` K and C, `exponents` β and γ.
    #[inline]
    pub(crate) fn new(mass: f64, constants: [f64; 2], exponents: [f64; 2]) -> Self {
        let ([stiffness, damping], [beta, gamma]) = (constants, exponents);
        let (relaxation, shape) = (damping / stiffness, Shape::of(beta, gamma));
        Self { stiffness, relaxation, mass, tangential: 0.0, beta, gamma, shape }
    }

    #[inline]
    pub(crate) fn rubbing(self, tangential: f64) -> Self {
        Self { tangential, ..self }
    }

    /// The normal force F_n at overlap x ≥ 0 and overlap rate ẋ; negative where the dashpot pulls.
    ///
    /// # Units
    ///
    /// Overlap in m, rate in m/s, force in N.
    #[inline]
    pub fn force(&self, overlap: f64, rate: f64) -> f64 {
        let root = self.root(overlap);
        self.gain(root) * (self.spring(overlap, root) + self.relaxation * rate)
    }

    /// The normal force as a contact with the given end feels it: [`End::Force`] never pulls.
    #[inline]
    pub fn force_until(&self, overlap: f64, rate: f64, end: End) -> f64 {
        match end {
            End::Force => self.force(overlap, rate).max(0.0),
            End::Overlap => self.force(overlap, rate),
        }
    }

    /// The elastic energy stored at overlap x ≥ 0: K x^{2+β}/(2 + β).
    pub fn elastic_energy(&self, overlap: f64) -> f64 {
        let x = overlap.max(0.0);
        match self.shape {
            Shape::Linear => 0.5 * self.stiffness * x * x,
            Shape::Hertz => 0.4 * self.stiffness * x * x * x.sqrt(),
            _ => self.stiffness * libm::pow(x, 2.0 + self.beta) / (2.0 + self.beta),
        }
    }

    /// The time scale T = (m/K)^{1/(2+β)} v_n^{−β/(2+β)} for an impact at normal speed v_n:
    /// √(m/k) (MP13 Eq. 41), or (m/ρ)^{2/5} v_n^{−1/5} (viscoelastic).
    pub fn time_scale(&self, speed: f64) -> f64 {
        let square = self.mass / self.stiffness;
        match self.shape {
            Shape::Linear => square.sqrt(),
            Shape::Hertz => libm::pow(square, 0.4) * libm::pow(speed, -0.2),
            _ => libm::pow(square * libm::pow(speed, -self.beta), 1.0 / (2.0 + self.beta)),
        }
    }

    /// The largest overlap of an undamped impact at normal speed v_n (L94 Eq. A1).
    pub fn deepest(&self, speed: f64) -> f64 {
        libm::pow(1.0 + 0.5 * self.beta, 1.0 / (2.0 + self.beta)) * speed * self.time_scale(speed)
    }

    /// A length of contact to choose steps by: that of an undamped central impact (L94 Eq. A2: π T,
    /// 3.218 T …), shortened where the dashpot is the faster of the two.
    ///
    /// With c = θ v_n/X^s, X = v_n T, the velocity of a strongly damped contact decays within about
    /// T c^{−1/(1+γ)}, which a step has to resolve.
    pub fn contact_time(&self, speed: f64) -> f64 {
        let scale = self.time_scale(speed);
        let damped = match self.shape {
            Shape::Linear | Shape::Hertz => self.relaxation / scale,
            _ => self.relaxation * speed * libm::pow(speed * scale, self.gamma - self.beta - 1.0),
        };
        let exponent = 1.0 / (1.0 + self.gamma);
        let undamped = match self.shape {
            Shape::Linear => std::f64::consts::PI,
            Shape::Hertz => 3.218_066,
            _ => duration(self.beta) * libm::pow(1.0 + 0.5 * self.beta, 1.0 / (2.0 + self.beta)),
        };
        undamped * scale / libm::pow(damped.max(1.0), exponent)
    }

    /// p, where x = q^p makes the force smooth in q; 1 where it is smooth in x.
    #[inline]
    pub(crate) fn order(&self) -> i32 {
        match self.shape {
            Shape::Linear => 1,
            Shape::Hertz => 2,
            Shape::Power { p, .. } => p,
            Shape::Any => 4,
        }
    }

    /// q = x^{1/p}.
    #[inline]
    pub(crate) fn root(&self, overlap: f64) -> f64 {
        let x = overlap.max(0.0);
        match self.order() {
            1 => x,
            2 => x.sqrt(),
            p => libm::pow(x, 1.0 / f64::from(p)),
        }
    }

    /// K x^γ, given q.
    #[inline]
    pub(crate) fn gain(&self, root: f64) -> f64 {
        self.stiffness
            * match self.shape {
                Shape::Linear => 1.0,
                Shape::Hertz => root,
                Shape::Power { gain, .. } => root.powi(gain),
                Shape::Any => libm::pow(root, 4.0 * self.gamma),
            }
    }

    /// x^s, given x and q.
    #[inline]
    pub(crate) fn spring(&self, overlap: f64, root: f64) -> f64 {
        match self.shape {
            Shape::Linear | Shape::Hertz => overlap,
            Shape::Power { spring, .. } => root.powi(spring),
            Shape::Any => libm::pow(root, 4.0 * (1.0 + self.beta - self.gamma)),
        }
    }

    /// Whether x^s + θ ẋ can stand for ẋ as an unknown: s = 1.
    #[inline]
    pub(crate) fn proportional(&self) -> bool {
        self.beta == self.gamma
    }

    /// Positive where two overlapping grains push: x^s + θ ẋ.
    #[inline]
    pub(crate) fn push(&self, overlap: f64, rate: f64) -> f64 {
        self.spring(overlap, self.root(overlap)) + self.relaxation * rate
    }

    /// ω(x) = √(K x^β/m), the frequency of an elastic oscillation as wide as x.
    pub(crate) fn frequency(&self, overlap: f64) -> f64 {
        let x = overlap.max(0.0);
        let power = match self.shape {
            Shape::Linear => 1.0,
            Shape::Hertz => x.sqrt(),
            _ => libm::pow(x, self.beta),
        };
        (self.stiffness * power / self.mass).sqrt()
    }

    /// x ω(x): the speed that goes with overlap x in an elastic oscillation.
    pub(crate) fn speed_scale(&self, overlap: f64) -> f64 {
        overlap.max(0.0) * self.frequency(overlap)
    }
}

/// I(β) of L94 Eq. (A2): the duration of an undamped contact in units of x_max/v_0.
fn duration(beta: f64) -> f64 {
    let gamma = libm::tgamma;
    let (a, b) = (1.0 / (2.0 + beta), (4.0 + beta) / (4.0 + 2.0 * beta));
    std::f64::consts::PI.sqrt() * gamma(a) / ((1.0 + 0.5 * beta) * gamma(b))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn durations_of_the_paper() {
        assert!((duration(0.0) - std::f64::consts::PI).abs() < 1e-14);
        assert!((duration(0.5) - 2.943_275_184).abs() < 1e-9);
    }

    #[test]
    fn special_shapes_are_the_general_one() {
        for exponents in [[0.0, 0.0], [0.5, 0.5], [0.5, 0.0], [0.0, 0.2], [0.5, 0.25], [0.31, 0.17]]
        {
            let law = ContactLaw::new(0.7, [3e4, 20.0], exponents);
            let (x, u, [beta, gamma]) = (1.3e-3_f64, -0.4, exponents);
            let wanted = 3e4 * x.powf(1.0 + beta) + 20.0 * x.powf(gamma) * u;
            assert!((law.force(x, u) / wanted - 1.0).abs() < 1e-13, "{exponents:?}");
            let any = ContactLaw { shape: Shape::Any, ..law };
            assert!((any.time_scale(0.3) / law.time_scale(0.3) - 1.0).abs() < 1e-14);
            assert!((any.contact_time(0.3) / law.contact_time(0.3) - 1.0).abs() < 1e-6);
            assert!((any.frequency(x) / law.frequency(x) - 1.0).abs() < 1e-14);
        }
    }
}
