//! Does it matter who is who, where, and how fast the laboratory moves? Compares runs of transformed gases.

use crate::gas::{damped_spring, gas};
use carom::HeapMemory;
use carom::law::{Outside, Soft};
use carom::scalar::Vector;
use carom::{Grain, World};
use proptest::prelude::*;

const LENGTH: f64 = 6.0;

/// How long they fly: about ten collisions.
const TIME: f64 = 3.0;

/// Positions and velocities afterwards, in the periodic box; none if nothing collided.
fn run(grains: &[Grain<f64, 2>]) -> Option<Vec<Grain<f64, 2>>> {
    let mut storage = HeapMemory::with_capacity(grains.len());
    let mut world = World::builder(&mut storage)
        .periodic([[0.0, LENGTH]; 2])
        .rule(Soft::linear_dashpot(damped_spring(), Outside::HardSphere))
        .grains(grains.iter().copied())
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(TIME).unwrap();
    let all = (0..grains.len()).map(|i| world.view().released(i).unwrap()).collect();
    (world.statistics().collisions > 0).then_some(all)
}

/// The largest difference of positions (nearest image) and velocities.
fn difference(a: &[Grain<f64, 2>], b: &[Grain<f64, 2>]) -> f64 {
    let near = |x: f64| x - LENGTH * (x / LENGTH).round();
    a.iter()
        .zip(b)
        .map(|(a, b)| {
            (a.position - b.position).map(near).amax().max((a.velocity - b.velocity).amax())
        })
        .fold(0.0, f64::max)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn permuted_grains_do_the_same(seed in 0_u64..10_000, shift in 1_usize..11) {
        let grains = gas::<f64, 2>(12, seed, LENGTH, [0.3, 0.5]);
        let Some(plain) = run(&grains) else { return Err(TestCaseError::reject("no collision")) };
        let mut other = grains.clone();
        other.rotate_left(shift);
        let mut back = run(&other).unwrap();
        back.rotate_right(shift);
        let d = difference(&plain, &back);
        prop_assert!(d < 1e-9, "{d:e}");
    }

    #[test]
    fn the_mirror_image_is_the_image_of_the_mirror(seed in 0_u64..10_000) {
        let mirror = |g: &Grain<f64, 2>| Grain {
            position: Vector::from([LENGTH - g.position[0], g.position[1]]),
            velocity: Vector::from([-g.velocity[0], g.velocity[1]]),
            ..*g
        };
        let grains = gas::<f64, 2>(12, seed, LENGTH, [0.3, 0.5]);
        let Some(plain) = run(&grains) else { return Err(TestCaseError::reject("no collision")) };
        let mirrored: Vec<_> = grains.iter().map(mirror).collect();
        let back: Vec<_> = run(&mirrored).unwrap().iter().map(mirror).collect();
        let d = difference(&plain, &back);
        prop_assert!(d < 1e-9, "{d:e}");
    }

    #[test]
    fn a_moving_laboratory_sees_the_same(seed in 0_u64..10_000, u in -2.0..2.0_f64) {
        let boost = Vector::from([u, -0.5 * u]);
        let grains = gas::<f64, 2>(12, seed, LENGTH, [0.3, 0.5]);
        let Some(plain) = run(&grains) else { return Err(TestCaseError::reject("no collision")) };
        let moving: Vec<_> = grains.iter().map(|g| Grain { velocity: g.velocity + boost, ..*g }).collect();
        let back: Vec<_> = run(&moving).unwrap().iter().map(|g| Grain {
            position: g.position - boost * TIME,
            velocity: g.velocity - boost,
            ..*g
        }).collect();
        let d = difference(&plain, &back);
        prop_assert!(d < 1e-9, "{d:e}");
    }
}
