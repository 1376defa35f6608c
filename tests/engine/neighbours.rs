//! Does it matter how neighbours are found? Runs worlds with cells and with all pairs; compares digests.

use super::gas::{damped_spring, elastic_spring, gas, rubber};
use carom::law::{HardSphere, Outside, Rule, Soft};
use carom::space::{Plane, Surface, Vibration};
use carom::{Enduring, Grain, HeapMemory, Scalar, World};

/// A scene in which neighbours can be found in different ways.
struct Scene<S: Scalar, const D: usize> {
    grains: Vec<Grain<S, D>>,
    side: S,
    periodic: bool,
    gravity: [S; D],
}

/// The digest after every thousandth event, and how often a grain has left its cell.
fn digests<S: Scalar, const D: usize, R: Rule<S>>(
    scene: &Scene<S, D>,
    rule: R,
    heads: usize,
    events: u64,
) -> (Vec<u64>, u64) {
    let mut memory = HeapMemory::<S, D>::with_capacity(scene.grains.len()).with_cells(heads);
    let builder = World::builder(&mut memory).gravity(scene.gravity).rule(rule);
    let sides = [[S::zero(), scene.side]; D];
    let builder = if scene.periodic { builder.periodic(sides) } else { builder.walls(sides) };
    let mut world = builder.grains(scene.grains.iter().copied()).unwrap().start().unwrap();
    let mut digests = Vec::new();
    while world.statistics().events() < events {
        if world.statistics().events() >= 1_000 * digests.len() as u64 {
            digests.push(world.digest());
        }
        world.step().unwrap();
    }
    (digests, world.statistics().cell_crossings)
}

fn same<S: Scalar, const D: usize, R: Rule<S> + Copy>(scene: &Scene<S, D>, rule: R, events: u64) {
    let n = scene.grains.len();
    let (all_pairs, looks) = digests(scene, rule, 0, events);
    for heads in [2 * n, n / 2] {
        let (cells, crossings) = digests(scene, rule, heads, events);
        assert_ne!(crossings, looks, "the cells are not used");
        let first = cells.iter().zip(&all_pairs).position(|(a, b)| a != b);
        assert_eq!(first, None, "{heads} cells, D = {D}");
    }
}

/// A gas of 200 grains in a periodic box or between walls, with gravity or without.
fn scene<S: Scalar, const D: usize>(side: f64, periodic: bool, g: f64) -> Scene<S, D> {
    let mut gravity = [S::zero(); D];
    gravity[D - 1] = S::from_f64(-g);
    Scene { grains: gas(200, 7, side, [0.35, 0.5]), side: S::from_f64(side), periodic, gravity }
}

#[test]
fn cells_and_all_pairs_give_the_same_bits_over_a_hundred_thousand_events() {
    same(&scene::<f64, 3>(9.0, true, 0.0), HardSphere { restitution: 1.0 }, 100_000);
}

/// Just beyond the end of such a box numbers are twice as coarse as in it.
#[test]
fn the_same_holds_in_a_box_just_shorter_than_a_power_of_two() {
    same(&scene::<f64, 2>(31.999, true, 0.0), HardSphere { restitution: 0.99 }, 5_000);
    same(&scene::<f32, 2>(31.99, true, 0.0), HardSphere { restitution: 0.99 }, 5_000);
}

#[test]
fn the_same_holds_for_soft_grains_for_gravity_and_for_single_precision() {
    let elastic = Soft::linear_dashpot(elastic_spring(), Outside::HardSphere);
    same(&scene::<f64, 3>(12.0, true, 0.0), elastic, 10_000);
    let damped = Soft::linear_dashpot(damped_spring(), Outside::HardSphere);
    same(&scene::<f64, 2>(40.0, true, 0.0), damped, 10_000);
    same(&scene::<f64, 2>(40.0, false, 0.1), HardSphere { restitution: 1.0 }, 10_000);
    let soft = Soft::viscoelastic(rubber(), Outside::HardSphere);
    same(&scene::<f32, 3>(14.0, true, 0.0), soft, 10_000);
}

/// Beads over a vibrating plate, in flight, on each other, and carried.
fn shaken<const D: usize>(
    heads: usize,
    (epsilon, seed): (f64, u64),
    enduring: Enduring,
) -> Vec<u64> {
    const SIDE: f64 = 16.0e-3;
    let grains = gas::<f64, D>(10, seed, SIDE, [0.5e-3, 0.6e-3]);
    let mut memory = HeapMemory::<f64, D>::with_capacity(10).with_cells(heads);
    let mut sides = [[0.0, SIDE]; D];
    sides[D - 1] = [-1.0e-3, 3.0 * SIDE];
    let mut up = [0.0; D];
    up[D - 1] = 1.0;
    let plate = Plane::new(up, 0.0, Surface::Hard(epsilon)).vibrating(Vibration::new(0.1e-3, 60.0));
    let mut world = World::builder(&mut memory)
        .enduring(enduring)
        .hard_walls(sides, epsilon)
        .plane(plate)
        .gravity(up.map(|n| -9.81 * n))
        .rule(HardSphere { restitution: epsilon })
        .grains(grains)
        .unwrap()
        .start()
        .unwrap();
    let mut digests = Vec::new();
    let mut events = 0;
    while digests.len() < 100 {
        if world.step().unwrap().unwrap().kind.is_bookkeeping() {
            continue;
        }
        events += 1;
        if events % 20 == 0 {
            digests.push(world.digest());
        }
    }
    let [collisions, steps] = [world.statistics().collisions, world.statistics().steps];
    assert!(collisions > 10, "{collisions}");
    assert_eq!(steps > 100, enduring == Enduring::Integrated, "{steps}");
    digests
}

#[test]
fn the_size_of_cells_changes_no_bit_over_a_vibrating_plate() {
    let modes = [Enduring::Paper, Enduring::Integrated];
    let cases = [(0.9, 1), (0.5, 2), (0.7, 3)];
    for (case, mode) in cases.into_iter().flat_map(|case| modes.map(|mode| (case, mode))) {
        let [one, two] = [shaken::<1>, shaken::<2>].map(|shaken| {
            let all_pairs = shaken(0, case, mode);
            [3, 10, 40, 160].map(|heads| {
                shaken(heads, case, mode).iter().zip(&all_pairs).position(|(a, b)| a != b)
            })
        });
        assert_eq!((one, two), ([None; 4], [None; 4]), "{case:?} {mode:?}");
    }
}
