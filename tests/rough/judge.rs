//! Is the engine's friction that of the force-based reference? Random oblique impacts of spinning pairs, and with planes, in three dimensions.

use crate::pair::{random, seeded, two};
use carom::law::{LinearDashpot, Outside, Rough, Rule, Soft, Tangential, Viscoelastic};
use carom::space::{ContactState, Plane, Surface};
use carom::world::{Rotating, WithContacts};
use carom::{Grain, Memory, World};
use carom_reference::{
    ForceLaw, Friction, RoughGrain, RoughImpact, collide_rough, collide_rough_with_plane,
};
use rand::RngExt;
use rand_pcg::Pcg64Mcg;

type Spheres = [Grain<f64, 3>; 2];

/// An impact drawn at random: the law, the friction, two that touch, their rotation, and whether the second is a plane.
struct Case {
    law: ForceLaw,
    friction: Friction,
    grains: Spheres,
    spins: [[f64; 3]; 2],
    is_plane: bool,
}

/// Which contacts are integrated, with how many steps, how much stiffer, rougher and lossier than usual grains are.
#[derive(Clone, Copy)]
struct Method {
    steps: u32,
    eta_max: f64,
    stiffer: f64,
    rougher: f64,
    lossy: f64,
}

/// All contacts are integrated.
fn integrated(steps: u32) -> Method {
    Method { steps, eta_max: 0.0, stiffer: 1.0, rougher: 1.0, lossy: 1.0 }
}

fn draw(rng: &mut Pcg64Mcg, is_linear: bool, stiffer: f64) -> Case {
    let is_plane = rng.random_range(0..4) == 0;
    let mut grains = two(rng);
    let spins = [random(rng, 2.0), random(rng, 2.0)];
    let [a, b] = &mut grains;
    if is_plane {
        a.position = [0.0, 0.0, a.radius].into();
        a.velocity = [rng.random_range(-1.0..1.0), 0.3, rng.random_range(-1.5..-0.5)].into();
    } else {
        let n = carom::Vector::<f64, 3>::from(random::<3>(rng, 1.0)).normalize();
        (a.position, b.position) = (n * (a.radius + b.radius), [0.0; 3].into());
        a.velocity = b.velocity - n + carom::Vector::<f64, 3>::from(random::<3>(rng, 0.4));
    }
    // Stiff enough for an overlap of a hundredth or less.
    let law = match is_linear {
        true => ForceLaw::LinearDashpot {
            stiffness: 4.0e4 * stiffer,
            damping: rng.random_range(0.0..50.0) * stiffer.sqrt(),
        },
        false => ForceLaw::Viscoelastic {
            young: 1.0e6 * stiffer,
            poisson: 0.3,
            dissipation: rng.random_range(0.0..1e-3) * stiffer.powf(-0.4),
        },
    };
    // As much stiffer as the contact is.
    let stiffer = if is_linear { stiffer } else { stiffer.powf(0.8) };
    let stiffness = rng.random_range(0.2..1.0) * 2.0e4 * stiffer;
    let friction =
        Friction { mu: rng.random_range(0.05..1.0), stiffness, damping: 0.0, inertia: 0.4 };
    Case { law, friction, grains, spins, is_plane }
}

fn reference(case: &Case) -> RoughImpact {
    let of = |k: usize| {
        let grain = &case.grains[k];
        let Grain { radius, mass, .. } = *grain;
        let (position, velocity) = (grain.position.into(), grain.velocity.into());
        RoughGrain { radius, mass, position, velocity, rotation: case.spins[k] }
    };
    match case.is_plane {
        true => {
            let plane = ([0.0; 3], [0.0, 0.0, 1.0]);
            collide_rough_with_plane(of(0), plane, case.law, case.friction).unwrap()
        }
        false => collide_rough([of(0), of(1)], case.law, case.friction).unwrap(),
    }
}

/// The largest difference of velocities, and of spins times radius, at the contact's end: the speed of approach is
/// about 1.
fn difference(case: &Case, rule: impl Rule<f64>, steps: u32) -> f64 {
    let judged = reference(case);
    let contacts = [ContactState::VACANT; 2];
    let mut memory = Rotating::new(
        WithContacts::new(Memory::<f64, 3, 2>::new(), contacts),
        [case.spins, [[0.0; 3]; 2], [[0.0; 3]; 2]],
    );
    let builder = World::builder(&mut memory).rule(rule).steps_per_contact(steps);
    let count = if case.is_plane { 1 } else { 2 };
    let builder = match case.is_plane {
        true => builder.plane(Plane::new([0.0, 0.0, 1.0], 0.0, Surface::Rule)),
        false => builder,
    };
    let mut world = builder.grains(case.grains.into_iter().take(count)).unwrap().start().unwrap();
    world.advance_to(judged.duration * 1.01).unwrap();
    let mut worst = 0.0_f64;
    for (i, after) in judged.after.iter().enumerate().take(count) {
        let velocity = world.grain(i).unwrap().velocity;
        let spin = world.view().angular_velocity(i).unwrap();
        for k in 0..3 {
            worst = worst.max((velocity[k] - after.velocity[k]).abs());
            worst = worst.max((spin[k] - after.rotation[k]).abs() * after.radius);
        }
    }
    worst
}

