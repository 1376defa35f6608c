//! Does it matter in which cells grains of many sizes are listed? Runs worlds with levels of cells and with all pairs; compares digests.

use super::gas::{damped_spring, elastic_spring};
use carom::law::{HardSphere, Outside, Rule, Soft};
use carom::scalar::{I32F32, Real};
use carom::{Grain, HeapMemory, Scalar, World};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// Grains at random places without overlap: of each radius as many as are given, the largest first.
struct Scene<S: Scalar, const D: usize> {
    grains: Vec<Grain<S, D>>,
    side: f64,
    periodic: bool,
    gravity: f64,
}

fn scene<S: Scalar, const D: usize>(
    side: f64,
    sizes: &[(f64, usize)],
    (periodic, gravity): (bool, f64),
) -> Scene<S, D> {
    let mut rng = Pcg64Mcg::seed_from_u64(sizes.len() as u64 + D as u64);
    let mut placed: Vec<([f64; D], f64)> = Vec::new();
    for &(radius, count) in sizes {
        let mut tries = 0;
        while placed.iter().filter(|(_, r)| *r == radius).count() < count {
            let at: [f64; D] =
                std::array::from_fn(|_| rng.random_range(1.01 * radius..side - 1.01 * radius));
            let clear = placed.iter().all(|(x, r)| {
                let square: f64 = x.iter().zip(&at).map(|(a, b)| (a - b) * (a - b)).sum();
                square.sqrt() > 1.02 * (r + radius)
            });
            if clear {
                placed.push((at, radius));
            }
            tries += 1;
            assert!(tries < 1_000_000, "no room for {count} grains of radius {radius}");
        }
    }
    // In any order: where a grain is listed does not depend on its number.
    for i in (1..placed.len()).rev() {
        placed.swap(i, rng.random_range(0..=i));
    }
    let grains = placed.iter().map(|&(at, radius)| {
        let speed = (0.1 / radius).powf(D as f64 / 2.0);
        let velocity = std::array::from_fn(|_| S::from_f64(speed * rng.random_range(-1.0..1.0)));
        let mass = S::from_f64((radius / 0.1).powi(D as i32));
        Grain::with_mass(S::from_f64(radius), mass).at(at.map(S::from_f64)).moving(velocity)
    });
    Scene { grains: grains.collect(), side, periodic, gravity }
}

/// The digest after each so many events, and how many levels there were.
fn digests<S: Scalar, const D: usize>(
    scene: &Scene<S, D>,
    rule: impl Rule<S>,
    heads: usize,
    events: u64,
) -> (Vec<u64>, usize) {
    let mut memory = HeapMemory::<S, D>::with_capacity(scene.grains.len()).with_cells(heads);
    let mut gravity = [S::zero(); D];
    gravity[D - 1] = S::from_f64(-scene.gravity);
    let builder = World::builder(&mut memory).gravity(gravity).rule(rule);
    let sides = [[S::zero(), S::from_f64(scene.side)]; D];
    let builder = if scene.periodic { builder.periodic(sides) } else { builder.walls(sides) };
    let mut world = builder.grains(scene.grains.iter().copied()).unwrap().start().unwrap();
    let (mut digests, mut visible) = (Vec::new(), 0);
    while visible < events {
        let Some(event) = world.step().unwrap() else { break };
        if event.kind.is_bookkeeping() {
            continue;
        }
        visible += 1;
        if visible % (events / 50) == 0 {
            digests.push(world.digest());
        }
    }
    (digests, world.searches().levels)
}

fn same<S: Scalar, const D: usize>(
    scene: &Scene<S, D>,
    rule: impl Rule<S> + Copy,
    events: u64,
    levels: usize,
) {
    let n = scene.grains.len();
    let (all_pairs, none) = digests(scene, rule, 0, events);
    let (cells, found) = digests(scene, rule, 4 * n, events);
    assert_eq!((none, found), (0, levels), "levels, D = {D}");
    let first = cells.iter().zip(&all_pairs).position(|(a, b)| a != b);
    assert_eq!((first, cells.len()), (None, all_pairs.len()), "D = {D}");
}

const PERIODIC: (bool, f64) = (true, 0.0);

/// Two sizes, one tenth and one: few large grains among many small ones.
fn two<S: Scalar, const D: usize>(side: f64, [large, small]: [usize; 2]) -> Scene<S, D> {
    scene(side, &[(1.0, large), (0.1, small)], PERIODIC)
}

#[test]
fn levels_and_all_pairs_give_the_same_bits_in_a_gas() {
    let hard = |epsilon| HardSphere { restitution: epsilon };
    same(&two::<f64, 1>(80.0, [10, 200]), hard(1.0), 20_000, 2);
    same(&two::<f64, 2>(16.0, [10, 400]), hard(0.99), 20_000, 2);
    same(&two::<f64, 3>(10.0, [10, 800]), hard(1.0), 20_000, 2);
}

