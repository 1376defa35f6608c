//! What happens when a user changes grains between events? Sets velocities, adds and removes; compares with worlds that began so.

use crate::gas::{damped_spring, gas};
use carom::law::{HardSphere, Outside, Rule, Soft};
use carom::particle::Body;
use carom::world::{Motion, ScheduledEvent, Snapshot};
use carom::{Enduring, Error, Grain, HeapMemory, World};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

const SIDE: f64 = 12.0;

fn soft() -> impl Rule<f64> + Copy {
    Soft::linear_dashpot(damped_spring::<f64>(), Outside::HardSphere)
}

/// What a world of changes is like: how it finds neighbours, in which mode it is, and how grains fall.
#[derive(Clone, Copy, Debug)]
struct Scene {
    heads: usize,
    enduring: Enduring,
    gravity: f64,
}

/// After some of many events something is changed. Returns the digests after each change.
fn changed<R: Rule<f64> + Copy>(scene: Scene, rule: R, seed: u64) -> Vec<u64> {
    let mut memory = HeapMemory::with_capacity(60).with_cells(scene.heads);
    let mut world = World::builder(&mut memory)
        .enduring(scene.enduring)
        .hard_walls([[0.0, SIDE]; 2], 0.9)
        .gravity([0.0, -scene.gravity])
        .rule(rule)
        .grains(gas::<f64, 2>(50, seed, SIDE, [0.2, 0.4]))
        .unwrap()
        .reserve(10)
        .unwrap()
        .start()
        .unwrap();
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let mut digests = Vec::new();
    for turn in 1..=200 {
        world.advance_to(0.05 * f64::from(turn)).unwrap();
        let i = rng.random_range(0..60);
        let at = [0; 2].map(|_| rng.random_range(0.3..SIDE - 0.3));
        let v = [0; 2].map(|_| rng.random_range(-2.0..2.0));
        match (turn % 3, world.grain(i)) {
            (0, Some(_)) => world.set_velocity(i, v).unwrap(),
            (1, Some(before)) => {
                let taken = world.remove(i).unwrap();
                assert_eq!((taken.radius, taken.mass), (before.radius, before.mass));
                assert!(world.grain(i).is_none() && world.remove(i).is_err());
            }
            _ => match world.add(Grain::with_mass(0.2, 1.0).at(at).moving(v)) {
                Ok(place) => assert_eq!(world.grain(place).unwrap().radius, 0.2),
                Err(Error::Overlap { .. } | Error::Full { .. }) => {}
                Err(other) => panic!("{other}"),
            },
        }
        digests.push(world.digest());
        let again = through_a_snapshot(&mut world, rule, 0.05 * f64::from(turn) + 0.02);
        assert_eq!(again[0], again[1], "turn {turn}");
    }
    let inside = |x: &f64| *x > 0.0 && *x < SIDE;
    assert!((0..60).filter_map(|i| world.grain(i)).all(|g| g.position.iter().all(inside)));
    digests
}

/// The digests of this world and of one restored from what it saves, both at this time.
fn through_a_snapshot<R: Rule<f64> + Copy>(
    world: &mut World<'_, f64, 2, R>,
    rule: R,
    time: f64,
) -> [u64; 2] {
    let text = serde_json::to_string(&world.save()).unwrap();
    let saved: Snapshot<f64, 2, Vec<Body<f64, 2>>, Vec<ScheduledEvent<f64>>> =
        serde_json::from_str(&text).unwrap();
    let mut memory = HeapMemory::with_capacity(60);
    let mut again = World::restore(&mut memory, rule, &saved).unwrap();
    world.advance_to(time).unwrap();
    again.advance_to(time).unwrap();
    [world.digest(), again.digest()]
}

#[test]
fn changes_have_the_same_bits_however_neighbours_are_found() {
    for (enduring, gravity) in
        [(Enduring::Paper, 0.0), (Enduring::Paper, 1.0), (Enduring::Integrated, 1.0)]
    {
        let scene = |heads| Scene { heads, enduring, gravity };
        for seed in 0..3 {
            let all_pairs = changed(scene(0), soft(), seed);
            assert_eq!(changed(scene(120), soft(), seed), all_pairs, "{enduring:?}, {gravity}");
            let hard = HardSphere { restitution: 0.8 };
            let all_pairs = changed(scene(0), hard, seed);
            assert_eq!(changed(scene(120), hard, seed), all_pairs, "hard, {enduring:?}, {gravity}");
        }
    }
}

