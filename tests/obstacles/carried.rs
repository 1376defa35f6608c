//! What do obstacles that move do in contacts that last? They lift grains, drag and turn them.

use super::shapes::{ring, room};
use carom::law::{LinearDashpot, Outside, Rough, Rule, Soft, Tangential};
use carom::space::{ContactState, Facet, RigidMotion, Surface};
use carom::world::{Motion, Rotating, WithContacts, WithObstacles};
use carom::{Grain, HeapMemory, World};

const SPRING: LinearDashpot<f64> = LinearDashpot { stiffness: 1.0e4, damping: 5.0 };

fn soft() -> impl Rule<f64> + Copy {
    Soft::linear_dashpot(SPRING, Outside::HardSphere)
}

fn floor() -> Facet<f64, 2> {
    Facet::new([[-5.0, 0.0], [5.0, 0.0]], Surface::Rule)
}

type Places = Vec<carom::particle::Index>;
type RoughRoom =
    WithContacts<Rotating<Moved<HeapMemory<f64, 2>>, Vec<f64>>, Vec<ContactState<f64>>>;
type Moved<M> = WithObstacles<M, Vec<Facet<f64, 2>>, Places, [RigidMotion<f64, 2>; 1]>;

fn moved(facets: Vec<Facet<f64, 2>>, motion: RigidMotion<f64, 2>) -> Moved<HeapMemory<f64, 2>> {
    let room = room(1, facets.into_iter().map(|facet| facet.moving(0)).collect());
    room.moving([motion])
}

/// The same for a rough disk.
fn rough(facets: Vec<Facet<f64, 2>>, motion: RigidMotion<f64, 2>) -> RoughRoom {
    let places = vec![ContactState::VACANT; 4];
    WithContacts::new(Rotating::new(moved(facets, motion), [(); 3].map(|()| vec![0.0; 1])), places)
}

#[test]
fn a_floor_that_rises_lifts_a_soft_disk() {
    let mut memory = moved(vec![floor()], RigidMotion::drifting([0.0, 0.4]));
    let grain = Grain::with_mass(0.1, 0.5).at([0.03, 0.4]);
    let mut world = World::builder(&mut memory)
        .gravity([0.0, -10.0])
        .rule(soft())
        .grain(grain)
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(20.0).unwrap();
    let grain = world.grain(0).unwrap();
    // It moves with the floor, and its spring holds m g. It never sleeps: the floor does not stand.
    assert!((grain.velocity.y - 0.4).abs() < 1e-9, "{:?}", grain.velocity);
    let above = grain.position.y - 0.4 * 20.0;
    assert!((above - (0.1 - 0.5 * 10.0 / 1.0e4)).abs() < 1e-9, "{above}");
    assert_ne!(world.view().motion(0), Some(Motion::Rest));
}

#[test]
fn a_floor_that_goes_sideways_is_a_belt() {
    let law = Rough::disks(soft(), Tangential::Walton { mu: 0.3, beta_0: 0.0 });
    let run = |facet: Facet<f64, 2>, speed: f64| {
        let mut memory = rough(vec![facet], RigidMotion::drifting([speed, 0.0]));
        let mut world = World::builder(&mut memory)
            .gravity([0.0, -10.0])
            .rule(law)
            .grain(Grain::with_mass(0.1, 0.5).at([-2.0, 0.1]))
            .unwrap()
            .start()
            .unwrap();
        world.advance_to(2.0).unwrap();
        let spin = world.view().angular_velocity(0).unwrap()[2];
        (world.grain(0).unwrap().velocity.x, spin)
    };
    let (moved, belt) = (run(floor(), 0.4), run(floor().running([0.4, 0.0]), 0.0));
    assert!((moved.0 - belt.0).abs() < 1e-9 && (moved.1 - belt.1).abs() < 1e-8);
    assert!((moved.0 - 0.4 * 0.5 / 1.5).abs() < 2e-3, "{moved:?}");
}

#[test]
fn a_box_that_turns_takes_a_rough_disk_with_it() {
    // Flung into a corner without gravity, it ends as a part of the box: it turns about the centre and about itself.
    let omega = 2.0;
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let law = Rough::disks(soft(), Tangential::Walton { mu: 0.5, beta_0: 0.0 });
    let mut memory =
        rough(ring(&corners, Surface::Rule), RigidMotion::<f64, 2>::turning([0.0, 0.0], omega));
    let mut world = World::builder(&mut memory)
        .rule(law)
        .grain(Grain::with_mass(0.2, 0.5).at([0.3, 0.1]).moving([0.5, 0.2]))
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(60.0).unwrap();
    let (grain, spin) = (world.grain(0).unwrap(), world.view().angular_velocity(0).unwrap()[2]);
    // Two sides at right angles hold it: k x = m ω² (0.8 + x) in each, less what their surfaces hold.
    let sinks = 0.5 * omega * omega / 1.0e4 * 0.8;
    let far = grain.position.norm() / 2.0_f64.sqrt() - 0.8;
    assert!(far > sinks / 2.0 && far < sinks + 1e-9, "{far} {sinks}");
    let carried = grain.velocity.norm() / grain.position.norm();
    assert!((carried - omega).abs() < 1e-6, "{carried}");
    assert!((spin - omega).abs() < 1e-6, "{spin}");
}
