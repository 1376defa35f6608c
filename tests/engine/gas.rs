//! Which gases do the tests use? Reads a seed; writes grains that do not overlap.

use carom::law::{LinearDashpot, Viscoelastic};
use carom::{Grain, Scalar};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// The length of a vector.
pub fn length<const D: usize>(v: &carom::scalar::Vector<f64, D>) -> f64 {
    v.dot(v).sqrt()
}

/// `n` grains of mass 1 with radii in `[small, large]` on a jittered cubic lattice in `[0, length]^D`,
/// with velocities uniform in [−1, 1] and no total momentum.
pub fn gas<S: Scalar, const D: usize>(
    n: usize,
    seed: u64,
    length: f64,
    [small, large]: [f64; 2],
) -> Vec<Grain<S, D>> {
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let side = (1..).find(|s: &usize| s.pow(D as u32) >= n).unwrap();
    let cell = length / side as f64;
    assert!(cell > 2.0 * large, "the lattice is too dense for the radius");
    let mut velocities: Vec<[f64; D]> =
        (0..n).map(|_| std::array::from_fn(|_| rng.random_range(-1.0..1.0))).collect();
    let mean: [f64; D] =
        std::array::from_fn(|a| velocities.iter().map(|v| v[a]).sum::<f64>() / n as f64);
    for v in &mut velocities {
        (0..D).for_each(|a| v[a] -= mean[a]);
    }
    (0..n)
        .map(|i| {
            let at = std::array::from_fn(|a| {
                let site = (i / side.pow(a as u32)) % side;
                let free = cell - 2.0 * large;
                S::from_f64(cell * (site as f64 + 0.5) + free * rng.random_range(-0.49..0.49))
            });
            let radius = S::from_f64(rng.random_range(small..=large));
            Grain::with_mass(radius, S::one()).at(at).moving(velocities[i].map(S::from_f64))
        })
        .collect()
}

/// Elastic, stiff enough for l̃ cos α > 5 at unit speed, soft enough that a contact turns visibly.
pub fn elastic_spring<S: Scalar>() -> LinearDashpot<S> {
    LinearDashpot { stiffness: S::from_f64(2.0e4), damping: S::zero() }
}

/// The same with dissipation: c_dis ≈ 0.2.
pub fn damped_spring<S: Scalar>() -> LinearDashpot<S> {
    LinearDashpot { stiffness: S::from_f64(2.0e4), damping: S::from_f64(20.0) }
}

/// Viscoelastic grains of about the same stiffness.
pub fn rubber<S: Scalar>() -> Viscoelastic<S> {
    Viscoelastic {
        young: S::from_f64(1.0e6),
        poisson: S::from_f64(0.4),
        dissipation: S::from_f64(1.0e-3),
    }
}
