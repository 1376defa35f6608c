//! Which collisions does a material or a paper's range of parameters give? Reads SI values; writes groups, or a recipe for them.

use super::spread::Spread;
use crate::form::{Frame, Groups, Law};

/// One collision of two equal spheres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Equal {
    /// Radius of either \[m\].
    pub radius: f64,
    /// Material density \[kg/m^3\].
    pub density: f64,
    /// Relative speed \[m/s\].
    pub speed: f64,
    /// Eccentricity `d/l`.
    pub eccentricity: f64,
}

impl Equal {
    fn effective_mass(&self) -> f64 {
        self.density * self.radius * self.radius * self.radius * (2.0 / 3.0) * core::f64::consts::PI
    }

    fn cos(&self) -> f64 {
        libm::sqrt((1.0 - self.eccentricity) * (1.0 + self.eccentricity))
    }

    /// The groups with stiffness `k` \[N/m\] and damping `gamma` \[kg/s\] (MP13 Eqs. 41, 43).
    pub fn linear(&self, stiffness: f64, damping: f64) -> Groups<f64> {
        let omega = libm::sqrt(stiffness / self.effective_mass());
        let cos = self.cos();
        Groups {
            sin: self.eccentricity,
            cos,
            eta: self.speed * cos / (omega * 2.0 * self.radius),
            c_dis: damping / (self.effective_mass() * omega),
        }
    }

    /// The groups with Young modulus \[Pa\], Poisson ratio and dissipation `A` \[s\] (MP13 Eqs. 52, 53).
    pub fn viscoelastic(&self, young: f64, poisson: f64, dissipation: f64) -> Groups<f64> {
        let rho = 2.0 * young * libm::sqrt(self.radius / 2.0) / (3.0 * (1.0 - poisson * poisson));
        let k = libm::pow(rho / self.effective_mass(), 0.4);
        let cos = self.cos();
        let normal = self.speed * cos;
        Groups {
            sin: self.eccentricity,
            cos,
            eta: libm::pow(normal, 0.8) / (k * 2.0 * self.radius),
            c_dis: 1.5 * dissipation * k * libm::pow(normal, 0.2),
        }
    }
}

/// A collision drawn log-uniformly from MP13's Table I (linear) or Table II (viscoelastic).
///
/// One collision in eight is elastic.
pub fn draw(law: Law, spread: &mut Spread) -> Groups<f64> {
    let hit = Equal {
        radius: spread.logarithmic(0.001, 0.1),
        density: spread.logarithmic(250.0, 3250.0),
        speed: spread.logarithmic(0.001, 25.0),
        eccentricity: spread.logarithmic(0.01, 0.99),
    };
    let elastic = spread.uniform() < 0.125;
    let damped = |value: f64| if elastic { 0.0 } else { value };
    match law {
        Law::LinearDashpot => {
            let stiffness = spread.logarithmic(1e3, 1e6);
            hit.linear(stiffness, damped(spread.logarithmic(0.01, 1.25)))
        }
        Law::Viscoelastic => {
            let young = spread.logarithmic(1e7, 1e11);
            let poisson = spread.logarithmic(0.2, 0.5);
            hit.viscoelastic(young, poisson, damped(spread.logarithmic(1e-6, 1.0)))
        }
    }
}

/// Where the collisions of MP13's tables fall in the unit cube of a frame.
pub(super) fn coordinates(frame: &Frame<f64>) -> Vec<[f64; 3]> {
    let mut spread = Spread::new(5);
    (0..60_000)
        .map(|_| {
            let g = draw(frame.law, &mut spread);
            let tan = g.sin / g.cos;
            frame.coordinates([tan * tan * g.eta, g.eta, g.c_dis])
        })
        .collect()
}
