//! What happens where a fixed-point number ends? Worlds too large, too fast or too late; compares errors and times.

use carom::law::{HardSphere, Outside, Soft, Viscoelastic};
use carom::scalar::{I16F16, I32F32};
use carom::space::{Plane, Surface};
use carom::{Error, Grain, Instant, Memory, World};

use crate::fixed::{n, rubber};

/// The quantity that an error names.
fn named(error: &Error) -> &'static str {
    match error {
        Error::Overflow { quantity, .. } => quantity,
        other => panic!("{other}"),
    }
}

#[test]
fn what_does_not_fit_is_named_with_the_unit_to_choose() {
    let start = |grain: Grain<I32F32, 1>, rule: Viscoelastic<I32F32>, wall: f64| {
        let mut memory = Memory::<I32F32, 1, 2>::new();
        let mut world = World::builder(&mut memory)
            .plane(Plane::new([n(1.0)], n(wall), Surface::Rule))
            .gravity([n(-9.81)])
            .rule(Soft::viscoelastic(rule, Outside::HardSphere))
            .grain(grain)?
            .start()?;
        for _ in 0..100 {
            world.step()?;
        }
        Ok(())
    };
    let grain = Grain::with_mass(n(1.0), n(1.0));
    let falls = grain.at([n(2.0)]);
    assert_eq!(start(falls, rubber(), 0.0), Ok(()));
    let cases = [
        (falls.moving([n(3e8)]), rubber(), "velocity", "larger unit of length"),
        (grain.at([n(1e12)]), rubber(), "position", "larger unit of length"),
        (Grain::with_mass(n(1.0), n(4e9)).at([n(2.0)]), rubber(), "mass", "larger unit of mass"),
        (falls, Viscoelastic { young: n(5e9), ..rubber() }, "young", "smaller unit of time"),
        (
            Grain::with_mass(n(1.0), n(1e-3)).at([n(2.0)]),
            Viscoelastic { young: n(2e9), ..rubber() },
            "stiffness over mass",
            "smaller unit of time",
        ),
    ];
    for (grain, rule, quantity, unit) in cases {
        let error: Error = start(grain, rule, 0.0).unwrap_err();
        let text = error.to_string();
        assert_eq!(named(&error), quantity, "{text}");
        assert!(text.contains(unit), "{text}");
    }
}

#[test]
fn a_grain_that_leaves_the_range_is_an_error_not_a_wrap() {
    let mut memory = Memory::<I16F16, 2, 1>::new();
    let mut world = World::builder(&mut memory)
        .gravity([n(0.0), n(-0.01)])
        .rule(HardSphere { restitution: n(1.0) })
        .grain(Grain::with_mass(n(1.0), n(1.0)).moving([n(0.5), n(0.0)]))
        .unwrap()
        .start()
        .unwrap();
    // y = −t²/200 is −4096, an eighth of the range, at t = 905.
    let error = (1..100).find_map(|k| world.advance_to(n::<I16F16>(50.0 * f64::from(k))).err());
    let error = error.unwrap();
    assert_eq!(named(&error), "position", "{error}");
    let now = world.now().as_f64();
    assert!(now > 900.0 && now < 2_600.0, "{now}");
}

#[test]
fn a_collision_far_beyond_the_clock_s_range_happens_at_its_time() {
    // One step of speed is 2⁻¹⁶, so a gap of 3 takes 196,608 units, six times what the clock can count.
    let mut memory = Memory::<I16F16, 1, 2>::new();
    let mut world = World::builder(&mut memory)
        .rule(HardSphere { restitution: n(1.0) })
        .grain(Grain::with_mass(n(1.0), n(1.0)).moving([I16F16::DELTA]))
        .unwrap()
        .grain(Grain::with_mass(n(1.0), n(1.0)).at([n(5.0)]))
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(Instant::from(196_600.0_f64)).unwrap();
    assert_eq!(world.statistics().collisions, 0);
    world.advance_to(Instant::from(196_616.0_f64)).unwrap();
    assert_eq!(world.statistics().collisions, 1, "{:?}", world.statistics());
}

#[test]
fn a_world_at_rest_can_wait_for_ever() {
    let mut memory = Memory::<I32F32, 1, 1>::new();
    let mut world = World::builder(&mut memory)
        .rule(HardSphere { restitution: n(1.0) })
        .grain(Grain::with_mass(n(1.0), n(1.0)))
        .unwrap()
        .start()
        .unwrap();
    assert_eq!(world.next_event_time(), None);
    world.advance_to(Instant::from(1e12_f64)).unwrap();
    assert_eq!(world.now(), Instant::from(1e12_f64));
}
