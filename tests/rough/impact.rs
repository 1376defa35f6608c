//! Does a rough impact do what its law says? Conservation and closed forms of single collisions, with grains and planes.

use crate::pair::{any_law, random, rough, seeded, spheres, two};
use carom::law::{ByMaterial, HardSphere, Rough, Rule, Tangential};
use carom::space::{Plane, Surface};
use carom::world::Rotating;
use carom::{Error, Grain, Memory, World};

type Vector = carom::Vector<f64, 3>;

/// How the surfaces move against each other where two spheres touch, and the normal from the second to the first.
fn at_contact<R: Rule<f64>>(world: &World<'_, f64, 3, R>) -> (Vector, Vector, f64) {
    let view = world.view();
    let [a, b] = [0, 1].map(|i| view.grain(i).unwrap());
    let [u, w] = [0, 1].map(|i| Vector::from(view.angular_velocity(i).unwrap()));
    let n = (a.position - b.position).normalize();
    let relative = a.velocity - b.velocity;
    let along = relative.dot(&n);
    let turning = (u * a.radius + w * b.radius).cross(&n);
    (relative - n * along - turning, n, along)
}

#[test]
fn surfaces_part_as_the_law_says_and_all_momenta_are_kept() {
    let mut rng = seeded(1);
    for case in 0..2000 {
        let law = any_law(&mut rng);
        let e = f64::from(case % 11) / 10.0;
        let grains = two(&mut rng);
        let mut memory = spheres(vec![random(&mut rng, 3.0), random(&mut rng, 3.0)]);
        let mut world = World::builder(&mut memory)
            .rule(rough(e, law))
            .grains(grains)
            .unwrap()
            .start()
            .unwrap();
        let before = world.view().angular_momentum(0.4);
        let momentum = world.view().momentum();
        let energy =
            |w: &World<'_, _, 3, _>| w.view().kinetic_energy() + w.view().rotational_energy(0.4);
        let at_first = energy(&world);
        let Some(time) = world.next_event_time() else { continue };
        world.advance_to(time.since::<f64>(carom::Instant::START) - 1e-9).unwrap();
        let (g, n, along) = at_contact(&world);
        while world.statistics().collisions == 0 {
            world.step().unwrap();
        }
        let (after, _, away) = at_contact(&world);
        // Over the nanosecond before the touch nothing turns by more than this.
        let near = 1e-7;
        assert!((away + e * along).abs() < near, "{case}: {away} {along}");
        let factor = match law {
            Tangential::Constant { beta } => -beta,
            Tangential::Walton { mu, beta_0 } => {
                let sliding = mu * (1.0 + e) * -along * (1.0 + 1.0 / 0.4) / g.norm();
                1.0 - sliding.min(1.0 + beta_0)
            }
            _ => unreachable!(),
        };
        assert!((after - g * factor).norm() < near, "{case} {law:?}: {after} {g} {factor} {n}");
        assert!((world.view().momentum() - momentum).norm() < 1e-14);
        let turn = Vector::from(world.view().angular_momentum(0.4)) - Vector::from(before);
        assert!(turn.norm() < 2e-13, "{case}: {turn}");
        assert!(energy(&world) <= at_first * (1.0 + 1e-14));
    }
}

#[test]
fn a_perfectly_rough_elastic_gas_keeps_its_energy() {
    let mut rng = seeded(2);
    let spins = (0..64).map(|_| random(&mut rng, 1.0)).collect();
    let mut memory = spheres(spins);
    let grains = (0..64).map(|k: i32| {
        let at = [k % 4, k / 4 % 4, k / 16].map(|x| 1.5 * f64::from(x) + 0.75);
        Grain::with_mass(0.5, 1.0).at(at).moving(random(&mut rng, 1.0))
    });
    let mut world = World::builder(&mut memory)
        .walls([[0.0, 6.0]; 3])
        .rule(rough(1.0, Tangential::Constant { beta: 1.0 }))
        .grains(grains)
        .unwrap()
        .start()
        .unwrap();
    let energy =
        |w: &World<'_, _, 3, _>| w.view().kinetic_energy() + w.view().rotational_energy(0.4);
    let before = energy(&world);
    world.advance_to(50.0).unwrap();
    assert!(world.statistics().collisions > 1000 && world.statistics().plane_collisions > 1000);
    assert!((energy(&world) / before - 1.0).abs() < 1e-12);
}

