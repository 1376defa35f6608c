//! Does velocity Verlet tend to the exact motion? Reads both; writes nothing.

use carom_reference::{
    Boundary, End, Exact, ForceLaw, Grain, System, Verlet, VerletOptions, collide,
};

use super::gas::Random;
use super::max_difference;

fn fine(steps_per_contact: f64) -> VerletOptions {
    VerletOptions { steps_per_contact, skin: None }
}

/// Error of a pair's velocities after an oblique elastic impact that begins at time 0.
fn pair_error(law: ForceLaw, steps_per_contact: f64) -> f64 {
    let grain =
        |x, y, v: f64| Grain { radius: 0.1, mass: 1.0, position: [x, y], velocity: [v, 0.1] };
    let grains = [grain(0.16, 0.12, -1.0), grain(0.0, 0.0, 1.0)];
    let system = System::new(grains.to_vec(), [Boundary::Open; 2], [0.0; 2]).expect("valid");
    let mut run = Verlet::new(&system, law, End::Force, fine(steps_per_contact)).expect("valid");
    let hit = collide(grains, law, End::Force, &[]).expect("integrates");
    run.advance_to(1.5 * hit.duration).expect("goes on");
    (0..2).map(|i| max_difference(run.velocity(i), hit.after[i].velocity)).fold(0.0, f64::max)
}

#[test]
fn second_order_for_elastic_pairs() {
    for law in [
        ForceLaw::LinearDashpot { stiffness: 1e3, damping: 0.0 },
        ForceLaw::Viscoelastic { young: 1e5, poisson: 0.3, dissipation: 0.0 },
    ] {
        // The end of the contact falls anywhere in its step: average over nearby step lengths.
        let mean = |n: f64| (0..16).map(|k| pair_error(law, n * (1.0 + 0.01 * f64::from(k)))).sum();
        let [coarse, medium, fine]: [f64; 3] = [50.0, 200.0, 800.0].map(mean);
        for order in [(coarse / medium).log(4.0), (medium / fine).log(4.0)] {
            assert!((1.7..2.4).contains(&order), "{law:?}: order {order}");
        }
        assert!(coarse / 16.0 < 5e-3, "{law:?}: {coarse}");
    }
}

/// Damped, the jump of the force at the beginning costs an order at worst.
#[test]
fn damped_pairs_converge() {
    for law in [
        ForceLaw::LinearDashpot { stiffness: 1e3, damping: 5.0 },
        ForceLaw::Viscoelastic { young: 1e5, poisson: 0.3, dissipation: 2e-3 },
        ForceLaw::LinearDashpot { stiffness: 1e3, damping: 500.0 },
    ] {
        let [coarse, fine] = [50.0, 1600.0].map(|n| pair_error(law, n));
        assert!(fine < coarse / 20.0, "{law:?}: {coarse:e} {fine:e}");
        assert!(fine < 2e-3, "{law:?}: {fine:e}");
    }
}

/// A heap in the making: discs of two sizes falling on each other between soft walls.
fn heap() -> System<2> {
    let mut random = Random(11);
    let mut disc = |k: usize| Grain {
        radius: if k % 3 == 0 { 0.1 } else { 0.12 },
        mass: if k % 3 == 0 { 1.0 } else { 1.5 },
        position: [
            0.2 + 0.28 * (k % 3) as f64 + 0.02 * random.uniform(),
            0.2 + 0.3 * (k / 3) as f64,
        ],
        velocity: [0.3 * random.normal(), 0.3 * random.normal() - 1.0],
    };
    let walls = [Boundary::Walls { lo: 0.0, hi: 1.0 }, Boundary::Walls { lo: 0.0, hi: 5.0 }];
    System::new((0..9).map(&mut disc).collect(), walls, [0.0, -9.81]).expect("valid")
}

/// Many grains and walls in contact at once: two integrators that share nothing but the force.
#[test]
fn verlet_approaches_exact_in_a_heap() {
    for (law, end) in [
        (ForceLaw::Viscoelastic { young: 2e5, poisson: 0.3, dissipation: 0.0 }, End::Force),
        (ForceLaw::Viscoelastic { young: 2e5, poisson: 0.3, dissipation: 1e-3 }, End::Force),
        (ForceLaw::LinearDashpot { stiffness: 2e4, damping: 20.0 }, End::Force),
        (ForceLaw::LinearDashpot { stiffness: 2e4, damping: 20.0 }, End::Overlap),
    ] {
        let until = 0.25;
        let mut exact = Exact::new(heap(), law, end).expect("valid");
        exact.advance_to(until).expect("integrates");
        assert!(exact.first_three_grain_contact().is_some(), "{law:?}");
        let error = |n: f64| {
            let mut run = Verlet::new(&heap(), law, end, fine(n)).expect("valid");
            run.advance_to(until).expect("goes on");
            (0..9).map(|i| max_difference(run.position(i), exact.position(i))).fold(0.0, f64::max)
        };
        let [coarse, fine] = [50.0, 2000.0].map(error);
        assert!(fine < coarse / 20.0 && fine < 1e-4, "{law:?} {end:?}: {coarse:e} {fine:e}");
    }
}
