//! How fast are grains at first? Reads a species' temperature; writes velocities.

use super::grains::SpeciesSpec;
use super::side::Placed;
use rand::RngExt;
use rand_distr::StandardNormal;
use rand_pcg::Pcg64;

/// Gives grains their velocities: normal ones of variance T/m, scaled so that their momentum is zero
/// and T = ⟨m v²⟩/D exactly, and what all have besides.
pub fn set(spec: &SpeciesSpec, dimension: usize, grains: &mut [Placed], rng: &mut Pcg64) {
    let mean_mass = grains.iter().map(|grain| grain.mass).sum::<f64>() / grains.len().max(1) as f64;
    let of_speed = spec.thermal_speed.map(|speed| 0.5 * mean_mass * speed * speed);
    if let Some(temperature) = spec.temperature.or(of_speed).filter(|t| *t > 0.0) {
        heat(temperature, dimension, grains, rng);
    }
    for grain in grains {
        for (v, drift) in grain.velocity.iter_mut().zip(&spec.moving) {
            *v += drift;
        }
    }
}

fn heat(temperature: f64, dimension: usize, grains: &mut [Placed], rng: &mut Pcg64) {
    for grain in grains.iter_mut() {
        let width = (temperature / grain.mass).sqrt();
        grain.velocity[..dimension].fill_with(|| width * rng.sample::<f64, _>(StandardNormal));
    }
    let count = grains.len();
    if count > 1 {
        let mass: f64 = grains.iter().map(|grain| grain.mass).sum();
        for axis in 0..dimension {
            let momentum: f64 = grains.iter().map(|grain| grain.mass * grain.velocity[axis]).sum();
            grains.iter_mut().for_each(|grain| grain.velocity[axis] -= momentum / mass);
        }
    }
    let twice_energy =
        |grain: &Placed| grain.mass * grain.velocity.iter().map(|v| v * v).sum::<f64>();
    let now = grains.iter().map(twice_energy).sum::<f64>() / (count * dimension) as f64;
    let factor = (temperature / now).sqrt();
    if factor.is_finite() {
        grains.iter_mut().for_each(|grain| grain.velocity = grain.velocity.map(|v| factor * v));
    }
}
