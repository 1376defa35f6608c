//! What does a third grain that comes into a contact do? Times its arrival; compares MP13's exception (b).

use carom::law::LinearDashpot;
use carom::world::EventOutcome;
use carom::{Grain, Memory, World};
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
