//! Is what clustered and sleeping grains give each other told rightly? Lets grains come to rest; compares with their weight.

use carom::law::{HardSphere, LinearDashpot, Outside, Rule, Soft};
use carom::world::Transfer;
use carom::{Grain, HeapMemory, Observer, World};

/// Sums of what a floor was given, and of r·F over pairs.
#[derive(Default)]
struct Sums {
    floor: f64,
    virial: f64,
    work: f64,
}

impl Sums {
    fn add(&mut self, transfer: &Transfer<f64, 2>) {
        self.work += transfer.work;
        match transfer.partner.as_plane() {
            Some(_) => self.floor += transfer.impulse[1],
            None => self.virial += transfer.separation.dot(&transfer.impulse),
        }
    }
}

impl Observer<f64, 2> for Sums {
    fn transferred(&mut self, transfer: &Transfer<f64, 2>) {
        self.add(transfer);
    }
}

const BEADS: usize = 6;

/// A column that stands on the floor of a box, between walls that it does not touch.
fn column<R: Rule<f64>>(
    memory: &mut HeapMemory<f64, 2>,
    rule: R,
    gap: f64,
) -> World<'_, f64, 2, R> {
    let grains = (0..BEADS)
        .map(|k| Grain::with_mass(0.5, 1.0).at([0.0, 0.5 + gap + (1.0 + gap) * k as f64]));
    World::builder(memory)
        .walls([[-2.0, 2.0], [0.0, 20.0]])
        .gravity([0.0, -10.0])
        .rule(rule)
        .grains(grains)
        .unwrap()
        .start()
        .unwrap()
}

fn assert_sleepers_bear_their_weight<R: Rule<f64>>(rule: R) {
    let mut memory = HeapMemory::<f64, 2>::with_capacity(BEADS);
    let mut world = column(&mut memory, rule, 0.01);
    world.advance_to(400.0).unwrap();
    assert!((0..BEADS).all(|i| world.view().is_at_rest(i)));
    let mut sums = Sums::default();
    let mut contacts = 0;
    world.for_each_resting_contact(|transfer, since| {
        assert!(since < world.now());
        sums.add(transfer);
        contacts += 1;
    });
    assert_eq!(contacts, BEADS);
    let weight = 10.0 * BEADS as f64;
    // Who falls asleep still moves by up to (g R)^½/2048: a dashpot of 60 takes 0.07 of the 60 at that speed.
    assert!((sums.floor / weight - 1.0).abs() < 2e-3, "{}", sums.floor);
    // Between grains weighs what lies above: 5 + 4 + 3 + 2 + 1 of them, at a distance just below 1.
    assert!((sums.virial / 150.0 - 1.0).abs() < 2e-2, "{}", sums.virial);
}

#[test]
fn sleepers_bear_their_weight() {
    let spring = LinearDashpot { stiffness: 1e5, damping: 60.0 };
    assert_sleepers_bear_their_weight(Soft::linear_dashpot(spring, Outside::HardSphere));
    assert_sleepers_bear_their_weight(HardSphere { restitution: 0.5 });
}

/// As long as the column swings and does not sleep, steps tell the floor's force: on average the weight, and the work of
/// all forces is the kinetic and potential energy that is gone.
#[test]
fn steps_tell_what_the_floor_bears() {
    let mut memory = HeapMemory::<f64, 2>::with_capacity(BEADS);
    let spring = LinearDashpot { stiffness: 1e4, damping: 20.0 };
    let rule = Soft::linear_dashpot(spring, Outside::HardSphere);
    let mut world = column(&mut memory, rule, 0.0);
    let energy = |world: &World<'_, f64, 2, _>| {
        let heights = (0..BEADS).map(|i| 10.0 * world.view().grain(i).unwrap().position[1]);
        world.view().kinetic_energy() + heights.sum::<f64>()
    };
    let (before, mut sums) = (energy(&world), Sums::default());
    world.advance_observed(0.5, &mut sums).unwrap();
    assert!((0..BEADS).all(|i| !world.view().is_at_rest(i)));
    let momentum = world.view().momentum()[1];
    let given = momentum + 0.5 * 10.0 * BEADS as f64;
    assert!((sums.floor / given - 1.0).abs() < 1e-2, "{} of {given}", sums.floor);
    let gone = before - energy(&world);
    assert!(gone > 0.1 && (sums.work / gone - 1.0).abs() < 0.05, "{} of {gone}", sums.work);
}
