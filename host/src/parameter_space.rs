//! Which scaled parameters do MP13's Tables I and II span? Reads ln(c_φ/c_φ^min), ln(l~/l~^min) and a damping; writes the groups of the contact equation.

use carom_tables::read::{Groups, Law};
use std::f64::consts::PI;

/// The smallest and largest eccentricity of both tables.
const ECCENTRICITY: [f64; 2] = [0.01, 0.99];
/// Radius (m), density (kg/m³) and speed (m/s), the same in both tables.
const RADIUS: [f64; 2] = [0.001, 0.1];
const DENSITY: [f64; 2] = [250.0, 3250.0];
const SPEED: [f64; 2] = [0.001, 25.0];
/// Spring constant (N/m), Table I.
const STIFFNESS: [f64; 2] = [1e3, 1e6];
/// Young modulus (Pa), Poisson ratio and dissipative parameter (s), Table II.
const YOUNG: [f64; 2] = [1e7, 1e11];
const POISSON: [f64; 2] = [0.2, 0.5];
const DISSIPATION: [f64; 2] = [1e-6, 1.0];

/// The space of scaled parameters of one law: MP13 Secs. V A and V B.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Space {
    /// The law.
    pub law: Law,
    /// Range of g = ln(c_φ/l~) = ln tan α, MP13 Eqs. (45) and (46).
    pub g: [f64; 2],
    /// Range of the first term of MP13 Eq. (48) or (55).
    pub m: [f64; 2],
}

impl Space {
    /// Table I.
    pub fn linear() -> Self {
        // l ω / v of two equal spheres
        let m = |k: f64, radius: f64, density: f64, v: f64| {
            (2.0 * radius * (k / effective_mass(radius, density)).sqrt() / v).ln()
        };
        let low = m(STIFFNESS[0], RADIUS[1], DENSITY[1], SPEED[1]);
        let high = m(STIFFNESS[1], RADIUS[0], DENSITY[0], SPEED[0]);
        Self { law: Law::LinearDashpot, g: g(), m: [low, high] }
    }

    /// Table II.
    pub fn viscoelastic() -> Self {
        // l (k/v²)^(2/5) of two equal spheres does not depend on their radius
        let m = |young: f64, poisson: f64, density: f64, v: f64| {
            let (radius, eff) = (1.0, 0.5f64);
            let rho = 2.0 * young * eff.sqrt() / (3.0 * (1.0 - poisson * poisson));
            (2.0 * radius * (rho / effective_mass(radius, density) / (v * v)).powf(0.4)).ln()
        };
        let low = m(YOUNG[0], POISSON[0], DENSITY[1], SPEED[1]);
        let high = m(YOUNG[1], POISSON[1], DENSITY[0], SPEED[0]);
        Self { law: Law::Viscoelastic, g: g(), m: [low, high] }
    }

    /// Extent of ln(c_φ/c_φ^min).
    pub fn width(&self) -> f64 {
        self.g[1] - self.g[0]
    }

    /// Extent of ln(l~/l~^min).
    pub fn height(&self) -> f64 {
        self.m[1] - self.m[0]
    }

    /// The groups at ln(c_φ/c_φ^min) = `u`, ln(l~/l~^min) = `w`: MP13 Eqs. (50) and (61).
    ///
    /// `damping` is ln c_dis for the linear law, ln(c_dis/c_dis^min) for the viscoelastic one.
    pub fn groups(&self, u: f64, w: f64, damping: f64) -> Groups<f64> {
        let tan = (u + self.g[0]).exp();
        let half = 0.5 * (tan * tan).ln_1p();
        let ln_l = |part: f64| w + self.m[0] + 2.0 * part * half;
        let (ln_l, ln_c) = match self.law {
            Law::LinearDashpot => (ln_l(0.5), damping),
            Law::Viscoelastic => {
                let ln_l = ln_l(0.4);
                (ln_l, damping + c_min() + ln_l - half)
            }
        };
        let cos = (-half).exp();
        Groups { sin: tan * cos, cos, eta: (-ln_l).exp(), c_dis: ln_c.exp() }
    }

