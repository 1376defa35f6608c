//! What does a third grain that comes into a contact do? Times its arrival; compares MP13's exception (b).

use carom::law::LinearDashpot;
use carom::space::{Plane, Surface, Vibration};
use carom::world::EventOutcome;
use carom::{Enduring, Grain, Memory, World};
use carom_host::integrated::Integrated;

/// A head-on contact begins at t = 1; a third grain comes to it after `part` of its duration. When it ends
/// the contact, in parts of the duration, and how many had to wait and how many came before the end.
fn interrupted(part: f64) -> (f64, [u64; 2]) {
    let law = LinearDashpot { stiffness: 1.0e4, damping: 0.0 };
    let duration = std::f64::consts::PI * (1.0_f64 / 1.0e4).sqrt();
    let arrival = 1.0 + part * duration;
    // The two go on with the velocity of their centre of mass; the third comes from the right with speed 1.
    let touched = 2.0 + 0.5 * (arrival - 1.0) + 1.0 + arrival;
    let mut memory = Memory::<f64, 1, 3>::new();
    let mut world = World::builder(&mut memory)
        .enduring(Enduring::Paper)
        .rule(Integrated::new(law))
        .grain(Grain::with_mass(0.5, 2.0).moving([1.0]))
        .unwrap()
        .grain(Grain::with_mass(0.5, 2.0).at([2.0]))
        .unwrap()
        .grain(Grain::with_mass(0.5, 2.0).at([touched]).moving([-1.0]))
        .unwrap()
        .start()
        .unwrap();
    let begin = world.step().unwrap().unwrap();
    assert!(matches!(begin.outcome, Some(EventOutcome::ContactBegan(_))), "{begin:?}");
    let end = world.step().unwrap().unwrap();
    assert_eq!(end.outcome, Some(EventOutcome::ContactInterrupted));
    let counts = [world.statistics().deferred, world.statistics().interrupted];
    ((end.at.as_f64() - begin.at.as_f64()) / duration, counts)
}

/// Within the first 64th of a contact a third body waits, and is counted as one that did.
#[test]
fn who_comes_in_the_first_64th_of_a_contact_waits_and_is_counted() {
    for (part, end, counts) in [
        (1.0 / 1024.0, 1.0 / 64.0, [1, 1]),
        (1.0 / 128.0, 1.0 / 64.0, [1, 1]),
        (1.0 / 50.0, 1.0 / 50.0, [0, 1]),
        (0.5, 0.5, [0, 1]),
    ] {
        let (ended, counted) = interrupted(part);
        assert!((ended - end).abs() < 1e-9, "{part}: {ended}");
        assert_eq!(counted, counts, "{part}");
    }
}

/// A contact begins at t = 1 under gravity g between two whose centre of mass moves with `speed`; a third
/// grain touches at once, or all but. When the contact is ended, after its beginning.
fn waited(speed: f64, g: f64, plate: Option<Vibration<f64>>) -> f64 {
    let law = LinearDashpot { stiffness: 1.0e4, damping: 0.0 };
    let mut memory = Memory::<f64, 1, 3>::new();
    let mut builder = World::builder(&mut memory)
        .enduring(Enduring::Paper)
        .gravity([g])
        .rule(Integrated::new(law));
    if let Some(plate) = plate {
        builder = builder.plane(Plane::new([1.0], -1e3, Surface::Hard(1.0)).vibrating(plate));
    }
    let grain = |x: f64, v: f64| Grain::with_mass(0.5, 2.0).at([x]).moving([speed + v]);
    let mut world = builder
        .grains([grain(0.0, 0.5), grain(1.0, -0.5), grain(2.0 + 1e-7, -1.0)])
        .unwrap()
        .start()
        .unwrap();
    let begin = world.step().unwrap().unwrap();
    assert!(matches!(begin.outcome, Some(EventOutcome::ContactBegan(_))), "{begin:?}");
    let end = world.step().unwrap().unwrap();
    assert_eq!(end.outcome, Some(EventOutcome::ContactInterrupted));
    end.at.as_f64() - begin.at.as_f64()
}

/// Less than a 64th of the contact if the pair, or a plate towards it, can move a 64th of the radius sooner:
/// v t + g t²/2 = R/64.
#[test]
fn who_waits_does_so_no_longer_than_anything_can_move_a_64th_of_the_radius() {
    let brief = std::f64::consts::PI * (1.0_f64 / 1.0e4).sqrt() / 64.0;
    let far = 0.5 / 64.0;
    assert!((waited(0.0, 0.0, None) / brief - 1.0).abs() < 1e-9);
    assert!((waited(1.0, -1.0, None) / brief - 1.0).abs() < 1e-9);
    assert!((waited(100.0, 0.0, None) / (far / 100.0) - 1.0).abs() < 1e-9);
    let g: f64 = 1e6;
    assert!((waited(0.0, -g, None) / (2.0 * far / g).sqrt() - 1.0).abs() < 1e-6);
    let plate = Vibration::new(50.0 / std::f64::consts::TAU, 1.0);
    assert!((waited(50.0, 0.0, Some(plate)) / (far / 100.0) - 1.0).abs() < 1e-9);
}

/// A wall is a third body, too.
#[test]
fn a_wall_waits_as_long_as_a_grain() {
    let law = LinearDashpot { stiffness: 1.0e4, damping: 0.0 };
    let duration = std::f64::consts::PI * (1.0_f64 / 1.0e4).sqrt();
    for (part, end) in [(1.0 / 128.0, 1.0 / 64.0), (0.5, 0.5)] {
        let wall = 2.5 + 0.5 * part * duration;
        let mut memory = Memory::<f64, 1, 2>::new();
        let mut world = World::builder(&mut memory)
            .enduring(Enduring::Paper)
            .plane(Plane::new([-1.0], -wall, Surface::Hard(1.0)))
            .rule(Integrated::new(law))
            .grain(Grain::with_mass(0.5, 2.0).moving([1.0]))
            .unwrap()
            .grain(Grain::with_mass(0.5, 2.0).at([2.0]))
            .unwrap()
            .start()
            .unwrap();
        let begin = world.step().unwrap().unwrap();
        let event = world.step().unwrap().unwrap();
        assert_eq!(event.outcome, Some(EventOutcome::ContactInterrupted));
        let ended = (event.at.as_f64() - begin.at.as_f64()) / duration;
        assert!((ended - end).abs() < 1e-9, "{part}: {ended}");
    }
}