fn all(seed: u64, count: usize, is_linear: bool, method: Method) -> Vec<f64> {
    let Method { steps, eta_max, stiffer, rougher, lossy } = method;
    let mut rng = seeded(seed);
    let mut differences: Vec<f64> = (0..count)
        .map(|_| {
            let mut case = draw(&mut rng, is_linear, stiffer);
            case.friction.mu *= rougher;
            if let ForceLaw::LinearDashpot { damping, .. } = &mut case.law {
                *damping *= lossy;
            }
            let Friction { mu, stiffness, .. } = case.friction;
            let tangential = Tangential::Spring { mu, stiffness, damping: 0.0 };
            match case.law {
                ForceLaw::LinearDashpot { stiffness, damping } => {
                    let law = LinearDashpot { stiffness, damping };
                    let soft = Soft::linear_dashpot(law, Outside::HardSphere);
                    difference(&case, Rough { eta_max, ..Rough::spheres(soft, tangential) }, steps)
                }
                ForceLaw::Viscoelastic { young, poisson, dissipation } => {
                    let law = Viscoelastic { young, poisson, dissipation };
                    let soft = Soft::viscoelastic(law, Outside::HardSphere);
                    difference(&case, Rough { eta_max, ..Rough::spheres(soft, tangential) }, steps)
                }
                _ => unreachable!(),
            }
        })
        .collect();
    differences.sort_by(f64::total_cmp);
    differences
}

#[test]
fn random_impacts_are_those_of_the_reference() {
    for (is_linear, seed) in [(true, 7), (false, 8)] {
        let [coarse, fine] = [64, 512].map(|steps| all(seed, 100, is_linear, integrated(steps)));
        println!("{:e} {:e} {:e} {:e}", coarse[50], coarse[99], fine[50], fine[99]);
        assert!(coarse[99] < 5e-4 && fine[99] < 1e-5, "{:e} {:e}", coarse[99], fine[99]);
        assert!(coarse[50] / fine[50] > 25.0);
    }
}

/// Surfaces that slide all the time, or nearly, in contacts that lose nothing else: the spring's direction follows theirs.
#[test]
fn contacts_that_slide_are_of_second_order() {
    let one = |steps| {
        let method = Method { rougher: 0.02, lossy: 0.0, ..integrated(steps) };
        all(10, 40, true, method)
    };
    let [coarse, fine] = [512, 4096].map(one);
    println!("{:e} {:e}", coarse[39], fine[39]);
    assert!(coarse[39] < 3e-9 && fine[39] < coarse[39] / 40.0, "{:e} {:e}", coarse[39], fine[39]);
}

#[test]
#[ignore = "minutes: run in release"]
fn ten_thousand_impacts_of_each_law_are_those_of_the_reference() {
    for is_linear in [true, false] {
        let differences = all(9, 10_000, is_linear, integrated(2048));
        let [median, most] = [5000, 9999].map(|k| differences[k]);
        println!("{median:e} {most:e}");
        assert!(median < 3e-7 && most < 3e-6, "{median:e} {most:e}");
    }
}

#[test]
#[ignore = "minutes: run in release"]
fn in_131_072_steps_impacts_are_those_of_the_reference_to_nine_digits() {
    for is_linear in [true, false] {
        let differences = all(10, 200, is_linear, integrated(131_072));
        let [median, most] = [100, 199].map(|k| differences[k]);
        println!("{median:e} {most:e}");
        assert!(median < 3e-10 && most < 2e-9, "{median:e} {most:e}");
    }
}

/// A pair's contact from tables: its error falls as the softness does.
#[test]
fn stiff_pairs_read_from_tables_what_the_reference_integrates() {
    for (is_linear, seed) in [(true, 7), (false, 8)] {
        // η is about 1/100 and less, then 1/100 of that.
        let one = |stiffer| {
            all(seed, 100, is_linear, Method { eta_max: 0.05, stiffer, ..integrated(32) })
        };
        let stiff = if is_linear { 1e4 } else { 1e5 };
        let [soft, stiff] = [1.0, stiff].map(one);
        println!("{:e} {:e} {:e} {:e}", soft[50], soft[99], stiff[50], stiff[99]);
        assert!(soft[50] < 2e-3 && soft[99] < 1e-2);
        assert!(stiff[50] < soft[50] / 50.0 && stiff[99] < soft[99] / 50.0);
    }
}
