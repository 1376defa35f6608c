//! What changes with gravity, and what does not? Changes it, or sets it to what it is; compares bits.

use crate::gas::{damped_spring, gas};
use carom::law::{HardSphere, Outside, Soft};
use carom::{Enduring, Grain, HeapMemory, World};

/// A box of falling grains that began with one gravity and was given another before anything happened.
fn settled(start: [f64; 2], gravity: [f64; 2]) -> (Vec<Grain<f64, 2>>, u64) {
    let mut storage = HeapMemory::with_capacity(24);
    let mut world = World::builder(&mut storage)
        .enduring(Enduring::Paper)
        .hard_walls([[0.0, 3.1]; 2], 0.5)
        .gravity(start)
        .rule(HardSphere { restitution: 0.6 })
        .grains(gas::<f64, 2>(24, 1, 3.1, [0.05, 0.1]))
        .unwrap()
        .start()
        .unwrap();
    if start != gravity {
        world.set_gravity(gravity).unwrap();
    }
    for _ in 0..20_000 {
        world.step().unwrap();
    }
    let grains = (0..24).map(|i| world.grain(i).unwrap()).collect();
    (grains, world.statistics().within_tc)
}

/// How slow is slow and which hops are too short to be any follow from gravity as it is now: a world that
/// was given it at the first instant goes on as one that was built with it, to the last bit.
#[test]
fn gravity_given_at_the_start_is_gravity_built_with() {
    let gravity = [0.0, -9.81];
    let (expected, short_hops) = settled(gravity, gravity);
    assert!(short_hops > 0);
    for start in [[0.0, 0.0], [0.0, -981.0], [9.81, 0.0]] {
        assert_eq!(settled(start, gravity), (expected.clone(), short_hops), "{start:?}");
    }
}

/// A sensor that reads the same again changes no bit: grains at rest stay so, contacts go on.
#[test]
fn the_same_gravity_again_changes_nothing() {
    let rule = Soft::linear_dashpot(damped_spring::<f64>(), Outside::HardSphere);
    let digest = |reads: bool| {
        let mut memory = HeapMemory::with_capacity(10);
        let mut world = World::builder(&mut memory)
            .walls([[0.0, 3.1]; 2])
            .gravity([0.0, -1.0])
            .rule(rule)
            .grains(gas::<f64, 2>(10, 1, 3.1, [0.15, 0.2]))
            .unwrap()
            .start()
            .unwrap();
        for _ in 0..2000 {
            world.step().unwrap();
            if reads {
                world.set_gravity([0.0, -1.0]).unwrap();
            }
        }
        world.digest()
    };
    assert_eq!(digest(true), digest(false));
}
