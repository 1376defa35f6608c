//! What of contacts with obstacles that last? Soft grains, heaps, sleep and friction, as on planes.

use super::shapes::{Room, ring, room};
use carom::law::{HardSphere, LinearDashpot, Outside, Rough, Rule, Soft, Tangential};
use carom::particle::Partner;
use carom::space::{ContactState, Facet, Surface, chain};
use carom::world::{Motion, Observer, Rotating, Transfer, WithContacts};
use carom::{Grain, HeapMemory, Storage, World};

const SPRING: LinearDashpot<f64> = LinearDashpot { stiffness: 1.0e4, damping: 5.0 };

fn soft() -> impl Rule<f64> {
    Soft::linear_dashpot(SPRING, Outside::HardSphere)
}

/// A floor of segments as long as that, from −5 to 5.
fn floor(length: f64, surface: Surface<f64>) -> Vec<Facet<f64, 2>> {
    let count = (10.0 / length).round() as i32;
    let points: Vec<_> =
        (0..=count).map(|k| [-5.0 + 10.0 * f64::from(k) / f64::from(count), 0.0]).collect();
    chain(&points, surface).collect()
}

/// Where a grain is after so many seconds on a floor of facets, or of a plane.
fn run(
    memory: &mut impl Storage<f64, 2>,
    plane: bool,
    (grain, until): (Grain<f64, 2>, f64),
) -> ([f64; 2], Option<Motion>) {
    let mut builder = World::builder(memory).gravity([0.0, -10.0]).rule(soft());
    if plane {
        builder = builder.plane(carom::space::Plane::new([0.0, 1.0], 0.0, Surface::Rule));
    }
    let mut world = builder.grain(grain).unwrap().start().unwrap();
    world.advance_to(until).unwrap();
    (world.grain(0).unwrap().position.into(), world.view().motion(0))
}

#[test]
fn a_soft_grain_comes_to_rest_as_on_a_plane() {
    let grain = Grain::with_mass(0.1, 0.5).at([0.03, 0.4]);
    let (at, motion) = run(&mut room(1, floor(1.0, Surface::Rule)), false, (grain, 20.0));
    assert_eq!(motion, Some(Motion::Rest));
    // Its spring holds m g.
    assert!((at[1] - (0.1 - 0.5 * 10.0 / 1.0e4)).abs() < 5e-7, "{at:?}");
    let on_plane = run(&mut HeapMemory::with_capacity(1), true, (grain, 20.0)).0;
    assert!((at[1] - on_plane[1]).abs() < 5e-7, "{at:?}, {on_plane:?}");
}

#[test]
fn a_soft_grain_slides_over_flat_joints_as_on_a_plane() {
    // Joints closer than the grain is wide: each is inside the contact for a while.
    let grain = Grain::with_mass(0.1, 0.5).at([-4.0, 0.1]).moving([2.0, 0.0]);
    for length in [1.0, 0.05] {
        let (at, _) = run(&mut room(1, floor(length, Surface::Rule)), false, (grain, 3.0));
        assert!((at[0] - 2.0).abs() < 1e-9, "{length}: {at:?}");
        assert!((at[1] - 0.0995).abs() < 1e-9, "{length}: {at:?}");
    }
}

/// Sums up what obstacles give grains.
#[derive(Default)]
struct Given([f64; 2]);

impl Observer<f64, 2> for Given {
    fn transferred(&mut self, transfer: &Transfer<f64, 2>) {
        if transfer.partner.as_facet().is_some() {
            let given: [f64; 2] = transfer.impulse.into();
            self.0 = [self.0[0] + given[0], self.0[1] + given[1]];
        }
    }
}

#[test]
fn a_heap_on_a_funnel_sleeps_and_its_weight_is_held() {
    for rule_is_hard in [false, true] {
        let points = [[-1.0, 1.0], [-0.4, 0.0], [0.3, -0.1], [1.0, 1.1]];
        let surface = if rule_is_hard { Surface::Hard(0.6) } else { Surface::Rule };
        let mut memory = room(12, chain(&points, surface).collect());
        let grains = (0..12).map(|k| {
            let at = [
                -0.3 + 0.2 * f64::from(k % 4) + 0.01 * f64::from(k / 4),
                0.4 + 0.25 * f64::from(k / 4),
            ];
            Grain::with_mass(0.09, 0.5).at(at)
        });
        let builder = World::builder(&mut memory).gravity([0.0, -10.0]);
        let weight = if rule_is_hard {
            held(
                builder
                    .rule(HardSphere { restitution: 0.6 })
                    .grains(grains)
                    .unwrap()
                    .start()
                    .unwrap(),
            )
        } else {
            held(builder.rule(soft()).grains(grains).unwrap().start().unwrap())
        };
        let all = 12.0 * 0.5 * 10.0;
        assert!(weight[0].abs() < 5e-3 * all && (weight[1] / all - 1.0).abs() < 5e-3, "{weight:?}");
    }
}

/// The forces of facets on grains that lie still at last.
fn held<R: Rule<f64>>(mut world: World<'_, f64, 2, R>) -> [f64; 2] {
    world.advance_to(40.0).unwrap();
    let asleep = (0..12).filter(|&k| world.view().motion(k) == Some(Motion::Rest)).count();
    assert_eq!(asleep, 12);
    let mut given = Given::default();
    world.for_each_resting_contact(|transfer, _| given.transferred(transfer));
    given.0
}

