//! Does a freely cooling gas obey Haff's law? Runs hard inelastic spheres; checks the temperature against theory.

use carom::HeapMemory;
use carom::law::HardSphere;
use carom::{Grain, World};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

const GRAINS: usize = 1000;
const RESTITUTION: f64 = 0.95;
/// Packing fraction.
const PACKING: f64 = 0.05;

/// Equal spheres of diameter 1 and mass 1 on a lattice with random velocities, no total momentum.
fn lattice(length: f64) -> Vec<Grain<f64, 3>> {
    let mut rng = Pcg64Mcg::seed_from_u64(2);
    let cell = length / 10.0;
    let mut v: Vec<[f64; 3]> =
        (0..GRAINS).map(|_| std::array::from_fn(|_| rng.random_range(-1.0..1.0))).collect();
    for a in 0..3 {
        let mean = v.iter().map(|v| v[a]).sum::<f64>() / GRAINS as f64;
        v.iter_mut().for_each(|v| v[a] -= mean);
    }
    let site = |i: usize, a: u32| cell * (((i / 10_usize.pow(a)) % 10) as f64 + 0.5);
    (0..GRAINS)
        .map(|i| {
            Grain::with_mass(0.5, 1.0).at(std::array::from_fn(|a| site(i, a as u32))).moving(v[i])
        })
        .collect()
}

/// T(t) = T0/(1 + t/t0)², 1/t0 = (1 − ε²)/6 ω0 (1 + 3 a2/16), with Enskog's collision rate per grain
/// ω0 = 4 n σ² χ sqrt(π T0/m), Carnahan–Starling's χ and Sonine's a2 (van Noije & Ernst, Granular
/// Matter 1, 57, 1998). Homogeneous: N = 1,000 at this density is far too small a box for clusters.
#[test]
fn a_cooling_gas_follows_haffs_law_within_two_per_cent() {
    let length = (std::f64::consts::PI / 6.0 * GRAINS as f64 / PACKING).cbrt();
    let mut storage = HeapMemory::with_capacity(GRAINS);
    let rule = |restitution| HardSphere { restitution };
    // Elastic collisions first, until the velocities are Maxwellian.
    let mut world = World::builder(&mut storage)
        .periodic([[0.0, length]; 3])
        .rule(rule(1.0))
        .grains(lattice(length))
        .unwrap()
        .start()
        .unwrap();
    while world.statistics().collisions < 5 * GRAINS as u64 {
        world.step().unwrap();
    }
    let start: Vec<_> = (0..GRAINS).map(|i| world.grain(i).unwrap()).collect();
    let mut storage = HeapMemory::with_capacity(GRAINS);
    let mut world = World::builder(&mut storage)
        .periodic([[0.0, length]; 3])
        .rule(rule(RESTITUTION))
        .grains(start)
        .unwrap()
        .start()
        .unwrap();
    let temperature = |energy: f64| energy * 2.0 / 3.0 / (GRAINS - 1) as f64;
    let t_start = temperature(world.view().kinetic_energy());
    let chi = (1.0 - PACKING / 2.0) / (1.0 - PACKING).powi(3);
    let density = 6.0 * PACKING / std::f64::consts::PI;
    let omega = 4.0 * density * chi * (std::f64::consts::PI * t_start).sqrt();
    let e2 = RESTITUTION * RESTITUTION;
    let a2 = 16.0 * (1.0 - RESTITUTION) * (1.0 - 2.0 * e2)
        / (81.0 - 17.0 * RESTITUTION + 30.0 * e2 * (1.0 - RESTITUTION));
    let rate = (1.0 - e2) / 6.0 * omega * (1.0 + 3.0 * a2 / 16.0);
    for step in 1..=4 {
        let t = f64::from(step) * 0.25 / rate;
        world.advance_to(t).unwrap();
        let theory = t_start / (1.0 + rate * t).powi(2);
        let ratio = temperature(world.view().kinetic_energy()) / theory;
        println!("t = {t:.2}: T/T0 = {:.4}, measured/theory = {ratio:.4}", theory / t_start);
        assert!((ratio - 1.0).abs() < 0.02, "t = {t}: {ratio}");
    }
}
