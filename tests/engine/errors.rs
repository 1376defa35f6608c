//! Does bad input get an error that names the field, and never a panic? Tries everything; reads the errors.

use crate::gas::damped_spring;
use carom::error::Subject;
use carom::law::{HardSphere, LinearDashpot, Outside, Soft, Viscoelastic};
use carom::space::{Plane, Surface};
use carom::{Error, Grain, Memory, World};
use proptest::prelude::*;

const ELASTIC: HardSphere<f64> = HardSphere { restitution: 1.0 };

fn field_of<T>(result: Result<T, Error>) -> (Subject, &'static str) {
    match result {
        Err(Error::Input { subject, field, .. }) => (subject, field),
        Err(other) => panic!("another error: {other}"),
        Ok(_) => panic!("no error"),
    }
}

#[test]
fn a_bad_grain_is_named_with_its_field() {
    let ok = Grain::with_mass(1.0, 1.0);
    let bad = [
        (Grain::with_mass(-1.0, 1.0), "radius"),
        (Grain::with_mass(1.0, 0.0), "mass"),
        (Grain::with_mass(1.0, f64::INFINITY), "mass"),
        (ok.at([0.0, f64::NAN]), "position"),
        (ok.moving([f64::INFINITY, 0.0]), "velocity"),
    ];
    for (grain, field) in bad {
        let mut memory = Memory::<f64, 2, 4>::new();
        let builder = World::builder(&mut memory).rule(ELASTIC).grain(ok.at([9.0, 9.0])).unwrap();
        assert_eq!(field_of(builder.grain(grain)), (Subject::Grain(1), field));
    }
}

type TestBuilder<'m> = carom::world::WorldBuilder<'m, f64, 1, carom::world::NoRule>;