    /// `u` and `w` of a point (ln c_φ, ln l~), or nothing where the table does not reach, not even
    /// with a margin.
    pub fn near(&self, ln_c_phi: f64, ln_l: f64, margin: f64) -> Option<[f64; 2]> {
        let g = ln_c_phi - ln_l;
        let m = ln_l - self.rise(g);
        let within = |x: f64, [low, high]: [f64; 2]| x >= low - margin && x <= high + margin;
        (within(g, self.g) && within(m, self.m)).then(|| [g - self.g[0], m - self.m[0]])
    }

    /// Points (ln c_φ, ln l~) around the region that the table reaches, clockwise.
    pub fn rim(&self, steps: u32) -> Vec<[f64; 2]> {
        let along =
            |[from, to]: [f64; 2], k: u32| from + (to - from) * f64::from(k) / f64::from(steps);
        let point = |g: f64, m: f64| [m + self.rise(g) + g, m + self.rise(g)];
        let ([left, right], [bottom, top]) = (self.g, self.m);
        let up = (0..steps).map(|k| point(left, along([bottom, top], k)));
        let over = (0..steps).map(|k| point(along([left, right], k), top));
        let down = (0..steps).map(|k| point(right, along([top, bottom], k)));
        let back = (0..steps).map(|k| point(along([right, left], k), bottom));
        up.chain(over).chain(down).chain(back).collect()
    }

    /// The second term of MP13 Eq. (48) or (55).
    fn rise(&self, g: f64) -> f64 {
        let part = if self.law == Law::LinearDashpot { 0.5 } else { 0.4 };
        part * (2.0 * g).exp().ln_1p()
    }
}

fn g() -> [f64; 2] {
    ECCENTRICITY.map(|e| -0.5 * (1.0 / (e * e) - 1.0).ln())
}

/// ln(3/2 A v / l) at its smallest, below MP13 Eq. (59).
pub fn c_min() -> f64 {
    (1.5 * DISSIPATION[0] * SPEED[0] / (2.0 * RADIUS[1])).ln()
}

/// The same at its largest.
pub fn c_max() -> f64 {
    (1.5 * DISSIPATION[1] * SPEED[1] / (2.0 * RADIUS[0])).ln()
}

/// m_eff of two equal spheres.
fn effective_mass(radius: f64, density: f64) -> f64 {
    2.0 / 3.0 * PI * density * radius.powi(3)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The numbers that MP13 states: g from -4.6 to 1.95, m from -2.3 to 14.83 (Eq. 48) and from
    /// 0.75 to 13.66 (Eq. 56), c from -18.71 to 9.84 (below Eq. 59).
    #[test]
    fn ranges_are_those_of_the_paper() {
        let near = |a: f64, b: f64, by: f64| assert!((a - b).abs() <= by, "{a} against {b}");
        let (linear, viscoelastic) = (Space::linear(), Space::viscoelastic());
        near(linear.g[0], -4.6, 0.05);
        near(linear.g[1], 1.95, 0.005);
        near(linear.m[0], -2.3, 0.05);
        near(linear.m[1], 14.83, 0.005);
        near(viscoelastic.m[0], 0.75, 0.005);
        near(viscoelastic.m[1], 13.66, 0.005);
        near(c_min(), -18.71, 0.005);
        near(c_max(), 9.84, 0.005);
    }

    #[test]
    fn groups_lead_back_to_the_axes() {
        let space = Space::linear();
        let groups = space.groups(3.0, 5.0, 0.0);
        let ln_l = -groups.eta.ln();
        let ln_c_phi = ln_l + (groups.sin / groups.cos).ln();
        let [u, w] = space.near(ln_c_phi, ln_l, 0.0).expect("inside Table I");
        assert!((u - 3.0).abs() < 1e-12 && (w - 5.0).abs() < 1e-12, "{u} {w}");
    }
}
