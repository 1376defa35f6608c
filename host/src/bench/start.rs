//! How does a timed gas start? Reads a case; writes grains on lattices, the same ones every time.

use super::case::{Case, Large};
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
pub(super) fn grains<const D: usize>(case: &Case) -> Vec<Grain<f64, D>> {
    let mut rng = Pcg64::seed_from_u64(case.count as u64);
    let large = large::<D>(case);
    let mut sites = free_sites::<D>(case, &large);
    while sites.len() > case.count {
        sites.remove(rng.random_range(0..sites.len()));
    }
    let normal = Normal::new(0.0, case.speed()).unwrap_or_else(|_| unreachable!("speed() > 0"));
    let grain = Grain::with_mass(case.radius(), case.mass());
    let grains: Vec<Grain<f64, D>> =
        sites.into_iter().map(|at| grain.at(at)).chain(large).collect();
    let mut velocities: Vec<[f64; D]> = grains
        .iter()
        .map(|grain| {
            let share = (case.mass() / grain.mass).sqrt();
            std::array::from_fn(|_| share * normal.sample(&mut rng))
        })
        .collect();
    rest::<D>(&grains, &mut velocities);
    grains.into_iter().zip(velocities).map(|(grain, v)| grain.moving(v)).collect()
}

/// Takes off what all move together.
fn rest<const D: usize>(grains: &[Grain<f64, D>], velocities: &mut [[f64; D]]) {
    let mass: f64 = grains.iter().map(|grain| grain.mass).sum();
    for axis in 0..D {
        let momentum = grains.iter().zip(&*velocities).map(|(grain, v)| grain.mass * v[axis]);
        let mean = momentum.sum::<f64>() / mass;
        velocities.iter_mut().for_each(|v| v[axis] -= mean);
    }
}

/// The large grains of a case, on a lattice of their own.
fn large<const D: usize>(case: &Case) -> Vec<Grain<f64, D>> {
    let Some(Large { ratio, count }) = case.large else { return Vec::new() };
    let size = ratio as f64;
    let grain = Grain::with_mass(size * case.radius(), size.powi(D as i32) * case.mass());
    sites::<D>(count, case.edge()).into_iter().take(count).map(|at| grain.at(at)).collect()
}

/// The sites of the others: enough of them that are clear of the large grains.
fn free_sites<const D: usize>(case: &Case, large: &[Grain<f64, D>]) -> Vec<[f64; D]> {
    let edge = case.edge();
    let is_free = |at: &[f64; D]| {
        large.iter().all(|grain| {
            let square: f64 = (0..D)
                .map(|axis| (at[axis] - grain.position[axis]).abs())
                .map(|apart| apart.min(edge - apart).powi(2))
                .sum();
            square.sqrt() > grain.radius + case.radius()
        })
    };
    let mut count = case.count;
    loop {
        let sites: Vec<_> = sites::<D>(count, edge).into_iter().filter(is_free).collect();
        if sites.len() >= case.count {
            return sites;
        }
        count += count / 8 + 1;
    }
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
