//! Which velocities does a heat bath give? Reads a generator; writes numbers drawn from Maxwell's distribution and from its flux.

use rand::RngExt;
use rand_distr::{Distribution, StandardNormal};
use rand_pcg::Pcg64;

/// A velocity from Maxwell's distribution, √(k T/m) in each component.
pub(super) fn maxwell<const D: usize>(rng: &mut Pcg64, speed: f64) -> [f64; D] {
    std::array::from_fn(|_| {
        let x: f64 = StandardNormal.sample(rng);
        speed * x
    })
}

/// A velocity of what leaves a wall with this unit normal: along the normal from the flux, whose density grows as
/// v exp(−m v²/2kT), across it from Maxwell's distribution. `speed` is √(k T/m).
pub(super) fn leaving<const D: usize>(rng: &mut Pcg64, normal: [f64; D], speed: f64) -> [f64; D] {
    let velocity: [f64; D] = maxwell(rng, speed);
    let along: f64 = velocity.iter().zip(&normal).map(|(v, n)| v * n).sum();
    // 1 − u lies in (0, 1]: its logarithm is a number, and the speed is not negative.
    let out = speed * (-2.0 * (1.0 - rng.random_range(0.0..1.0_f64)).ln()).sqrt();
    std::array::from_fn(|axis| velocity[axis] + (out - along) * normal[axis])
}

/// A waiting time of events that come at this rate; infinite if they never do.
pub(super) fn waiting(rng: &mut Pcg64, rate: f64) -> f64 {
    -(1.0 - rng.random_range(0.0..1.0_f64)).ln() / rate
}
