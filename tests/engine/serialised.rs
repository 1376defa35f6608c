//! Does what a user saves come back as it was? Sends laws, impacts, events and errors through JSON; compares.

use crate::gas::{damped_spring, gas};
use carom::error::Subject;
use carom::law::{
    Answer, ByMaterial, Central, HardSphere, Impact, LinearDashpot, Outcome, Outside, Response,
    Rule, Soft, Validity, Viscoelastic,
};
use carom::particle::{Body, Partner};
use carom::scalar::{I32F32, Real};
use carom::space::{Plane, Surface, Vibration};
use carom::world::{Event, EventKind, EventOutcome, ScheduledEvent, Snapshot};
use carom::{Error, Grain, HeapMemory, Instant, Observer, View, World};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::json;
use std::fmt::Debug;

#[track_caller]
fn comes_back<T: Serialize + DeserializeOwned + PartialEq + Debug>(value: T) {
    let text = serde_json::to_string(&value).unwrap();
    assert_eq!(serde_json::from_str::<T>(&text).unwrap(), value, "{text}");
}

const IMPACT: Impact<f64> = Impact {
    contact_distance: 0.1,
    effective_radius: 0.3,
    reduced_mass: 1.0 / 3.0,
    normal_speed: 1e-300,
    tangential_speed: 0.7,
    acceleration: 0.0,
    materials: [1, 255],
};

#[test]
fn laws_and_impacts_come_back() {
    comes_back(HardSphere { restitution: 0.1_f32 });
    comes_back(Central(HardSphere { restitution: I32F32::from_f64(0.9) }));
    comes_back(LinearDashpot { stiffness: 1e3, damping: 0.1 });
    comes_back(Viscoelastic { young: 5e6, poisson: 0.4, dissipation: 1e-4 });
    for outside in [Outside::Reject, Outside::Clamp, Outside::HardSphere] {
        comes_back(outside);
    }
    for validity in [Validity::Inside, Validity::Clamped, Validity::HardSphere] {
        comes_back(validity);
    }
    comes_back(IMPACT);
    comes_back(Outcome { duration: 0.1, restitution: 0.9, separation: 0.99, angle: 0.2 });
}

#[test]
fn what_a_scene_is_made_of_comes_back() {
    comes_back(Grain::sphere(0.1, 2.0).at([0.1, -0.2, 0.3]).moving([1e-9, 2.0, 3.0]));
    let plate = Plane::new([0.0, 1.0], 0.1, Surface::Hard(0.9));
    comes_back(plate.vibrating(Vibration::new(0.1, 20.0)));
    comes_back(Instant::from(0.1) + Instant::from(1e9));
    for subject in [Subject::Grain(3), Subject::Plane(0), Subject::Axis(1), Subject::Rule] {
        comes_back(subject);
    }
}

fn rules() -> ByMaterial<HardSphere<f64>, 3> {
    let rule = |k: usize| HardSphere { restitution: 0.5 + 0.05 * k as f64 };
    ByMaterial(core::array::from_fn(|a| core::array::from_fn(|b| rule(3 * a.min(b) + a.max(b)))))
}

#[test]
fn rules_by_material_come_back_and_other_shapes_are_refused() {
    comes_back(rules());
    comes_back(ByMaterial([[rules(); 2]; 2]));
    let row = |n: usize| vec![json!({"restitution": 0.5}); n];
    for wrong in [vec![row(3); 2], vec![row(3); 4], vec![row(2); 3], vec![row(4); 3]] {
        assert!(serde_json::from_value::<ByMaterial<HardSphere<f64>, 3>>(json!(wrong)).is_err());
    }
}

/// A saved rule and a saved world, both from text, go on as the world that they were taken of.
#[test]
fn a_world_goes_on_with_its_saved_rule() {
    let mut storage = HeapMemory::with_capacity(20);
    let mut grains = gas::<f64, 2>(20, 1, 5.0, [0.2, 0.4]);
    for (k, grain) in (0..).zip(&mut grains) {
        grain.material = k % 3;
    }
    let mut world = World::builder(&mut storage)
        .walls([[0.0, 5.0]; 2])
        .gravity([0.0, -0.1])
        .rule(rules())
        .grains(grains)
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(3.0).unwrap();
    let text = serde_json::to_string(&(world.save(), rules())).unwrap();
    type Saved = Snapshot<f64, 2, Vec<Body<f64, 2>>, Vec<ScheduledEvent<f64>>>;
    let (saved, rule): (Saved, ByMaterial<HardSphere<f64>, 3>) =
        serde_json::from_str(&text).unwrap();
    let mut memory = HeapMemory::with_capacity(20);
    let mut again = World::restore(&mut memory, rule, &saved).unwrap();
    for world in [&mut world, &mut again] {
        world.advance_to(9.0).unwrap();
    }
    assert!(world.statistics().collisions > 50);
    assert_eq!(world.digest(), again.digest());
}

/// Writes each event as a line of JSON and reads it back.
struct Log(usize);

impl Observer<f64, 2> for Log {
    fn after(&mut self, event: &Event<f64>, _: View<'_, f64, 2>) {
        comes_back(*event);
        self.0 += 1;
    }
}

#[test]
fn events_come_back() {
    let mut storage = HeapMemory::with_capacity(20);
    let mut world = World::builder(&mut storage)
        .walls([[0.0, 5.0]; 2])
        .rule(Soft::linear_dashpot(damped_spring::<f64>(), Outside::HardSphere))
        .grains(gas::<f64, 2>(20, 1, 5.0, [0.2, 0.4]))
        .unwrap()
        .start()
        .unwrap();
    let mut log = Log(0);
    world.advance_observed(5.0, &mut log).unwrap();
    assert!(log.0 > 50);
    comes_back(Event::<f64> {
        at: Instant::START,
        grain: 7,
        partner: Partner::plane(2),
        kind: EventKind::TakeOff,
        outcome: Some(EventOutcome::Collision { restitution: 0.1 }),
    });
}

#[test]
fn errors_and_answers_are_written() {
    let negative = HardSphere { restitution: -1.0 };
    let error: Error = Rule::<f64>::check(&negative).unwrap_err();
    let text = serde_json::to_value(error).unwrap();
    let input = json!({"subject": "Rule", "field": "restitution", "value": -1.0, "wanted": "between 0 and 1"});
    assert_eq!(text, json!({ "Input": input }));
    let answer: Answer<f64> = HardSphere { restitution: 0.5 }.collide(&IMPACT);
    let text = serde_json::to_value(answer).unwrap();
    assert_eq!(text, json!({"response": {"Instantaneous": 0.5}, "validity": "Inside"}));
    let answer = serde_json::to_value(Response::<f64>::Overflow("length")).unwrap();
    assert_eq!(answer, json!({"Overflow": "length"}));
}
