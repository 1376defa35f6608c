//! Do rough grains work in every number type, and is left and right the same to them? Balls in four types; mirrored and permuted worlds.

use crate::pair::{random, rough, seeded, spheres};
use carom::law::{HardSphere, Integrated, Rough, Tangential, WaltonBraun};
use carom::scalar::{I16F16, I32F32};
use carom::space::{ContactState, Plane, Surface};
use carom::world::{Rotating, WithContacts};
use carom::{Grain, Memory, Scalar, World};

/// Speed and ω R of a ball that was set down sliding with speed 1, after a second. Lengths about 1, gravity 2.
fn rolls<S: Scalar>() -> [f64; 2] {
    let of = S::from_f64;
    let rule = Rough::spheres(
        HardSphere { restitution: of(0.5) },
        Tangential::Walton { mu: of(0.5), beta_0: of(0.25) },
    );
    let memory = WithContacts::new(Memory::<S, 2, 1>::new(), [ContactState::VACANT; 2]);
    let mut memory = Rotating::new(memory, [[S::zero()]; 3]);
    let mut world = World::builder(&mut memory)
        .plane(Plane::new([S::zero(), S::one()], S::zero(), Surface::Rule))
        .gravity([S::zero(), of(-2.0)])
        .rule(rule)
        .grain(
            Grain::with_mass(S::one(), S::one())
                .at([S::zero(), S::one()])
                .moving([S::one(), S::zero()]),
        )
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(1.0).unwrap();
    let spin = world.view().angular_velocity(0).unwrap()[2];
    [world.grain(0).unwrap().velocity[0].to_f64(), spin.to_f64()]
}

#[test]
fn a_ball_rolls_in_every_number_type() {
    let balls = [
        ("f64", rolls::<f64>(), 1e-3),
        ("f32", rolls::<f32>(), 1e-3),
        ("I32F32", rolls::<I32F32>(), 1e-3),
        ("I16F16", rolls::<I16F16>(), 0.03),
    ];
    for (number, [speed, spin], near) in balls {
        assert!((speed - 5.0 / 7.0).abs() < near, "{number}: {speed}");
        assert!((spin + 5.0 / 7.0).abs() < near, "{number}: {spin}");
    }
}

/// Velocity and rotation about x and y of a sphere on a soft floor that was set down sliding and spinning, so that it
/// slides in ever other directions before it rolls; and whether so many steps a contact, and one more, are taken.
fn slides<S: Scalar>(steps: u32) -> ([[f64; 2]; 2], [bool; 2]) {
    let of = S::from_f64;
    let law = WaltonBraun { loading: of(400.0), unloading: of(600.0) };
    let friction = Tangential::Spring { mu: of(0.25), stiffness: of(100.0), damping: of(0.0) };
    let memory = WithContacts::new(Memory::<S, 3, 1>::new(), [ContactState::VACANT; 2]);
    let spin = [of(2.0), of(0.5), S::zero()];
    let mut memory = Rotating::new(memory, [[spin], [[S::zero(); 3]], [[S::zero(); 3]]]);
    let sphere = Grain::with_mass(S::one(), S::one()).at([S::zero(), S::zero(), S::one()]);
    let mut builder = World::builder(&mut memory)
        .plane(Plane::new([S::zero(), S::zero(), S::one()], S::zero(), Surface::Rule))
        .gravity([S::zero(), S::zero(), of(-2.0)])
        .rule(Rough::spheres(Integrated(law), friction))
        .grain(sphere.moving([S::one(), S::zero(), S::zero()]))
        .unwrap();
    let most = [steps, steps + 1].map(|steps| builder.set_steps_per_contact(steps).is_ok());
    let mut world = builder.steps_per_contact(32).start().unwrap();
    world.advance_to(2.0).unwrap();
    let velocity = world.grain(0).unwrap().velocity;
    let spin = world.view().angular_velocity(0).unwrap();
    ([[velocity[0], velocity[1]], [spin[0], spin[1]]].map(|both| both.map(S::to_f64)), most)
}

