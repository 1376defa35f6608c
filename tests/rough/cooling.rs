//! How do rough spheres share their energy as they cool? A gas against the ratio of temperatures of kinetic theory.
//!
//! Huthmann & Zippelius, Phys. Rev. E 56, R6275 (1997); Santos, Kremer & Garzó, Prog. Theor. Phys. Suppl. 184, 31
//! (2010): T_rot/T_tr → θ = √(1 + C²) + C.

use crate::bird;
use crate::pair::{random, rough, seeded, spheres};
use carom::law::Tangential;
use carom::{Grain, World};

const Q: f64 = 0.4;

/// θ of spheres with these coefficients.
fn theory(e: f64, beta: f64) -> f64 {
    let c = (1.0 + Q) / (2.0 * Q * (1.0 + beta))
        * ((1.0 + Q) * (1.0 - e * e) / (1.0 + beta) - (1.0 - Q) * (1.0 - beta));
    (1.0 + c * c).sqrt() + c
}

/// T_rot/T_tr of a cooling gas, averaged from so many collisions a sphere on, over as many.
fn measured(side: i32, e: f64, beta: f64, collisions: u64) -> f64 {
    let mut rng = seeded(5);
    let n = side.pow(3);
    // Dilute: packing 0.01.
    let cell = (std::f64::consts::PI / 6.0 / 0.01_f64).cbrt();
    // As much energy in rotation as theory says: q R² = 1/10.
    let spin = (10.0 * theory(e, beta)).sqrt();
    let mut memory = spheres((0..n).map(|_| random(&mut rng, spin)).collect());
    let mut velocities: Vec<[f64; 3]> = (0..n).map(|_| random(&mut rng, 1.0)).collect();
    let mean: [f64; 3] =
        std::array::from_fn(|a| velocities.iter().map(|v| v[a]).sum::<f64>() / f64::from(n));
    velocities.iter_mut().for_each(|v| (0..3).for_each(|a| v[a] -= mean[a]));
    let grains = (0..n).map(|k| {
        let at = [k % side, k / side % side, k / side / side];
        let at = at.map(|x| cell * (f64::from(x) + 0.5));
        Grain::with_mass(0.5, 1.0).at(at).moving(velocities[k as usize])
    });
    let mut world = World::builder(&mut memory)
        .periodic([[0.0, cell * f64::from(side)]; 3])
        .rule(rough(e, Tangential::Constant { beta }))
        .grains(grains)
        .unwrap()
        .start()
        .unwrap();
    let per_grain = n as u64 / 2;
    let mut sum = [0.0; 2];
    let mut next = collisions * per_grain;
    while world.statistics().collisions < 2 * collisions * per_grain {
        world.step().unwrap();
        if world.statistics().collisions >= next {
            next += per_grain / 4;
            let view = world.view();
            let [rotation, flight] = [view.rotational_energy(Q), view.kinetic_energy()];
            sum[0] += rotation / flight;
            sum[1] += 1.0;
        }
    }
    sum[0] / sum[1]
}

#[test]
#[ignore = "a minute in release"]
fn temperatures_of_rotation_and_flight_have_the_ratio_of_kinetic_theory() {
    // θ of the four is published; the Maxwellian distribution it rests on is not that of such a gas, so the Boltzmann
    // equation itself, by Bird's method, says how far off it is: 5 % where rotation is slow to follow.
    for (beta, published) in [(-0.5, 0.343), (0.0, 0.574), (0.5, 0.867), (0.9, 1.076)] {
        assert!((theory(0.9, beta) - published).abs() < 1e-3, "{beta}");
        let (is, boltzmann) = (measured(16, 0.9, beta, 40), bird::ratio(40_000, [0.9, beta], 40));
        println!("{beta}: {is:.4}, Boltzmann {boltzmann:.4}, theory {published}");
        assert!((is / boltzmann - 1.0).abs() < 0.02, "{beta}: {is} {boltzmann}");
        let near = if beta > 0.0 { 0.03 } else { 0.07 };
        assert!((is / published - 1.0).abs() < near, "{beta}: {is} {published}");
    }
}

#[test]
#[ignore = "seconds in release"]
fn a_gas_that_loses_nothing_shares_its_energy_equally_within_half_a_percent() {
    // The ratio of one instant varies by 2 %, and there are about 150 that have nothing to do with each other.
    let is = measured(16, 1.0, 1.0, 400);
    println!("{is:.4}");
    assert!((is - 1.0).abs() < 0.005, "{is}");
}

#[test]
fn a_gas_that_loses_nothing_shares_its_energy_equally() {
    let is = measured(10, 1.0, 1.0, 30);
    assert!((is - 1.0).abs() < 0.02, "{is}");
}
