//! Does whatever moves among grains leave the world whole? Random motions, rooms and rules: no number is lost, nobody leaves, time goes on.

use super::shapes::{circle, ring};
use carom::law::{HardSphere, LinearDashpot, Outside, Rule, Soft};
use carom::space::{Facet, RigidMotion, Surface};
use carom::world::WithObstacles;
use carom::{Grain, HeapMemory, World};
use proptest::prelude::*;

/// A room of so many sides that turns, a bar in it that vibrates and one that turns the other way, and disks around them.
#[derive(Clone, Debug)]
struct Scene {
    sides: usize,
    omega: [f64; 2],
    shake: ([f64; 2], f64),
    gravity: f64,
    epsilon: f64,
    disks: Vec<[f64; 4]>,
}

fn scene() -> impl Strategy<Value = Scene> {
    let disk = (-0.8..0.8, 0.35..0.8, -1.0..1.0, -1.0..1.0);
    let disks = prop::collection::vec(disk.prop_map(|(x, y, u, v)| [x, y, u, v]), 1..12);
    let omega = (-4.0..4.0, -8.0..8.0).prop_map(|(a, b)| [a, b]);
    let shake = ((-0.1..0.1, -0.1..0.1).prop_map(|(a, b)| [a, b]), 0.5..8.0);
    (3_usize..40, omega, shake, prop_oneof![Just(0.0), 0.0..10.0], 0.0..1.0, disks).prop_map(
        |(sides, omega, shake, gravity, epsilon, disks)| Scene {
            sides,
            omega,
            shake,
            gravity,
            epsilon,
            disks,
        },
    )
}

/// Runs it for three seconds; says what is wrong.
fn run(scene: &Scene, rule: impl Rule<f64>, surface: Surface<f64>) -> Result<(), String> {
    let Scene { sides, omega, shake, gravity, disks, .. } = scene;
    // The circle inside the room has radius 2.
    let radius = 2.0 / (std::f64::consts::PI / *sides as f64).cos();
    let room = ring(&circle([0.0, 0.0], radius, *sides), surface);
    let mut facets: Vec<_> = room.into_iter().map(|facet| facet.moving(0)).collect();
    facets.push(Facet::new([[-0.5, -0.9], [0.5, -0.9]], surface).moving(1));
    facets.push(Facet::new([[-0.6, 0.0], [0.6, 0.0]], surface).moving(2));
    let lists = vec![Default::default(); 40 * facets.len()];
    let turning = |omega| RigidMotion::<f64, 2>::turning([0.0, 0.0], omega);
    let (amplitude, frequency) = *shake;
    let motions =
        [turning(omega[0]), RigidMotion::vibrating(amplitude, frequency), turning(omega[1])];
    let mut memory =
        WithObstacles::new(HeapMemory::with_capacity(disks.len()), facets, lists).moving(motions);
    let mut builder = World::builder(&mut memory).gravity([0.0, -gravity]).rule(rule);
    let mut placed: Vec<[f64; 2]> = Vec::new();
    for &[x, y, u, v] in disks {
        let apart = |at: &[f64; 2]| (at[0] - x).hypot(at[1] - y) > 0.21;
        if x.hypot(y) > 0.75 && placed.iter().all(apart) {
            placed.push([x, y]);
            let disk = Grain::with_mass(0.1, 1.0).at([x, y]).moving([u, v]);
            builder = builder.grain(disk).map_err(|why| why.to_string())?;
        }
    }
    let mut world = builder.start().map_err(|why| why.to_string())?;
    for k in 1..=30 {
        world.advance_to(f64::from(k) * 0.1).map_err(|why| format!("at {k}: {why}"))?;
        for i in 0..placed.len() {
            let grain = world.grain(i).unwrap();
            let far = grain.position.norm();
            if !(far < radius) || !grain.velocity.norm().is_finite() {
                return Err(format!("grain {i} is at {:?}, {:?}", grain.position, grain.velocity));
            }
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn hard_disks_stay_whole(scene in scene()) {
        // A turning room and one that is driven give them energy without end, so a second bar may press a disk.
        let rule = HardSphere { restitution: scene.epsilon };
        let wrong = run(&scene, rule, Surface::Hard(scene.epsilon));
        prop_assert!(wrong.is_ok(), "{wrong:?}");
    }

    #[test]
    fn soft_disks_stay_whole(scene in scene()) {
        let law = LinearDashpot { stiffness: 1.0e5, damping: 20.0 };
        let wrong = run(&scene, Soft::linear_dashpot(law, Outside::HardSphere), Surface::Rule);
        prop_assert!(wrong.is_ok(), "{wrong:?}");
    }
}