#[test]
fn a_sphere_slides_and_rolls_in_every_number_type() {
    let [float, fixed] = [131_072, 16_384];
    let spheres = [
        ("f64", slides::<f64>(float), 0.01),
        ("f32", slides::<f32>(float), 0.01),
        ("I32F32", slides::<I32F32>(fixed), 0.01),
        ("I16F16", slides::<I16F16>(fixed), 0.05),
    ];
    for (number, ([[x, y], [about_x, about_y]], most), near) in spheres {
        // The angular momentum about the contact is kept.
        assert!((x + 0.4 * about_y - (1.0 + 0.4 * 0.5)).abs() < near, "{number}: {x} {about_y}");
        assert!((y - 0.4 * about_x + 0.4 * 2.0).abs() < near, "{number}: {y} {about_x}");
        // It rolls, though the spring swings.
        assert!((x - about_y).abs() < 0.15 && (y + about_x).abs() < 0.15, "{number}: {x} {y}");
        assert_eq!(most, [true, false], "{number}");
    }
}

/// A heap of balls, its first axis turned over or not, its grains in this order; where they are and how they rotate.
fn heap(mirror: f64, order: impl Fn(usize) -> usize) -> Vec<[f64; 3]> {
    let n = 6;
    let memory = WithContacts::new(Memory::<f64, 2, 6>::new(), [ContactState::VACANT; 32]);
    let mut memory = Rotating::new(memory, [[0.0; 6]; 3]);
    let place = |k: usize| {
        [mirror * (0.013 * (k % 3) as f64 + 0.001 * k as f64), 0.011 + 0.021 * (k / 3) as f64]
    };
    let grain = |k: usize| Grain::with_mass(0.005, 1.0).at(place(k)).moving([mirror * 0.1, 0.0]);
    let mut world = World::builder(&mut memory)
        .plane(Plane::new([0.0, 1.0], 0.0, Surface::Rule))
        .gravity([0.0, -9.81])
        .rule(Rough::disks(
            HardSphere { restitution: 0.5 },
            Tangential::Walton { mu: 0.4, beta_0: 0.2 },
        ))
        .grains((0..n).map(|k| grain(order(k))))
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(0.15).unwrap();
    let mut all = vec![[0.0; 3]; n];
    for k in 0..n {
        let position = world.grain(k).unwrap().position;
        let spin = world.view().angular_velocity(k).unwrap()[2];
        all[order(k)] = [position.x, position.y, spin];
    }
    all
}

#[test]
fn a_mirror_turns_rotation_over_and_numbers_do_not_matter() {
    let there = heap(1.0, |k| k);
    let mirrored = heap(-1.0, |k| k);
    let renumbered = heap(1.0, |k| 5 - k);
    for ((a, b), c) in there.iter().zip(&mirrored).zip(&renumbered) {
        assert_eq!([a[0], a[1], a[2]], [-b[0], b[1], -b[2]]);
        // Forces are summed in another order: rounding, and what becomes of it.
        assert!((0..3).all(|k| (a[k] - c[k]).abs() < 1e-6 * (1.0 + a[k].abs())), "{a:?} {c:?}");
    }
    assert!(there.iter().any(|grain| grain[2].abs() > 1.0));
}

#[test]
fn a_frame_that_moves_changes_nothing() {
    let run = |drift: f64| {
        let mut rng = seeded(11);
        let mut memory = spheres((0..27).map(|_| random(&mut rng, 1.0)).collect());
        let grains: Vec<_> = (0..27)
            .map(|k: i32| {
                let at = [k % 3, k / 3 % 3, k / 9].map(|x| 1.5 * f64::from(x) + 0.75);
                let [x, y, z] = random(&mut rng, 1.0);
                Grain::with_mass(0.5, 1.0).at(at).moving([x + drift, y, z])
            })
            .collect();
        let law = Tangential::Walton { mu: 0.3, beta_0: 0.4 };
        let mut world = World::builder(&mut memory)
            .periodic([[0.0, 4.5]; 3])
            .rule(rough(0.9, law))
            .grains(grains)
            .unwrap()
            .start()
            .unwrap();
        world.advance_to(1.0).unwrap();
        assert!(world.statistics().collisions > 10);
        (0..27).map(|k| world.view().angular_velocity(k).unwrap()).collect::<Vec<_>>()
    };
    for (a, b) in run(0.0).iter().zip(run(2.0)) {
        assert!((0..3).all(|k| (a[k] - b[k]).abs() < 1e-9), "{a:?} {b:?}");
    }
}
