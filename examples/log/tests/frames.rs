//! What does a firmware's log carry? Writes errors, events and grains through `defmt`; looks for their numbers in the bytes.

use carom::error::Subject;
use carom::law::{ByMaterial, Central, HardSphere, Outcome, Outside, Response, Viscoelastic};
use carom::particle::Partner;
use carom::scalar::{I16F16, I32F32, Real};
use carom::space::{Plane, Surface, Vibration};
use carom::world::{Event, EventKind, EventOutcome, Release};
use carom::{Error, Grain, HeapMemory, Instant, World};
use carom_log::frame;

#[track_caller]
fn holds(frame: &[u8], part: &[u8]) {
    assert!(frame.windows(part.len()).any(|here| here == part), "{part:?} is not in {frame:?}");
}

/// The error of a world that has no place for its second grain, and of one whose rule is wrong.
#[test]
fn an_error_names_field_value_and_remedy_in_few_bytes() {
    let mut memory = HeapMemory::<f64, 2>::with_capacity(1);
    let error = World::builder(&mut memory)
        .rule(HardSphere { restitution: -0.3 })
        .grain(Grain::with_mass(0.5, 1.0))
        .unwrap()
        .start()
        .err()
        .unwrap();
    let Error::Input { field, value, wanted, .. } = error else { panic!("{error}") };
    let bytes = frame(error);
    for part in [field.as_bytes(), &value.to_le_bytes(), wanted.as_bytes()] {
        holds(&bytes, part);
    }
    let full = Error::Full { knob: "Memory", capacity: 77 };
    holds(&frame(full), &77_u32.to_le_bytes());
    assert!(2 * frame(full).len() < full.to_string().len());
    assert!(frame(Subject::World).len() < 8);
}

/// Vectors are lists, instants and fixed-point numbers are `f64`.
#[test]
fn numbers_are_sent_as_they_are() {
    let at = Instant::from(12.25);
    holds(&frame(at), &12.25_f64.to_le_bytes());
    for bytes in [frame(I32F32::from_f64(-1.5)), frame(I16F16::from_f64(-1.5))] {
        holds(&bytes, &(-1.5_f64).to_le_bytes());
    }
    assert!(frame(Partner::plane(3)).len() == frame(Partner::grain(3)).len());
    holds(&frame(Partner::grain(3)), &3_u32.to_le_bytes());
    let grain = frame(Grain::with_mass(0.5_f32, 3.0).at([1.0, 2.0, 4.0]));
    let position = [1.0_f32, 2.0, 4.0].map(f32::to_le_bytes).concat();
    holds(&grain, &position);
    assert!(grain.len() < 64, "{} bytes", grain.len());
    let plate = Plane::new([0.0, 1.0], 0.1, Surface::Hard(0.9)).vibrating(Vibration::new(7.0, 1.0));
    holds(&frame(plate), &7.0_f64.to_le_bytes());
}

#[test]
fn events_rules_and_statistics_are_formats() {
    let outcome = Outcome { duration: 0.1, restitution: 0.9, separation: 0.99, angle: 0.2 };
    let event = Event {
        at: Instant::START,
        grain: 1000,
        partner: Partner::NOTHING,
        kind: EventKind::Collision,
        outcome: Some(EventOutcome::ContactBegan(outcome)),
    };
    let bytes = frame(event);
    holds(&bytes, &1000_u32.to_le_bytes());
    holds(&bytes, &0.99_f64.to_le_bytes());
    let statistics = carom::Statistics::default();
    assert!(frame(statistics).len() >= size_of_val(&statistics));
    holds(&frame(ByMaterial([[HardSphere { restitution: 0.7 }; 2]; 2])), &0.7_f64.to_le_bytes());
    let rubber = Viscoelastic { young: 5e6_f32, poisson: 0.4, dissipation: 1e-4 };
    holds(&frame((Central(rubber), Outside::Clamp, Release::Paired)), &5e6_f32.to_le_bytes());
    holds(&frame(Response::<f32>::Overflow("length")), b"length");
}