fn start(f: impl FnOnce(TestBuilder<'_>) -> Result<(), Error>) -> Result<(), Error> {
    let mut memory = Memory::<f64, 1, 2>::new();
    f(World::builder(&mut memory))
}

#[test]
fn bad_boundaries_gravity_and_laws_are_named() {
    let with = |law| Soft::linear_dashpot(law, Outside::Clamp);
    let rubber = Viscoelastic { young: 1e6, poisson: 0.4, dissipation: 0.0 };
    let cases: [(Result<(), Error>, Subject, &str); 8] = [
        (
            start(|s| s.gravity([f64::NAN]).rule(ELASTIC).start().map(drop)),
            Subject::World,
            "gravity",
        ),
        (
            start(|s| s.periodic([[1.0, 0.0]]).rule(ELASTIC).start().map(drop)),
            Subject::Axis(0),
            "length",
        ),
        (
            start(|s| s.hard_walls([[0.0, 1.0]], 1.5).rule(ELASTIC).start().map(drop)),
            Subject::Plane(0),
            "restitution",
        ),
        (
            start(|s| s.rule(HardSphere { restitution: -0.1 }).start().map(drop)),
            Subject::Rule,
            "restitution",
        ),
        (
            start(|s| {
                s.rule(with(LinearDashpot { stiffness: 0.0, damping: 0.0 })).start().map(drop)
            }),
            Subject::Rule,
            "stiffness",
        ),
        (
            start(|s| {
                s.rule(with(LinearDashpot { stiffness: 1.0, damping: -1.0 })).start().map(drop)
            }),
            Subject::Rule,
            "damping",
        ),
        (
            start(|s| {
                s.rule(Soft::viscoelastic(Viscoelastic { poisson: 0.6, ..rubber }, Outside::Clamp))
                    .start()
                    .map(drop)
            }),
            Subject::Rule,
            "poisson",
        ),
        (
            start(|s| {
                s.plane(Plane {
                    normal: [2.0].into(),
                    offset: 0.0,
                    surface: Surface::Rule,
                    vibration: None,
                    drift: None,
                })
                .rule(ELASTIC)
                .start()
                .map(drop)
            }),
            Subject::Plane(0),
            "normal's length squared",
        ),
    ];
    for (result, subject, field) in cases {
        assert_eq!(field_of(result), (subject, field));
    }
}

#[test]
fn a_full_world_names_the_knob() {
    let mut memory = Memory::<f32, 2, 1>::new();
    let builder = World::builder(&mut memory).grain(Grain::with_mass(1.0, 1.0)).unwrap();
    let Err(error) = builder.grain(Grain::with_mass(1.0, 1.0)) else { panic!() };
    assert!(matches!(error, Error::Full { capacity: 1, .. }));
    assert!(error.to_string().contains("N of Memory"), "{error}");
}

#[test]
fn overlapping_and_coincident_grains_are_refused() {
    for x in [0.0, 0.5] {
        let mut memory = Memory::<f64, 2, 2>::new();
        let grain = Grain::with_mass(0.5, 1.0);
        let builder =
            World::builder(&mut memory).rule(ELASTIC).grains([grain, grain.at([x, 0.0])]).unwrap();
        let Err(Error::Overlap { grain: 1, gap, .. }) = builder.start() else { panic!() };
        assert_eq!(gap, x - 1.0);
    }
}

#[test]
fn grains_that_just_touch_are_accepted() {
    let mut memory = Memory::<f64, 1, 2>::new();
    let grain = Grain::with_mass(0.5, 1.0);
    World::builder(&mut memory)
        .rule(ELASTIC)
        .grains([grain, grain.at([1.0])])
        .unwrap()
        .start()
        .unwrap();
}

#[test]
fn an_empty_world_has_no_future() {
    let mut memory = Memory::<f64, 3, 4>::new();
    let mut world = World::builder(&mut memory).rule(ELASTIC).start().unwrap();
    assert!(world.step().unwrap().is_none() && world.next_event_time().is_none());
    world.advance_to(1.0e9).unwrap();
    assert!(matches!(world.advance_to(1.0), Err(Error::Past { .. })));
}

fn any_number() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -2.0..2.0_f64,
        1 => any::<f64>(),
        1 => Just(0.0),
        1 => prop::num::f64::SUBNORMAL,
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    /// Whatever a user describes, the result is a world or an error, and whatever a world does it does in
    /// bounded time, forward, with finite numbers.
    #[test]
    fn nothing_panics_hangs_or_makes_a_nan(
        grains in prop::collection::vec((any_number(), any_number(), any_number(), any_number(), any_number(), any_number()), 0..5),
        gravity in (any_number(), any_number()),
        later in (any_number(), any_number()),
        side in any_number(),
        periodic in any::<bool>(),
        hard in any::<bool>(),
        law in (any_number(), any_number()),
    ) {
        let mut memory = Memory::<f64, 2, 4>::new();
        let builder = World::builder(&mut memory).gravity([gravity.0, gravity.1]);
        let sides = [[-side, side]; 2];
        let builder = if periodic { builder.periodic(sides) } else if hard { builder.hard_walls(sides, 0.9) } else { builder.walls(sides) };
        let law = LinearDashpot { stiffness: law.0.abs() * 1e4, damping: law.1 };
        let builder = builder.rule(Soft::linear_dashpot(law, Outside::Clamp)).grains(
            grains.iter().map(|g| Grain::with_mass(g.0.abs() * 0.3, g.1).at([g.2, g.3]).moving([g.4, g.5])));
        let Ok(builder) = builder else { return Ok(()) };
        let Ok(mut world) = builder.start() else { return Ok(()) };
        let mut last = world.now();
        for n in 0..300 {
            if n == 150 { let _ = world.set_gravity([later.0, later.1]); }
            match world.step() {
                Ok(Some(h)) => { prop_assert!(h.at >= last); last = h.at; }
                Ok(None) => break,
                Err(error) => { prop_assert!(!error.to_string().is_empty()); break; }
            }
            for i in 0..grains.len() {
                let g = world.grain(i).unwrap();
                prop_assert!(g.position.iter().chain(g.velocity.iter()).all(|x| !x.is_nan()));
            }
        }
    }
}

#[test]
fn f32_and_one_dimension_take_the_same_rules() {
    let mut memory = Memory::<f32, 1, 3>::new();
    let mut world = World::builder(&mut memory)
        .walls([[0.0, 1.0]])
        .rule(Soft::linear_dashpot(damped_spring::<f32>(), Outside::HardSphere))
        .grains((0..3_u8).map(|i| {
            Grain::with_mass(0.05, 1.0).at([0.2 + 0.3 * f32::from(i)]).moving([1.0 - f32::from(i)])
        }))
        .unwrap()
        .start()
        .unwrap();
    for _ in 0..1000 {
        world.step().unwrap();
    }
}
