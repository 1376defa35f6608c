//! How should a gas of viscoelastic grains cool? Reads the gas; writes τ and T(t) by Brilliantov and Pöschel's theory.

use crate::figure::hard::pressure::carnahan_starling;
use crate::figure::mp13::gas::{RADIUS, SPEED, SoftGas, mass};
use std::f64::consts::PI;

/// Brilliantov and Pöschel's theory of the gas: Maxwellian velocities and ε = 1 − a v^(1/5) + (3/5) a² v^(2/5).
#[derive(Clone, Copy, Debug)]
pub struct Theory {
    /// a.
    pub loss: f64,
    /// Collisions of one grain in a unit of time, over √(T/m).
    rate: f64,
}

/// C_1 of 1 − ε = C_1 (3 A/2) (ρ/m_eff)^(2/5) v^(1/5) + …
const C1: f64 = 1.153_44;
/// T/m at the start.
const START: f64 = SPEED * SPEED;

impl Theory {
    /// Of this gas.
    pub fn new(gas: &SoftGas) -> Self {
        let law = gas.law();
        let radius = RADIUS / 2.0;
        let stiffness = 2.0 * law.young * radius.sqrt() / (3.0 * (1.0 - law.poisson.powi(2)));
        let over_mass = 2.0 * stiffness / mass();
        let loss = 1.5 * C1 * law.dissipation * over_mass.powf(0.4);
        let density = gas.grains as f64 / gas.edge().powi(3);
        let chi = (carnahan_starling(gas.packing) - 1.0) / (4.0 * gas.packing);
        let rate = 4.0 * chi * density * (2.0 * RADIUS).powi(2) * PI.sqrt();
        Self { loss, rate }
    }

    /// −d ln T/dt at this T/m: in a collision go m v² (1 − ε²)/4, with v ~ v exp(−m v²/(4 T)).
    fn cooling(&self, u: f64) -> f64 {
        let power = |k: f64| (4.0 * u).powf(1.0 + k) * libm::tgamma(2.0 + k);
        let lost = 2.0 * self.loss * power(0.1) - 2.2 * self.loss.powi(2) * power(0.2);
        self.rate * u.sqrt() * lost / (12.0 * u)
    }

    /// τ of T = T_0 (1 + t/τ)^(−5/3).
    pub fn unit(&self) -> f64 {
        5.0 / (3.0 * self.cooling(START))
    }

    /// 1 − ε of a central collision at √(2 kT/m), at this T/T_0.
    pub fn typical_loss(&self, temperature: f64) -> f64 {
        let first = self.loss * (2.0 * START * temperature).powf(0.1);
        first - 0.6 * first.powi(2)
    }

    /// Haff's T/T_0 = (1 + t/t_H)^(−2) of the same gas with a constant ε.
    pub fn haff(&self, restitution: f64, times: &[f64]) -> Vec<f64> {
        let slowing = (1.0 - restitution.powi(2)) / 6.0 * self.rate * START.sqrt() * self.unit();
        times.iter().map(|t| (1.0 + slowing * t).powi(-2)).collect()
    }

    /// T/T_0 at these times, in units of τ.
    pub fn temperatures(&self, times: &[f64]) -> Vec<f64> {
        let (unit, steps) = (self.unit(), 20);
        let (mut log, mut now) = (0.0, 0.0);
        let change = |log: f64| -self.cooling(START * libm::exp(log)) * unit;
        let each = |t: &f64| {
            let dt = (t - now) / f64::from(steps);
            for _ in 0..steps {
                let middle = log + 0.5 * dt * change(log);
                log += dt * change(middle);
            }
            now = *t;
            libm::exp(log)
        };
        times.iter().map(each).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrated::Integrated;
    use carom::law::{Impact, Response, Rule};

    /// The loss that the theory begins with, against a slow contact integrated.
    #[test]
    fn slow_contacts_lose_what_the_theory_says() {
        let gas = SoftGas { grains: 1_000, packing: 0.01, young: 1e9, dissipation: 8e-5, seed: 1 };
        let impact = Impact {
            contact_distance: 2.0 * RADIUS,
            effective_radius: RADIUS / 2.0,
            reduced_mass: mass() / 2.0,
            normal_speed: 1e-7,
            tangential_speed: 0.0,
            acceleration: 0.0,
            materials: [0, 0],
        };
        let answer = Integrated::new(gas.law()).collide(&impact);
        let Response::Lasting(found) = answer.response else { unreachable!() };
        let loss = Theory::new(&gas).loss * 1e-7_f64.powf(0.2);
        let expected = 1.0 - loss + 0.6 * loss.powi(2);
        assert!((found.restitution - expected).abs() < 1e-3 * loss, "{}", found.restitution);
    }
}