#[test]
fn the_same_holds_for_single_precision_and_for_fixed_point() {
    same(&two::<f32, 2>(16.0, [10, 400]), HardSphere { restitution: 1.0 }, 10_000, 2);
    let rule = HardSphere { restitution: I32F32::from_f64(0.9) };
    same(&two::<I32F32, 2>(16.0, [10, 400]), rule, 5_000, 2);
}

#[test]
fn the_same_holds_for_soft_grains_and_for_many_sizes() {
    let sizes = [(2.0, 2), (0.9, 5), (0.4, 20), (0.2, 60), (0.1, 300), (0.05, 300)];
    let elastic = Soft::linear_dashpot(elastic_spring(), Outside::HardSphere);
    same(&scene::<f64, 2>(20.0, &sizes, PERIODIC), elastic, 10_000, 4);
    let damped = Soft::linear_dashpot(damped_spring(), Outside::HardSphere);
    same(&scene::<f64, 3>(10.0, &sizes[1..], PERIODIC), damped, 5_000, 2);
}

/// Between walls, under gravity, until they lie: clusters and sleep, too.
#[test]
fn the_same_holds_where_grains_heap_up() {
    let sizes = [(1.0, 3), (0.4, 6), (0.1, 60)];
    let heap = scene::<f64, 2>(8.0, &sizes, (false, 1.0));
    same(&heap, HardSphere { restitution: 0.5 }, 30_000, 2);
    let soft = Soft::linear_dashpot(damped_spring(), Outside::HardSphere);
    same(&heap, soft, 30_000, 2);
}

/// What memory has no room for is left out, which one can read; and nothing else changes.
#[test]
fn with_little_memory_there_are_fewer_levels_or_none() {
    let scene = two::<f64, 2>(16.0, [10, 400]);
    let rule = HardSphere { restitution: 1.0 };
    let (all_pairs, _) = digests(&scene, rule, 0, 2_000);
    for (heads, levels) in [(400, 2), (100, 2), (60, 1), (9, 0)] {
        let (cells, found) = digests(&scene, rule, heads, 2_000);
        assert_eq!((found, cells == all_pairs), (levels, true), "{heads}");
    }
}

#[test]
fn a_world_with_levels_goes_on_after_it_was_saved() {
    let scene = two::<f64, 2>(16.0, [10, 400]);
    let rule = HardSphere { restitution: 1.0 };
    let mut memory = HeapMemory::<f64, 2>::with_capacity(scene.grains.len());
    let builder = World::builder(&mut memory).periodic([[0.0, scene.side]; 2]).rule(rule);
    let mut world = builder.grains(scene.grains.iter().copied()).unwrap().start().unwrap();
    for _ in 0..5_000 {
        world.step().unwrap();
    }
    let saved = world.save();
    let mut second = HeapMemory::<f64, 2>::with_capacity(scene.grains.len());
    let mut restored = World::restore(&mut second, rule, &saved).unwrap();
    assert_eq!(restored.searches().levels, 2);
    for _ in 0..5_000 {
        restored.step().unwrap();
    }
    let there = restored.digest();
    drop(restored);
    for _ in 0..5_000 {
        world.step().unwrap();
    }
    assert_eq!(world.digest(), there);
}

/// A small soft grain touches a large one, and a second one is so fast towards the large one from behind that it
/// crowds them; it is in a cell that the first one does not look into. However neighbours are found, forces decide.
#[test]
fn who_crowds_the_larger_of_two_is_seen() {
    let rule = Soft::linear_dashpot(damped_spring(), Outside::HardSphere);
    // At some of these places of the large grain the two that touch are in one cell.
    for shift in 0..40 {
        let x = 8.0 + 0.05 * f64::from(shift);
        let mut scene = two::<f64, 2>(24.0, [0, 900]);
        let is_far =
            |grain: &Grain<f64, 2>| (grain.position[0] - x).hypot(grain.position[1] - 12.0) > 2.5;
        scene.grains.retain(is_far);
        let grain = |radius, mass, dx: f64, v: f64| {
            Grain::with_mass(radius, mass).at([x + dx, 12.0]).moving([v, 0.0])
        };
        let second = grain(0.1, 1.0, -1.46, 20.0);
        let three = [grain(0.1, 1.0, 1.1005, -1.0), grain(1.0, 100.0, 0.0, 0.0), second];
        scene.grains.splice(0..0, three);
        let run = |heads| digests(&scene, rule, heads, 100).0;
        assert!(run(4 * scene.grains.len()) == run(0), "{x}");
    }
}
