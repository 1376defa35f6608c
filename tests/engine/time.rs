//! Is time in order, exact, and independent of observers? Runs, long runs, and observed runs.

use crate::gas::{damped_spring, elastic_spring, gas, length};
use carom::HeapMemory;
use carom::law::{HardSphere, Outside, Soft};
use carom::world::Event;
use carom::{Grain, Instant, Memory, Observer, Scalar, View, World};

/// An elastic ball between two hard walls, one length apart: it hits one of them every unit of time.
/// Returns the largest deviation of the interval between hits, over `hits` of them.
fn worst_interval<S: Scalar>(hits: u32, skip: u32) -> f64 {
    let half = S::from_f64(0.25);
    let mut memory = Memory::<S, 1, 1>::new();
    let mut world = World::builder(&mut memory)
        .hard_walls([[S::zero(), S::one()]], S::one())
        .rule(HardSphere { restitution: S::one() })
        .grain(Grain::with_mass(half, S::one()).at([half]).moving([S::half()]))
        .unwrap()
        .start()
        .unwrap();
    let mut last: Option<Instant> = None;
    let mut worst = 0.0_f64;
    for n in 0..hits {
        let at = world.step().unwrap().unwrap().at;
        if let Some(last) = last.filter(|_| n >= skip) {
            worst = worst.max((at.since::<f64>(last) - 1.0).abs());
        }
        last = Some(at);
    }
    assert!((world.now().as_f64() - f64::from(hits)).abs() < 1e-3 * f64::from(hits));
    worst
}

/// An f32 world after 10^6 s is as exact as at its start (here 2·10^5 s; the clock is set back every ten events).
#[test]
fn time_keeps_its_precision_as_it_grows() {
    let early = worst_interval::<f32>(1_000, 1);
    let late = worst_interval::<f32>(200_000, 199_000);
    assert!(late <= early.max(2.0e-6), "early {early:e}, late {late:e}");
}

#[test]
fn far_events_are_not_lost_when_clocks_are_set_back() {
    // Two fast grains bounce 10^4 times while a slow one creeps towards a fourth.
    let mut memory = Memory::<f32, 1, 4>::new();
    let grain = Grain::with_mass(0.25, 1.0);
    let mut world = World::builder(&mut memory)
        .rule(HardSphere { restitution: 1.0 })
        .plane(carom::space::Plane::new([1.0], 0.0, carom::space::Surface::Rule))
        .grains([grain.at([10.0]).moving([1.0e-3]), grain.at([11.5])])
        .unwrap()
        .start()
        .unwrap();
    let mut asked = 0.0_f32;
    while world.statistics().collisions == 0 && asked < 2000.0 {
        asked += 1.0;
        world.advance_to(asked).unwrap();
        world.set_gravity([0.0]).unwrap();
    }
    assert!((world.now().as_f64() - 1000.0).abs() < 1.5, "{}", world.now());
}

/// Checks that time never goes back and that what is seen is consistent.
struct InOrder {
    last: Instant,
    befores: u64,
    afters: u64,
}

impl Observer<f64, 3> for InOrder {
    fn before(&mut self, event: &Event<f64>, view: View<'_, f64, 3>) {
        assert!(event.at >= self.last && event.outcome.is_none());
        assert_eq!(event.at, view.now());
        self.last = event.at;
        self.befores += 1;
    }
    fn after(&mut self, event: &Event<f64>, _: View<'_, f64, 3>) {
        assert!(event.outcome.is_some());
        self.afters += 1;
    }
}

#[test]
fn events_come_in_order_and_observing_changes_nothing() {
    let run = |steps: u32, observed: bool| {
        let mut storage = HeapMemory::with_capacity(30);
        let mut world = World::builder(&mut storage)
            .periodic([[0.0, 6.0]; 3])
            .rule(Soft::linear_dashpot(damped_spring(), Outside::HardSphere))
            .grains(gas::<f64, 3>(30, 3, 6.0, [0.2, 0.4]))
            .unwrap()
            .start()
            .unwrap();
        let mut observer = InOrder { last: Instant::START, befores: 0, afters: 0 };
        for n in 1..=steps {
            let t = 20.0 * f64::from(n) / f64::from(steps);
            if observed {
                world.advance_observed(t, &mut observer).unwrap();
            } else {
                world.advance_to(t).unwrap();
            }
        }
        assert!(observer.befores == observer.afters && (!observed || observer.befores > 100));
        (world.digest(), *world.statistics())
    };
    let once = run(1, false);
    assert_eq!(once, run(977, false), "the number of calls must not matter");
    assert_eq!(once, run(100, true), "observing must not matter");
}

/// Stable detection (BSFP14): between events no pair that overlaps gets closer, whatever the rule did.
#[test]
fn no_overlap_gets_deeper_in_free_flight() {
    let mut storage = HeapMemory::with_capacity(30);
    let mut world = World::builder(&mut storage)
        .periodic([[0.0, 4.0]; 2])
        .rule(HardSphere { restitution: 0.8 })
        .grains(gas::<f64, 2>(30, 5, 4.0, [0.2, 0.3]))
        .unwrap()
        .start()
        .unwrap();
    for _ in 0..4000 {
        let Ok(Some(_)) = world.step() else { break };
        let view = world.view();
        for a in 0..30 {
            for b in 0..a {
                let (ga, gb) = (view.grain(a).unwrap(), view.grain(b).unwrap());
                let contact_distance = ga.radius + gb.radius;
                let separation = view.separation(a, b).unwrap();
                assert!(
                    length(&separation) > contact_distance * (1.0 - 1e-12),
                    "{a} and {b}: {:e}",
                    length(&separation) / contact_distance - 1.0
                );
            }
        }
    }
}

#[test]
fn next_event_time_is_never_late() {
    let mut storage = HeapMemory::with_capacity(20);
    let mut world = World::builder(&mut storage)
        .periodic([[0.0, 5.0]; 2])
        .rule(Soft::linear_dashpot(elastic_spring(), Outside::HardSphere))
        .grains(gas::<f64, 2>(20, 11, 5.0, [0.2, 0.4]))
        .unwrap()
        .start()
        .unwrap();
    for _ in 0..2000 {
        let promised = world.next_event_time().unwrap();
        let happened = world.step().unwrap().unwrap().at;
        assert!(happened >= promised);
    }
}
