//! Which rough grains do the tests use? Reads a seed; writes a world's description of a few, and what it conserves.

use carom::law::{HardSphere, Rough, Tangential};
use carom::world::Rotating;
use carom::{Grain, HeapMemory};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

pub type Glass = Rough<HardSphere<f64>, f64>;
pub type Spheres = Rotating<HeapMemory<f64, 3>, Vec<[f64; 3]>>;

/// Rough spheres with these coefficients.
pub fn rough(restitution: f64, tangential: Tangential<f64>) -> Glass {
    Rough::spheres(HardSphere { restitution }, tangential)
}

/// All laws without a duration, drawn at random.
pub fn any_law(rng: &mut Pcg64Mcg) -> Tangential<f64> {
    match rng.random_range(0..2) {
        0 => Tangential::Constant { beta: rng.random_range(-1.0..=1.0) },
        _ => Tangential::Walton {
            mu: rng.random_range(0.0..1.0),
            beta_0: rng.random_range(-0.5..=1.0),
        },
    }
}

pub fn random<const N: usize>(rng: &mut Pcg64Mcg, size: f64) -> [f64; N] {
    std::array::from_fn(|_| rng.random_range(-size..size))
}

/// Memory for spheres that rotate so.
pub fn spheres(spins: Vec<[f64; 3]>) -> Spheres {
    let n = spins.len();
    let (one, other) = (vec![[0.0; 3]; n], vec![[0.0; 3]; n]);
    Rotating::new(HeapMemory::with_capacity(n), [spins, one, other])
}

/// Two spheres that will hit each other obliquely, of different size and mass.
pub fn two(rng: &mut Pcg64Mcg) -> [Grain<f64, 3>; 2] {
    let [r, s] = [rng.random_range(0.2..1.0), rng.random_range(0.2..1.0)];
    let [m, n] = [rng.random_range(0.2..2.0), rng.random_range(0.2..2.0)];
    let across = (r + s) * 0.65;
    let [y, z] = [rng.random_range(-across..across), rng.random_range(-across..across)];
    [
        Grain::with_mass(r, m).at([0.0; 3]).moving([1.0, 0.0, 0.0]),
        Grain::with_mass(s, n).at([3.0, y, z]).moving(random(rng, 0.2)),
    ]
}

pub fn seeded(seed: u64) -> Pcg64Mcg {
    Pcg64Mcg::seed_from_u64(seed)
}
