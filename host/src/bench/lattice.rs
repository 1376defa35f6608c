//! Where do a case's grains start? Reads the case; writes nothing, returns grains on a lattice with random velocities.

use super::Case;
use carom::Grain;
use rand::{RngExt, SeedableRng};
use rand_distr::{Distribution, Normal};
use rand_pcg::Pcg64;

/// Sites of one cubic unit cell: one in one dimension, two of a centred square, four of a face-centred cube.
const BASIS: [&[[f64; 3]]; 3] = [
    &[[0.0, 0.0, 0.0]],
    &[[0.0, 0.0, 0.0], [0.5, 0.5, 0.0]],
    &[[0.0, 0.0, 0.0], [0.5, 0.5, 0.0], [0.5, 0.0, 0.5], [0.0, 0.5, 0.5]],
];

/// The grains of a case: on sites drawn at random from the smallest lattice that has enough, numbered
/// along it, with normal velocities and no total momentum. The same ones every time.
pub fn grains<const D: usize>(case: &Case) -> Vec<Grain<f64, D>> {
    let mut rng = Pcg64::seed_from_u64(case.count as u64);
    let mut sites = sites::<D>(case.count, case.edge());
    while sites.len() > case.count {
        sites.remove(rng.random_range(0..sites.len()));
    }
    let normal = Normal::new(0.0, case.speed()).unwrap_or_else(|_| unreachable!("speed() > 0"));
    let mut velocities: Vec<[f64; D]> =
        sites.iter().map(|_| std::array::from_fn(|_| normal.sample(&mut rng))).collect();
    for axis in 0..D {
        let mean = velocities.iter().map(|v| v[axis]).sum::<f64>() / case.count as f64;
        velocities.iter_mut().for_each(|v| v[axis] -= mean);
    }
    let grain = Grain::with_mass(case.radius(), case.mass());
    sites.into_iter().zip(velocities).map(|(at, v)| grain.at(at).moving(v)).collect()
}

fn sites<const D: usize>(count: usize, edge: f64) -> Vec<[f64; D]> {
    let basis = BASIS[D - 1];
    let side = (1..).find(|side: &usize| basis.len() * side.pow(D as u32) >= count).unwrap_or(1);
    let cell = edge / side as f64;
    (0..side.pow(D as u32))
        .flat_map(|number| {
            let corner: [f64; D] =
                std::array::from_fn(|axis| ((number / side.pow(axis as u32)) % side) as f64);
            let site = move |point: &[f64; 3]| {
                std::array::from_fn(|axis| cell * (corner[axis] + point[axis]))
            };
            basis.iter().map(site)
        })
        .collect()
}