/// Memory for disks that rotate among obstacles.
type Rough2 = WithContacts<Rotating<Room<f64, 2>, Vec<f64>>, Vec<ContactState<f64>>>;

fn rough_room(facets: Vec<Facet<f64, 2>>) -> Rough2 {
    let rows = [(); 3].map(|()| vec![0.0; 1]);
    WithContacts::new(Rotating::new(room(1, facets), rows), vec![ContactState::VACANT; 8])
}

#[test]
fn a_disk_rolls_down_a_chain_of_ramps() {
    // Down a slope of 20°, on which it does not slide: a = g sin θ/(1 + q), q = 1/2.
    let slope = 20.0_f64.to_radians();
    let points: Vec<_> = (0..=40)
        .map(|k| f64::from(k) * 0.25)
        .map(|s| [s * slope.cos(), -s * slope.sin()])
        .collect();
    let rough = Rough::disks(soft(), Tangential::Walton { mu: 0.6, beta_0: 0.0 });
    let mut memory = rough_room(chain(&points, Surface::Rule).collect());
    let (s, h) = (1.0, 0.1);
    let at = [s * slope.cos() + h * slope.sin(), -s * slope.sin() + h * slope.cos()];
    let mut world = World::builder(&mut memory)
        .gravity([0.0, -10.0])
        .rule(rough)
        .grain(Grain::with_mass(0.1, 0.5).at(at))
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(1.0).unwrap();
    let moved = world.grain(0).unwrap().position - carom::Vector::from(at);
    let rolled = 0.5 * 10.0 * slope.sin() / 1.5;
    let along = moved.x * slope.cos() - moved.y * slope.sin();
    assert!((along / rolled - 1.0).abs() < 0.02, "{along}, {rolled}");
    assert!((moved.x * slope.sin() + moved.y * slope.cos()).abs() < 6e-4, "{moved:?}");
    assert_eq!(Partner::facet(7).as_facet(), Some(7));
}

#[test]
fn a_rough_grain_in_a_polygon_turns_as_in_a_box() {
    let square = ring(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], Surface::Hard(0.9));
    let rough =
        || Rough::disks(HardSphere { restitution: 0.9 }, Tangential::Constant { beta: 0.3 });
    let grain = Grain::with_mass(0.1, 1.0).at([0.3, 0.4]).moving([1.0, 0.7]);
    let mut among = rough_room(square);
    let mut among = World::builder(&mut among).rule(rough()).grain(grain).unwrap().start().unwrap();
    let rows = [(); 3].map(|()| vec![0.0; 1]);
    let mut between = Rotating::new(HeapMemory::<f64, 2>::with_capacity(1), rows);
    let mut between = World::builder(&mut between)
        .hard_walls([[0.0, 1.0]; 2], 0.9)
        .rule(rough())
        .grain(grain)
        .unwrap()
        .start()
        .unwrap();
    among.advance_to(10.0).unwrap();
    between.advance_to(10.0).unwrap();
    let spins = [among.view(), between.view()].map(|view| view.angular_velocity(0).unwrap()[2]);
    assert!(spins[0].abs() > 1e-3 && (spins[0] - spins[1]).abs() < 1e-9, "{spins:?}");
}

#[test]
fn a_belt_carries_a_disk_along() {
    // A disk put onto a belt slides until its surface keeps up with it. Both its velocity and its rotation grow: v − ω R = u
    // then, with m dv = F dt and I dω = −F R dt, so v = u q/(1 + q).
    let belt = 0.4;
    let rough = Rough::disks(soft(), Tangential::Walton { mu: 0.3, beta_0: 0.0 });
    let facets: Vec<_> =
        floor(0.5, Surface::Rule).into_iter().map(|facet| facet.running([belt, 0.0])).collect();
    let mut memory = rough_room(facets);
    let mut world = World::builder(&mut memory)
        .gravity([0.0, -10.0])
        .rule(rough)
        .grain(Grain::with_mass(0.1, 0.5).at([-2.0, 0.1]))
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(2.0).unwrap();
    let (v, w) = (world.grain(0).unwrap().velocity.x, world.view().angular_velocity(0).unwrap()[2]);
    // Less by the overlap, m g/k of R = 0.5 %, are the arms.
    assert!((v - belt * 0.5 / 1.5).abs() < 2e-3, "{v}");
    assert!((v + w * 0.1 - belt).abs() < 3e-3, "{v}, {w}");
}

#[test]
fn a_belt_in_hard_collisions_turns_grains() {
    // Down onto a belt that holds on completely (β = 0): the surface leaves with the belt's velocity.
    let rough = Rough::disks(HardSphere { restitution: 1.0 }, Tangential::Constant { beta: 0.0 });
    let facets = vec![Facet::new([[-1.0, 0.0], [1.0, 0.0]], Surface::Rule).running([0.3, 0.0])];
    let mut memory = rough_room(facets);
    let grain = Grain::with_mass(0.1, 0.5).at([0.0, 0.5]).moving([0.0, -1.0]);
    let mut world = World::builder(&mut memory).rule(rough).grain(grain).unwrap().start().unwrap();
    world.advance_to(0.5).unwrap();
    let (v, w) = (world.grain(0).unwrap().velocity, world.view().angular_velocity(0).unwrap()[2]);
    assert!((v.x - 0.1).abs() < 1e-12 && (v.y - 1.0).abs() < 1e-12, "{v:?}");
    assert!((v.x + w * 0.1 - 0.3).abs() < 1e-12, "{w}");
}
