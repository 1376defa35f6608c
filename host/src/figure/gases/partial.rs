//! Which temperatures should the parts of a cooling mixture have? Reads ε; writes T_1/T_2 after Garzó and Dufty.
//!
//! Enskog's equation with a Maxwellian for each part: T_1/T_2 is where both cool at the same rate
//! (Phys. Rev. E 60, 5706, 1999). The contact values are Boublík's (J. Chem. Phys. 53, 471, 1970).

use std::f64::consts::PI;

/// A mixture of two parts, equally many of each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parts {
    /// m.
    pub masses: [f64; 2],
    /// σ.
    pub diameters: [f64; 2],
    /// Packing fraction.
    pub packing: f64,
}

impl Parts {
    /// χ_ij.
    pub(super) fn contact_value(&self, [i, j]: [usize; 2]) -> f64 {
        let sum = |power: i32| self.diameters.iter().map(|d| d.powi(power)).sum::<f64>();
        let [a, b] = [self.diameters[i], self.diameters[j]];
        let free = 1.0 / (1.0 - self.packing);
        let y = a * b / (a + b) * self.packing * sum(2) / sum(3) * free;
        free * (1.0 + 3.0 * y + 2.0 * y * y)
    }

    /// −d ln T_i/dt of both, up to a common factor.
    fn rates(&self, temperatures: [f64; 2], restitution: f64) -> [f64; 2] {
        let theta = [0, 1].map(|i| self.masses[i] / temperatures[i]);
        let rate = |i: usize, j: usize| {
            let diameter = (self.diameters[i] + self.diameters[j]) / 2.0;
            let part = self.masses[j] / (self.masses[i] + self.masses[j]) * (1.0 + restitution);
            let sum = theta[i] + theta[j];
            let speed = (sum / (theta[i] * theta[j])).sqrt();
            let often = self.contact_value([i, j]) * PI * diameter.powi(2) * speed;
            often * part * (1.0 - part / 2.0 * sum / theta[j])
        };
        [0, 1].map(|i| rate(i, 0) + rate(i, 1))
    }

    /// T_1/T_2 while it cools.
    pub fn ratio(&self, restitution: f64) -> f64 {
        let faster = |ratio: f64| {
            let [first, second] = self.rates([ratio, 1.0], restitution);
            first > second
        };
        let mut ends = [0.01, 100.0];
        for _ in 0..100 {
            let middle = (ends[0] + ends[1]) / 2.0;
            ends[usize::from(faster(middle))] = middle;
        }
        ends[0]
    }
}

#[cfg(test)]
mod tests {
    /// The values that were found elsewhere: masses 8 to 1, diameters 2 to 1, dilute.
    #[test]
    fn values_of_another_hand() {
        let parts = super::Parts { masses: [8.0, 1.0], diameters: [2.0, 1.0], packing: 0.005 };
        for (e, expected) in [(1.0, 1.0), (0.95, 1.086), (0.9, 1.179), (0.8, 1.382)] {
            let found = parts.ratio(e);
            assert!((found / expected - 1.0).abs() < 1e-3, "{e}: {found} against {expected}");
        }
    }
}