#[test]
fn a_ball_that_hits_a_floor_obliquely_sticks_or_slides() {
    // v_n = 1, v_t = 1/4 or 4, no spin, μ = 1/4: (1 + ε) (1 + 1/q) μ v_n = 7/4 · (1 + ε) … of |g_t|.
    for (v, mu, beta_0) in [(0.25, 0.25, 0.5), (4.0, 0.25, 0.5), (0.5, 0.0, 1.0)] {
        let mut memory = Rotating::new(Memory::<f64, 2, 1>::new(), [[0.0]; 3]);
        let mut world = World::builder(&mut memory)
            .plane(Plane::new([0.0, 1.0], 0.0, Surface::Rule))
            .rule(Rough::spheres(
                HardSphere { restitution: 0.5 },
                Tangential::Walton { mu, beta_0 },
            ))
            .grain(Grain::with_mass(2.0, 3.0).at([0.0, 5.0]).moving([v, -1.0]))
            .unwrap()
            .start()
            .unwrap();
        world.advance_to(4.0).unwrap();
        let change = (mu * 1.5_f64 * 3.5 / v).min(1.0 + beta_0) * v * (2.0 / 7.0);
        let velocity = world.grain(0).unwrap().velocity;
        let spin = world.view().angular_velocity(0).unwrap()[2];
        assert!((velocity - carom::Vector::<f64, 2>::new(v - change, 0.5)).norm() < 1e-14);
        // The surface is dragged back: the ball begins to roll to the right, which is clockwise.
        assert!((spin + change / (0.4 * 2.0)).abs() < 1e-14, "{spin}");
    }
}

#[test]
fn smooth_surfaces_do_nothing() {
    let mut rng = seeded(3);
    let grains = two(&mut rng);
    let spins = vec![random(&mut rng, 3.0), random(&mut rng, 3.0)];
    let mut memory = spheres(spins.clone());
    let mut world = World::builder(&mut memory)
        .rule(rough(0.8, Tangential::Constant { beta: -1.0 }))
        .grains(grains)
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(5.0).unwrap();
    let mut memory = Memory::<f64, 3, 2>::new();
    let mut smooth = World::builder(&mut memory)
        .rule(HardSphere { restitution: 0.8 })
        .grains(grains)
        .unwrap()
        .start()
        .unwrap();
    smooth.advance_to(5.0).unwrap();
    for (i, spin) in spins.into_iter().enumerate() {
        assert_eq!(world.grain(i), smooth.grain(i));
        assert_eq!(world.view().angular_velocity(i), Some(spin));
        assert_eq!(smooth.view().angular_velocity(i), None);
    }
}

#[test]
fn surfaces_differ_by_material() {
    let of = |mu| {
        Rough::spheres(HardSphere { restitution: 1.0 }, Tangential::Walton { mu, beta_0: 0.0 })
    };
    let rule = ByMaterial([[of(0.0), of(0.1)], [of(0.1), of(0.2)]]);
    let mut memory = Rotating::new(Memory::<f64, 2, 2>::new(), [[0.0; 2]; 3]);
    let floor = Plane::new([0.0, 1.0], 0.0, Surface::Material(1));
    let grain = |x, material| {
        Grain::with_mass(0.5, 1.0).at([x, 1.5]).moving([4.0, -1.0]).of_material(material)
    };
    let mut world = World::builder(&mut memory)
        .plane(floor)
        .rule(rule)
        .grains([grain(0.0, 0), grain(9.0, 1)])
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(1.5).unwrap();
    for (i, mu) in [0.1, 0.2].into_iter().enumerate() {
        assert!((world.grain(i).unwrap().velocity.x - (4.0 - 2.0 * mu)).abs() < 1e-14);
    }
}

#[test]
fn what_is_no_coefficient_is_refused_by_name() {
    let bad = [
        (Tangential::Constant { beta: 1.1 }, "beta"),
        (Tangential::Constant { beta: f64::NAN }, "beta"),
        (Tangential::Walton { mu: -0.1, beta_0: 0.0 }, "mu"),
        (Tangential::Walton { mu: 0.1, beta_0: -1.5 }, "beta_0"),
        (Tangential::Spring { mu: 0.1, stiffness: 0.0, damping: 0.0 }, "tangential stiffness"),
        (Tangential::Spring { mu: 0.1, stiffness: 1.0, damping: -1.0 }, "tangential damping"),
    ];
    for (law, name) in bad {
        let said = rough(0.5, law).check().unwrap_err().to_string();
        assert!(said.contains(name), "{said}");
    }
    let hollow = Rough { inertia: 1.5, ..rough(0.5, Tangential::Constant { beta: 0.0 }) };
    assert!(hollow.check().unwrap_err().to_string().contains("inertia"));
    let smooth_and_rough = ByMaterial([
        [rough(0.5, Tangential::Constant { beta: 0.0 }); 2],
        [Rough { inertia: 0.5, ..rough(0.5, Tangential::Constant { beta: 0.0 }) }; 2],
    ]);
    assert!(smooth_and_rough.check().unwrap_err().to_string().contains("inertia"));
}

#[test]
fn memory_without_places_for_rotation_is_refused() {
    let rule = rough(0.5, Tangential::Constant { beta: 0.0 });
    let mut memory = Memory::<f64, 3, 2>::new();
    let started =
        World::builder(&mut memory).rule(rule).grain(Grain::with_mass(1.0, 1.0)).unwrap().start();
    assert!(matches!(started, Err(Error::Input { .. })));
    assert!(started.err().unwrap().to_string().contains("angular velocities"));
    let mut memory = spheres(vec![[0.0, f64::NAN, 0.0]]);
    let started =
        World::builder(&mut memory).rule(rule).grain(Grain::with_mass(1.0, 1.0)).unwrap().start();
    assert!(started.err().unwrap().to_string().contains("angular velocity"));
}
