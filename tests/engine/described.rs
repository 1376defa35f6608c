//! Is a world that was described call by call the one of the chain? Refuses bad calls on the way; compares digests.

use crate::gas::{damped_spring, gas};
use carom::law::{HardSphere, LinearDashpot, Outside, Soft};
use carom::space::{Plane, Surface, Vibration};
use carom::{Error, Grain, Instant, Memory, World};

const SIDE: f64 = 5.0;
const GRAINS: usize = 20;

fn rule() -> Soft<LinearDashpot<f64>> {
    Soft::linear_dashpot(damped_spring::<f64>(), Outside::HardSphere)
}

fn floor() -> Plane<f64, 2> {
    Plane::new([0.0, 1.0], 0.0, Surface::Hard(0.8)).vibrating(Vibration::new(0.01, 1.5))
}

fn lid() -> Plane<f64, 2> {
    Plane::new([0.0, -1.0], -SIDE, Surface::Rule)
}

fn chained(memory: &mut Memory<f64, 2, 32>) -> World<'_, f64, 2, Soft<LinearDashpot<f64>>> {
    World::builder(memory)
        .periodic_axis(0, [0.0, SIDE])
        .plane(floor())
        .plane(lid())
        .gravity([0.0, -0.2])
        .contact_time(0.01)
        .steps_per_contact(16)
        .rule(rule())
        .grains(gas::<f64, 2>(GRAINS, 1, SIDE, [0.2, 0.4]))
        .unwrap()
        .start()
        .unwrap()
}

#[test]
fn what_is_refused_leaves_no_trace_and_a_check_neither() {
    let mut memory = Memory::<f64, 2, 32>::new();
    let mut calls = World::builder(&mut memory).rule(rule());
    let (nan, infinite) = (f64::NAN, f64::INFINITY);
    let is_input = |refused: Result<(), Error>| matches!(refused, Err(Error::Input { .. }));
    assert!(is_input(calls.set_periodic_axis(2, [0.0, SIDE])));
    assert!(is_input(calls.set_periodic_axis(1, [SIDE, 0.0])));
    assert!(is_input(calls.set_periodic_axis(1, [0.0, infinite])));
    calls.set_periodic_axis(0, [0.0, SIDE]).unwrap();
    let tilted = Plane::new([0.6, 0.6], 0.0, Surface::Rule);
    let elastic = Plane::new([0.0, 1.0], 0.0, Surface::Hard(1.5));
    let still = floor().vibrating(Vibration::new(0.01, 0.0));
    for plane in [tilted, elastic, still, Plane { offset: nan, ..floor() }] {
        assert!(is_input(calls.add_plane(plane).map(drop)));
    }
    let sides = [[0.0, SIDE]; 2];
    assert!(is_input(calls.add_walls(sides, Surface::Hard(nan))));
    assert!(is_input(calls.add_walls([[0.0, SIDE], [SIDE, 0.0]], Surface::Rule)));
    assert_eq!([floor(), lid()].map(|plane| calls.add_plane(plane).unwrap()), [0, 1]);
    assert!(is_input(calls.set_gravity([0.0, nan])));
    calls.set_gravity([0.0, -0.2]).unwrap();
    assert!(is_input(calls.set_contact_time(0.0)));
    calls.set_contact_time(0.01).unwrap();
    for steps in [0, 7, 131_073, u32::MAX] {
        assert!(is_input(calls.set_steps_per_contact(steps)));
    }
    calls.set_steps_per_contact(131_072).unwrap();
    calls.set_steps_per_contact(16).unwrap();
    let negative = LinearDashpot { stiffness: -1.0, damping: 0.0 };
    assert!(is_input(calls.set_rule(Soft::linear_dashpot(negative, Outside::Reject))));
    calls.set_rule(rule()).unwrap();
    for (number, grain) in gas::<f64, 2>(GRAINS, 1, SIDE, [0.2, 0.4]).into_iter().enumerate() {
        assert!(is_input(calls.add_grain(Grain { radius: nan, ..grain }).map(drop)));
        assert_eq!(calls.add_grain(grain).unwrap(), number);
        calls.check().unwrap();
    }
    calls.check().unwrap();
    let mut called = calls.start().unwrap();
    let mut other = Memory::new();
    let mut chained = chained(&mut other);
    assert_eq!(called.digest(), chained.digest());
    for world in [&mut called, &mut chained] {
        world.advance_to(20.0).unwrap();
    }
    assert!(called.statistics().collisions > 100 && called.statistics().plane_collisions > 100);
    assert_eq!(called.digest(), chained.digest());
    assert_eq!(called.statistics(), chained.statistics());
}

#[test]
fn what_cannot_start_can_be_mended() {
    let mut memory = Memory::<f64, 1, 3, 1>::new();
    let hard = HardSphere { restitution: 0.5 };
    let mut beads = World::builder(&mut memory).rule(hard);
    let bead = |x: f64| Grain::with_mass(0.5, 1.0).at([x]);
    beads.add_plane(Plane::new([1.0], 0.0, Surface::Rule)).unwrap();
    let walls = |world: &mut carom::world::WorldBuilder<'_, _, 1, _>, sides, surface| {
        world.add_walls([sides], surface)
    };
    assert!(matches!(walls(&mut beads, [0.0, 9.0], Surface::Rule), Err(Error::Full { .. })));
    let full = beads.add_plane(Plane::new([-1.0], -9.0, Surface::Rule));
    assert!(matches!(full, Err(Error::Full { capacity: 1, .. })));
    assert_eq!([1.0, 3.0, 5.0].map(|x| beads.add_grain(bead(x)).unwrap()), [0, 1, 2]);
    assert!(matches!(beads.add_grain(bead(7.0)), Err(Error::Full { capacity: 3, .. })));
    beads.set_gravity([-1.0]).unwrap();
    beads.set_contact_time(3.0).unwrap();
    assert!(matches!(beads.check(), Err(Error::LongContact { .. })));
    beads.set_contact_time(0.01).unwrap();
    beads.check().unwrap();
    let mut world = beads.start().unwrap();
    world.advance_to(Instant::from(30.0)).unwrap();
    assert!((0..3).all(|i| world.view().is_at_rest(i)));
}
