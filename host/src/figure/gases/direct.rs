//! What does Enskog's equation say of a mixture, without Maxwellians? Solves it by direct simulation; writes T_1/T_2.
//!
//! Bird's method without space: pairs are drawn at random and collide as often as the equation says. It
//! shares the rates' premise, molecular chaos, with Garzó and Dufty's theory, but nothing with the engine.

use super::partial::Parts;
use crate::figure::fit;
use rand::{RngExt, SeedableRng};
use rand_distr::{Distribution, StandardNormal};
use rand_pcg::Pcg64;
use std::f64::consts::PI;

/// A mixture that cools, the same everywhere.
#[derive(Clone, Copy, Debug)]
pub struct Direct {
    /// What it is made of.
    pub parts: Parts,
    /// ε.
    pub restitution: f64,
    /// Grains of each part.
    pub each: usize,
    /// Of everything drawn.
    pub seed: u64,
}

/// Velocities of both parts.
type Velocities = [Vec<[f64; 3]>; 2];

/// Of a relative velocity along one direction, in standard deviations: less than 4 in a million are above.
const LARGEST: f64 = 4.5;
/// Steps between two looks, and their length: some percent of the grains collide in one.
const STEPS: usize = 8;
const STEP: f64 = 0.01;

impl Direct {
    /// T_1/T_2: the mean of its logarithm over so many collisions a grain, after others.
    pub fn ratio(&self, [before, during]: [u64; 2]) -> f64 {
        let mut rng = Pcg64::seed_from_u64(self.seed);
        let normal = |rng: &mut Pcg64| -> f64 { StandardNormal.sample(rng) };
        let mut all: Velocities = self.parts.masses.map(|mass: f64| {
            let mut one = || std::array::from_fn(|_| normal(&mut rng) / mass.sqrt());
            (0..self.each).map(|_| one()).collect()
        });
        let (mut collisions, mut logs) = (0, Vec::new());
        while collisions < (before + during) * self.each as u64 {
            let temperatures = self.normalise(&mut all);
            if collisions > before * self.each as u64 {
                logs.push(libm::log(temperatures[0] / temperatures[1]));
            }
            for _ in 0..STEPS {
                let pairs = [[0, 0], [0, 1], [1, 1]];
                let step = |pair| self.collide(&mut all, pair, temperatures, &mut rng);
                collisions += pairs.map(step).iter().sum::<u64>();
            }
        }
        libm::exp(fit::mean(&logs)[0])
    }

    /// Takes out the total momentum and makes the mean temperature 1; returns both temperatures.
    fn normalise(&self, all: &mut Velocities) -> [f64; 2] {
        let masses = self.parts.masses;
        let total = self.each as f64 * (masses[0] + masses[1]);
        for axis in 0..3 {
            let sum = |k: usize| masses[k] * all[k].iter().map(|v| v[axis]).sum::<f64>();
            let mean = (sum(0) + sum(1)) / total;
            all.iter_mut().flatten().for_each(|v| v[axis] -= mean);
        }
        let temperatures = [0, 1].map(|k| {
            let square: f64 = all[k].iter().flatten().map(|v| v * v).sum();
            masses[k] * square / (3.0 * self.each as f64)
        });
        let mean = (temperatures[0] + temperatures[1]) / 2.0;
        all.iter_mut().flatten().flatten().for_each(|v| *v /= mean.sqrt());
        temperatures.map(|temperature| temperature / mean)
    }

    /// One step of the collisions between these two parts; returns how many there were.
    fn collide(
        &self,
        all: &mut Velocities,
        [i, j]: [usize; 2],
        t: [f64; 2],
        rng: &mut Pcg64,
    ) -> u64 {
        let Parts { masses, diameters, .. } = self.parts;
        let largest = LARGEST * (t[i] / masses[i] + t[j] / masses[j]).sqrt();
        let area = ((diameters[i] + diameters[j]) / 2.0).powi(2);
        let often = self.parts.contact_value([i, j]) * area * largest * STEP;
        let candidates = self.each as f64 * often * if i == j { 0.5 } else { 1.0 };
        let mut collisions = 0;
        for _ in 0..(candidates + rng.random::<f64>()) as u64 {
            let [k, l] = [0; 2].map(|_| rng.random_range(0..self.each));
            let normal = direction(rng);
            let along = |v: [f64; 3]| (0..3).map(|a| v[a] * normal[a]).sum::<f64>();
            let approach = along(all[i][k]) - along(all[j][l]);
            if approach <= rng.random::<f64>() * largest || (i == j && k == l) {
                continue;
            }
            collisions += 1;
            let change = (1.0 + self.restitution) * approach / (masses[i] + masses[j]);
            for a in 0..3 {
                all[i][k][a] -= change * masses[j] * normal[a];
                all[j][l][a] += change * masses[i] * normal[a];
            }
        }
        collisions
    }
}

/// A direction, all alike.
fn direction(rng: &mut Pcg64) -> [f64; 3] {
    let z = rng.random_range(-1.0..1.0);
    let (angle, across) = (2.0 * PI * rng.random::<f64>(), libm::sqrt(1.0 - z * z));
    [across * libm::cos(angle), across * libm::sin(angle), z]
}