/// A world changed at the first instant goes on as one that was built so.
#[test]
fn a_world_changed_at_the_start_is_one_built_so() {
    let grains = gas::<f64, 2>(50, 3, SIDE, [0.2, 0.4]);
    let run = |built: bool| {
        let mut memory = HeapMemory::with_capacity(50);
        let builder = World::builder(&mut memory).hard_walls([[0.0, SIDE]; 2], 0.9).rule(soft());
        let mut world = if built {
            builder.grains(grains.iter().copied()).unwrap().start().unwrap()
        } else {
            let at_rest = grains[..40].iter().map(|grain| grain.moving([0.0; 2]));
            let builder = builder.grains(at_rest).unwrap().reserve(10).unwrap();
            let mut world = builder.start().unwrap();
            for (i, grain) in grains[..40].iter().enumerate() {
                world.set_velocity(i, grain.velocity.into()).unwrap();
            }
            for (i, grain) in grains.iter().enumerate().skip(40) {
                let added = world.add(*grain);
                assert_eq!(added, Ok(i));
            }
            world
        };
        world.advance_to(30.0).unwrap();
        (0..50).map(|i| world.grain(i).unwrap()).collect::<Vec<_>>()
    };
    assert_eq!(run(true), run(false));
}

/// Grains of a heap that has fallen asleep, one in each of three layers.
fn heap(
    rule: impl Rule<f64>,
    enduring: Enduring,
    change: impl Fn(&mut World<'_, f64, 1, &dyn Rule<f64>>),
) {
    let mut memory = HeapMemory::with_capacity(3);
    let rule: &dyn Rule<f64> = &rule;
    let mut world = World::builder(&mut memory)
        .enduring(enduring)
        .hard_walls([[0.0, 20.0]], 0.5)
        .gravity([-1.0])
        .rule(rule)
        .grains((0..3).map(|i| Grain::with_mass(0.5, 1.0).at([0.6 + 1.1 * f64::from(i)])))
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(100.0).unwrap();
    assert!((0..3).all(|i| world.view().motion(i) == Some(Motion::Rest)), "{:?}", world.view());
    change(&mut world);
}

/// Who lay on a grain that is taken away falls, and lies on what is left.
#[test]
fn who_lay_on_a_grain_that_is_gone_falls() {
    for enduring in [Enduring::Paper, Enduring::Integrated] {
        heap(HardSphere { restitution: 0.5 }, enduring, |world| {
            world.remove(0).unwrap();
            world.advance_to(200.0).unwrap();
            let height = |i: usize| world.grain(i).unwrap().position[0];
            assert!((height(1) - 0.5).abs() < 0.05, "{enduring:?}: {}", height(1));
            assert!((height(2) - 1.5).abs() < 0.05, "{enduring:?}: {}", height(2));
            assert!((1..3).all(|i| world.view().motion(i) == Some(Motion::Rest)));
        });
    }
}

/// A sleeping grain that is kicked flies: thrown up from rest at speed v it is v² / 2g higher at v / g.
#[test]
fn a_sleeper_that_is_kicked_flies_as_far_as_it_must() {
    for enduring in [Enduring::Paper, Enduring::Integrated] {
        heap(HardSphere { restitution: 0.5 }, enduring, |world| {
            let before = world.grain(2).unwrap().position[0];
            world.set_velocity(2, [3.0]).unwrap();
            world.advance_to(103.0).unwrap();
            let top = world.grain(2).unwrap();
            assert!((top.position[0] - before - 4.5).abs() < 0.02, "{enduring:?}: {top:?}");
            assert!(top.velocity[0].abs() < 0.02, "{enduring:?}: {top:?}");
        });
    }
}

#[test]
fn what_cannot_be_changed_is_refused_and_named() {
    let mut memory = HeapMemory::with_capacity(3);
    let mut world = World::builder(&mut memory)
        .periodic([[0.0, SIDE]; 2])
        .rule(HardSphere { restitution: 1.0 })
        .grains([Grain::with_mass(0.5, 1.0), Grain::with_mass(0.5, 1.0).at([3.0, 0.0])])
        .unwrap()
        .reserve(1)
        .unwrap()
        .start()
        .unwrap();
    let before = world.digest();
    let said = [
        world.set_velocity(2, [0.0; 2]).unwrap_err(),
        world.set_velocity(0, [f64::NAN, 0.0]).unwrap_err(),
        world.set_velocity(1, [1e200, 0.0]).unwrap_err(),
        world.remove(7).unwrap_err(),
        world.add(Grain::with_mass(0.6, 1.0).at([6.0, 6.0])).unwrap_err(),
        world.add(Grain::with_mass(-0.1, 1.0).at([6.0, 6.0])).unwrap_err(),
        world.add(Grain::with_mass(0.5, 1.0).at([12.5, 0.5])).unwrap_err(),
    ];
    let said: Vec<String> = said.iter().map(ToString::to_string).collect();
    for (text, wanted) in said.iter().zip([
        "grain 2: number",
        "grain 0: velocity",
        "grain 1: velocity",
        "grain 7: number",
        "grain 2: radius is 0.6",
        "grain 2: radius is -0.1",
        "grain 2 and grain 0 overlap",
    ]) {
        assert!(text.contains(wanted), "{text:?} for {wanted:?}");
    }
    assert_eq!(world.digest(), before);
    world.add(Grain::with_mass(0.5, 1.0).at([6.0, 6.0])).unwrap();
    let full = world.add(Grain::with_mass(0.5, 1.0).at([9.0, 9.0])).unwrap_err();
    assert!(matches!(full, Error::Full { .. }) && full.to_string().contains("reserve"), "{full}");
}
