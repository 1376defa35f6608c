//! Does it matter how the next event is found? Runs worlds with a calendar of events and with the tree alone; compares digests.

use super::gas::{damped_spring, gas};
use carom::law::{HardSphere, Outside, Rule, Soft};
use carom::space::{Plane, Surface, Vibration};
use carom::world::Buffers;
use carom::{Enduring, Grain, HeapMemory, Storage, World};

/// Memory that lends no calendar.
struct TreeAlone<const D: usize>(HeapMemory<f64, D>);

impl<const D: usize> Storage<f64, D> for TreeAlone<D> {
    fn buffers(&mut self) -> Buffers<'_, f64, D> {
        Buffers { calendar: &mut [], ..self.0.buffers() }
    }
}

/// Grains in a box: periodic, or on a plate that vibrates, between walls.
struct Scene<const D: usize> {
    grains: Vec<Grain<f64, D>>,
    side: f64,
    plate: Option<Vibration<f64>>,
    enduring: Enduring,
}

/// The digest after each so many events.
fn digests<const D: usize>(
    memory: &mut impl Storage<f64, D>,
    scene: &Scene<D>,
    rule: impl Rule<f64>,
    [events, every]: [u64; 2],
) -> Vec<u64> {
    let builder = World::builder(memory).enduring(scene.enduring).rule(rule);
    let mut up = [0.0; D];
    up[D - 1] = 1.0;
    let builder = match scene.plate {
        None => builder.periodic([[0.0, scene.side]; D]),
        Some(plate) => {
            let floor = Plane::new(up, -plate.amplitude, Surface::Rule).vibrating(plate);
            let mut walls = [[0.0, scene.side]; D];
            walls[D - 1] = [-1.0, 4.0 * scene.side];
            builder.walls(walls).plane(floor).gravity(up.map(|x| -x))
        }
    };
    let mut world = builder.grains(scene.grains.iter().copied()).unwrap().start().unwrap();
    let mut digests = Vec::new();
    for n in 0..events {
        if world.step().unwrap().is_none() {
            break;
        }
        if n % every == 0 {
            digests.push(world.digest());
        }
    }
    digests
}

fn same<const D: usize>(scene: &Scene<D>, rule: impl Rule<f64> + Copy, events: [u64; 2]) {
    let mut memory = HeapMemory::with_capacity(scene.grains.len());
    assert!(memory.buffers().calendar.len() > 2 * scene.grains.len());
    let by_calendar = digests(&mut memory, scene, rule, events);
    let mut memory = TreeAlone(HeapMemory::with_capacity(scene.grains.len()));
    let by_tree = digests(&mut memory, scene, rule, events);
    let first = by_calendar.iter().zip(&by_tree).position(|(a, b)| a != b);
    assert_eq!(first, None, "of {}", by_tree.len());
    assert_eq!(by_calendar.len(), by_tree.len());
}

fn free<const D: usize>(count: usize, side: f64) -> Scene<D> {
    let grains = gas(count, 7, side, [0.35, 0.5]);
    Scene { grains, side, plate: None, enduring: Enduring::Integrated }
}

#[test]
fn a_gas_that_keeps_its_energy_and_one_that_cools_by_orders_of_magnitude() {
    same(&free::<3>(200, 9.0), HardSphere { restitution: 1.0 }, [30_000, 100]);
    same(&free::<2>(200, 40.0), HardSphere { restitution: 0.6 }, [60_000, 100]);
    same(&free::<1>(100, 150.0), HardSphere { restitution: 0.9 }, [30_000, 100]);
}

#[test]
fn grains_that_fall_on_a_plate_cluster_and_are_shaken() {
    for enduring in [Enduring::Integrated, Enduring::Paper] {
        let plate = Some(Vibration::new(0.3, 0.4));
        let scene = Scene { plate, enduring, ..free::<2>(100, 12.0) };
        let soft = Soft::linear_dashpot(damped_spring(), Outside::HardSphere);
        same(&scene, soft, [20_000, 100]);
        if enduring == Enduring::Integrated {
            same(&scene, HardSphere { restitution: 0.8 }, [20_000, 100]);
        }
    }
}

/// Some or all of 64 pairs collide at the same instants, again and again: up to sixteen the calendar can put in order.
#[test]
fn many_events_at_one_instant() {
    for tied in [2, 7, 16, 64] {
        let grains = (0..128).map(|i| {
            let (pair, side) = (i / 2, f64::from(i % 2));
            let speed = if pair % 64 < tied { 1.0 } else { 1.0 + 0.01 * f64::from(pair) };
            let [x, y] = [f64::from(pair % 8), f64::from(pair / 8)];
            Grain::with_mass(0.5, 1.0)
                .at([8.0 * x + 2.0 + 3.0 * side, 8.0 * y + 4.0])
                .moving([speed * (1.0 - 2.0 * side), 0.0])
        });
        let grains = grains.collect();
        let scene = Scene { grains, side: 64.0, plate: None, enduring: Enduring::Integrated };
        same(&scene, HardSphere { restitution: 1.0 }, [3_000, 1]);
    }
}
