//! Which groups belong to a collision of real spheres? Reads material, radius and speed in SI units; writes the scaled groups.

use crate::random::Rng;
use crate::read::coordinates::CoordinateMap;
use crate::read::groups::Groups;
use crate::read::law::Law;

/// One collision of two equal spheres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EqualSpheres {
    /// Radius of either \[m\].
    pub radius: f64,
    /// Material density \[kg/m^3\].
    pub density: f64,
    /// Relative speed at impact \[m/s\].
    pub speed: f64,
    /// Eccentricity `d/l`: 0 for a central collision, 1 for a grazing one.
    pub eccentricity: f64,
}

impl EqualSpheres {
    fn effective_mass(&self) -> f64 {
        self.density * self.radius * self.radius * self.radius * (2.0 / 3.0) * core::f64::consts::PI
    }

    fn cos(&self) -> f64 {
        libm::sqrt((1.0 - self.eccentricity) * (1.0 + self.eccentricity))
    }

    /// The groups of the linear spring-dashpot (MP13 Eqs. 41, 43).
    ///
    /// # Units
    /// `stiffness` k in N/m, `damping` γ in kg/s.
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

    /// The groups of viscoelastic spheres (MP13 Eqs. 52, 53).
    ///
    /// # Units
    /// `young` Y in Pa, `poisson` ν without unit, `dissipation` A in s.
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
pub fn draw_from_mp13(law: Law, rng: &mut Rng) -> Groups<f64> {
    let hit = EqualSpheres {
        radius: rng.log_uniform(0.001, 0.1),
        density: rng.log_uniform(250.0, 3250.0),
        speed: rng.log_uniform(0.001, 25.0),
        eccentricity: rng.log_uniform(0.01, 0.99),
    };
    let elastic = rng.uniform() < 0.125;
    let damped = |value: f64| if elastic { 0.0 } else { value };
    match law {
        Law::LinearDashpot => {
            let stiffness = rng.log_uniform(1e3, 1e6);
            hit.linear(stiffness, damped(rng.log_uniform(0.01, 1.25)))
        }
        Law::Viscoelastic => {
            let young = rng.log_uniform(1e7, 1e11);
            let poisson = rng.log_uniform(0.2, 0.5);
            hit.viscoelastic(young, poisson, damped(rng.log_uniform(1e-6, 1.0)))
        }
    }
}

/// Where collisions drawn from MP13's tables lie in the unit cube.
pub(crate) fn typical_points(map: &CoordinateMap<f64>) -> Vec<[f64; 3]> {
    let mut rng = Rng::new(5);
    (0..60_000)
        .map(|_| {
            let g = draw_from_mp13(map.law, &mut rng);
            let tan = g.sin / g.cos;
            map.cube_point([tan * tan * g.eta, g.eta, g.c_dis])
        })
        .collect()
}
