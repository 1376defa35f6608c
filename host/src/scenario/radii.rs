//! How large is each grain of a kind? Reads a distribution; writes nothing, returns radii.

use super::grains::RadiusSpec;
use rand::{Rng, RngExt};
use rand_distr::StandardNormal;

/// So many radii.
pub fn draw(radius: &RadiusSpec, count: usize, rng: &mut impl Rng) -> Vec<f64> {
    (0..count).map(|number| one(radius, number, rng)).collect()
}

/// Radius number `number`.
pub fn one(radius: &RadiusSpec, number: usize, rng: &mut impl Rng) -> f64 {
    match *radius {
        RadiusSpec::One(radius) => between([radius; 2], rng),
        RadiusSpec::Range(range) | RadiusSpec::Uniform { uniform: range } => between(range, rng),
        RadiusSpec::Gaussian { mean, deviation } => loop {
            let off: f64 = rng.sample(StandardNormal);
            if off.abs() <= 3.0 {
                return mean + deviation * off;
            }
        },
        RadiusSpec::List { ref list } => list[number % list.len()],
    }
}

fn between([small, large]: [f64; 2], rng: &mut impl Rng) -> f64 {
    small + (large - small) * rng.random::<f64>()
}
