//! Can a small heap stop the engine? Draws boxes as `carom soak --heaps` does; writes nothing.

use carom_host::heaps::{self, Ended, Number};

/// Some boxes of each number type: none breaks, and most of those that must are asleep, not sliding.
#[test]
fn small_boxes_of_all_kinds_come_to_what_they_must() {
    let (mut asleep, mut due) = (0, 0);
    for (number, seeds) in [
        (Number::F64, 1..11),
        (Number::F32, 17..23),
        (Number::I32f32, 25..31),
        (Number::I16f16, 31..37),
    ] {
        for seed in seeds {
            let (drawn, report) = heaps::run(seed, 12, number);
            if let Ended::Broken(what) = &report.ended {
                panic!("{number:?}, seed {seed}: {what}: {drawn:?}");
            }
            due += u32::from(drawn.must_sleep_by().is_some());
            asleep += u32::from(matches!(report.ended, Ended::Asleep(_)));
        }
    }
    assert!(2 * asleep > due, "{asleep} of {due}");
}

/// A box follows from its seed.
#[test]
fn a_seed_gives_the_same_box_again() {
    for seed in 0..8 {
        let [one, other] = [heaps::run(seed, 3, Number::F64), heaps::run(seed, 3, Number::F64)];
        assert_eq!(format!("{:?}", one.0), format!("{:?}", other.0));
        assert_eq!(one.1.ended, other.1.ended);
        assert_eq!(one.1.deepest, other.1.deepest);
    }
}

/// Slow grains far from the origin, in numbers that are coarse there: steps that are shorter than a place of a
/// position is long must not make them drift into each other (by half a radius and more).
#[test]
fn slow_grains_do_not_drift_into_each_other() {
    for (number, seed, most) in [(Number::F32, 1296, 200), (Number::I16f16, 835, 30)] {
        let (_, report) = heaps::run(seed, most, number);
        assert!(!matches!(report.ended, Ended::Broken(_)), "{:?}", report.ended);
        assert!(report.deepest < 0.02, "{number:?}: {}", report.deepest);
    }
}

/// A light grain under a column, pressed so deep into a hard floor that ω of the stand-in and the steps in a contact
/// have no product in 16 binary digits: the step never ended, and grains flew under the force of a contact.
#[test]
fn a_step_ends_even_if_its_contact_is_too_short_for_a_number() {
    let (_, report) = heaps::run(1652, 30, Number::I16f16);
    assert!(!matches!(report.ended, Ended::Broken(_)), "{:?}", report.ended);
    assert!(report.deepest < 0.1, "{}", report.deepest);
}
