//! Is a restored world the same world? Saves through JSON in the middle of contacts; compares digests.

use crate::gas::{damped_spring, gas};
use carom::HeapMemory;
use carom::law::{HardSphere, IntegratedMode, Outside, PaperMode, Soft};
use carom::particle::Body;
use carom::space::{Plane, Surface, Vibration};
use carom::world::{ScheduledEvent, Snapshot, Statistics};
use carom::{Enduring, Grain, Memory, World};

#[test]
fn a_snapshot_goes_on_with_the_same_bits() {
    let rule = Soft::linear_dashpot(damped_spring::<f64>(), Outside::HardSphere);
    let mut storage = HeapMemory::with_capacity(20);
    let mut world = World::builder(&mut storage)
        .walls([[0.0, 5.0]; 2])
        .gravity([0.0, -0.1])
        .rule(rule)
        .grains(gas::<f64, 2>(20, 1, 5.0, [0.2, 0.4]))
        .unwrap()
        .start()
        .unwrap();
    for _ in 0..300 {
        world.step().unwrap();
    }
    while !(0..20).any(|i| world.view().contact(i).is_some()) {
        world.step().unwrap();
    }
    let text = serde_json::to_string(&world.save()).unwrap();
    let saved: Snapshot<f64, 2, Vec<Body<f64, 2>>, Vec<ScheduledEvent<f64>>> =
        serde_json::from_str(&text).unwrap();
    let mut memory = Memory::<f64, 2, 32>::new();
    let mut again = World::restore(&mut memory, rule, &saved).unwrap();
    assert_eq!(world.digest(), again.digest());
    for _ in 0..1000 {
        world.step().unwrap();
        again.step().unwrap();
    }
    assert_eq!(world.digest(), again.digest());
    assert_eq!(world.statistics(), again.statistics());
}

#[test]
fn a_snapshot_that_is_not_one_is_refused() {
    let rule = Soft::linear_dashpot(damped_spring::<f64>(), Outside::HardSphere);
    let mut storage = HeapMemory::with_capacity(2);
    let world = World::builder(&mut storage)
        .rule(rule)
        .grains(gas::<f64, 2>(2, 1, 5.0, [0.2, 0.4]))
        .unwrap()
        .start()
        .unwrap();
    let text = serde_json::to_string(&world.save()).unwrap();
    let broken = [
        text.replacen("\"clock\":0.0", "\"clock\":5.0", 1),
        text.replacen("\"partner\":4294967295", "\"partner\":77", 1),
        text.replacen("\"mass\":1.0", "\"mass\":-1.0", 1),
    ];
    for bad in broken {
        assert_ne!(bad, text);
        let saved: Snapshot<f64, 2, Vec<Body<f64, 2>>, Vec<ScheduledEvent<f64>>> =
            serde_json::from_str(&bad).unwrap();
        let mut memory = Memory::<f64, 2, 4>::new();
        assert!(World::restore(&mut memory, rule, &saved).is_err());
    }
}

/// Grains that lose energy to each other over a floor that takes none: what slow hops may do depends on
/// whether one was seen that would have lost energy, and not on how often anything was counted.
#[test]
fn statistics_decide_nothing() {
    goes_on_without_statistics(Enduring::Paper, |world| world.statistics().within_tc > 0);
    goes_on_without_statistics(Enduring::Integrated, |world| world.statistics().steps > 1000);
}

fn goes_on_without_statistics(
    enduring: Enduring,
    is_then: impl Fn(&World<'_, f64, 2, HardSphere<f64>>) -> bool,
) {
    let rule = HardSphere { restitution: 0.6 };
    let mut storage = HeapMemory::with_capacity(24);
    let mut world = World::builder(&mut storage)
        .enduring(enduring)
        .plane(Plane::new([1.0, 0.0], 0.0, Surface::Hard(0.5)))
        .plane(Plane::new([-1.0, 0.0], -3.1, Surface::Hard(0.5)))
        .plane(Plane::new([0.0, 1.0], 0.0, Surface::Hard(1.0)))
        .gravity([0.0, -9.81])
        .rule(rule)
        .grains(gas::<f64, 2>(24, 1, 3.1, [0.05, 0.1]))
        .unwrap()
        .start()
        .unwrap();
    while !is_then(&world) {
        world.step().unwrap();
    }
    let mut saved = serde_json::to_value(world.save()).unwrap();
    for counter in saved["statistics"].as_object_mut().unwrap().values_mut() {
        *counter = 0.into();
    }
    let saved: Snapshot<f64, 2, Vec<Body<f64, 2>>, Vec<ScheduledEvent<f64>>> =
        serde_json::from_value(saved).unwrap();
    let mut memory = HeapMemory::with_capacity(24);
    let mut again = World::restore(&mut memory, rule, &saved).unwrap();
    assert_eq!(again.statistics(), &Statistics::default());
    for event in 0..20_000 {
        world.step().unwrap();
        again.step().unwrap();
        assert_eq!(world.digest(), again.digest(), "after {event} events");
    }
}

/// A snapshot of a restored world is the snapshot that it was restored from, in everything: how many events
/// there were at one instant, too, or it would notice later than the other that it is stuck.
#[test]
fn a_restored_world_is_stuck_when_the_other_is() {
    let rule = HardSphere { restitution: 0.5 };
    let mut memory = Memory::<f64, 1, 2>::new();
    let mut world = World::builder(&mut memory)
        .enduring(Enduring::Paper)
        .plane(Plane::new([1.0], 0.0, Surface::Hard(0.5)).vibrating(Vibration::new(0.5, 1.0)))
        .plane(Plane::new([-1.0], -2.25, Surface::Hard(0.5)))
        .rule(rule)
        .grain(Grain::with_mass(0.5, 1.0).at([0.6]).moving([0.1]))
        .unwrap()
        .grain(Grain::with_mass(0.5, 1.0).at([1.7]).moving([-0.1]))
        .unwrap()
        .start()
        .unwrap();
    for _ in 0..3000 {
        world.step().unwrap();
    }
    let saved = world.save();
    let mut other = Memory::<f64, 1, 2>::new();
    let mut again = World::restore(&mut other, rule, &saved).unwrap();
    assert_eq!(again.save(), saved);
    let ends = [&mut world, &mut again]
        .map(|world| (0..1_000_000).map(|_| world.step()).position(|step| step.is_err()));
    assert_eq!(ends[0], ends[1]);
    assert!(ends[0].is_some());
}

/// A rule of one mode does not take over a world of the other: its clusters would stand still.
#[test]
fn a_rule_of_one_mode_refuses_a_snapshot_of_the_other() {
    let rule = HardSphere { restitution: 0.5 };
    let mut memory = Memory::<f64, 1, 2>::new();
    let world = World::builder(&mut memory)
        .rule(rule)
        .grain(Grain::with_mass(0.5, 1.0))
        .unwrap()
        .start()
        .unwrap();
    let saved = world.save();
    let mut other = Memory::<f64, 1, 2>::new();
    assert!(World::restore(&mut other, PaperMode(rule), &saved).is_err());
    assert!(World::restore(&mut other, IntegratedMode(rule), &saved).is_ok());
}
