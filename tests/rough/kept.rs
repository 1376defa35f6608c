//! What do stiff contacts of rough soft grains keep? Momentum, angular momentum and energy: of pairs, and of a box that is swung.

use crate::pair::{random, seeded, two};
use carom::law::{Outside, Rough, Rule, Soft, Tangential, Viscoelastic};
use carom::space::ContactState;
use carom::world::{Rotating, WithContacts};
use carom::{Grain, HeapMemory, Memory, Vector, World};
use rand::RngExt;
use rand_pcg::Pcg64Mcg;

fn soft(young: f64, dissipation: f64) -> impl Rule<f64> + Copy {
    let law = Viscoelastic { young, poisson: 0.3, dissipation };
    Soft::viscoelastic(law, Outside::HardSphere)
}

fn any_law(rng: &mut Pcg64Mcg) -> Tangential<f64> {
    let mu = rng.random_range(0.0..1.0);
    match rng.random_range(0..3) {
        0 => Tangential::Constant { beta: rng.random_range(-1.0..=1.0) },
        1 => Tangential::Walton { mu, beta_0: rng.random_range(-0.5..=1.0) },
        _ => Tangential::Spring { mu, stiffness: rng.random_range(1e4..1e6), damping: 0.0 },
    }
}

fn energy<R: Rule<f64>, const D: usize>(world: &World<'_, f64, D, R>) -> f64 {
    world.view().kinetic_energy() + world.view().rotational_energy(0.4)
}

#[test]
fn pairs_keep_momentum_and_angular_momentum_and_gain_no_energy() {
    let mut rng = seeded(11);
    let (mut contacts, mut most) = (0, 0.0_f64);
    for case in 0..300 {
        let spins = [random(&mut rng, 2.0), random(&mut rng, 2.0)];
        let places = [ContactState::VACANT; 2];
        let memory = WithContacts::new(Memory::<f64, 3, 2>::new(), places);
        let mut memory = Rotating::new(memory, [spins, [[0.0; 3]; 2], [[0.0; 3]; 2]]);
        let dissipation = if case % 2 == 0 { 0.0 } else { 1e-4 };
        let rule = Rough::spheres(soft(1e7, dissipation), any_law(&mut rng));
        let mut world =
            World::builder(&mut memory).rule(rule).grains(two(&mut rng)).unwrap().start().unwrap();
        let (p, l, e) =
            (world.view().momentum(), world.view().angular_momentum(0.4), energy(&world));
        world.advance_to(6.0).unwrap();
        assert!(world.view().contact(0).is_none());
        // A spring that swings too often for the table is integrated.
        if world.statistics().joins > 0 {
            continue;
        }
        contacts += world.statistics().collisions;
        assert!((world.view().momentum() - p).norm() < 1e-13);
        let turn = Vector::<f64, 3>::from(world.view().angular_momentum(0.4)) - Vector::from(l);
        assert!(turn.norm() < 1e-12, "{case}: {turn}");
        most = most.max(energy(&world) / e - 1.0);
    }
    println!("{contacts} {most:e}");
    assert!(contacts > 200 && most < 1e-4, "{contacts} {most:e}");
}

/// Swung, left alone, swung again: nobody leaves, nothing is no number, and without gravity nothing is gained.
#[test]
fn a_swung_box_of_rough_soft_grains_holds() {
    let mut rng = seeded(12);
    let spins: Vec<f64> = (0..25).map(|_| rng.random_range(-1.0..1.0)).collect();
    let still = vec![0.0; 25];
    let memory =
        WithContacts::new(HeapMemory::<f64, 2>::with_capacity(25), vec![ContactState::VACANT; 256]);
    let mut memory = Rotating::new(memory, [spins, still.clone(), still]);
    let tangential = Tangential::Spring { mu: 0.5, stiffness: 1e5, damping: 0.0 };
    let grains = (0..25).map(|k: i32| {
        let at = [k % 5, k / 5].map(|x| 1.3 * f64::from(x) + 0.7);
        Grain::with_mass(0.4 + 0.01 * f64::from(k % 7), 1.0).at(at).moving(random(&mut rng, 3.0))
    });
    let mut world = World::builder(&mut memory)
        .walls([[0.0, 8.0]; 2])
        .rule(Rough::spheres(soft(1e7, 1e-4), tangential))
        .grains(grains)
        .unwrap()
        .start()
        .unwrap();
    let mut last = energy(&world);
    for turn in 0..12_i32 {
        let angle = f64::from(turn) * 0.9;
        let g = if turn % 3 == 0 { 0.0 } else { 9.81 };
        world.set_gravity([g * angle.sin(), -g * angle.cos()]).unwrap();
        world.advance_to(0.5 * f64::from(turn + 1)).unwrap();
        let now = energy(&world);
        assert!(now.is_finite() && (g > 0.0 || now < last * 1.001), "{turn}: {last} {now}");
        last = now;
        for i in 0..25 {
            assert!(world.grain(i).unwrap().position.iter().all(|x| (0.0..8.0).contains(x)), "{i}");
        }
    }
    assert!(world.statistics().collisions > 100 && world.statistics().joins > 10);
}
