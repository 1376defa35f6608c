//! Does the reference care where, in which order or how fast it is looked at? Reads one gas told in several ways; writes nothing.

use carom_reference::{Boundary, End, Exact, ForceLaw, Grain, System};
use proptest::prelude::*;

use super::gas::Random;
use super::max_difference;

const SIDE: f64 = 2.0;

fn law() -> ForceLaw {
    ForceLaw::Viscoelastic { young: 1e7, poisson: 0.3, dissipation: 1e-4 }
}

/// Ten discs of two sizes in a periodic box, apart from each other.
fn discs(seed: u64) -> Vec<Grain<2>> {
    let mut random = Random(seed);
    let mut disc = |k: usize| Grain {
        radius: if k % 2 == 0 { 0.1 } else { 0.15 },
        mass: if k % 2 == 0 { 1.0 } else { 3.0 },
        position: [0.25 + 0.5 * (k % 4) as f64, 0.33 + 0.66 * (k / 4) as f64],
        velocity: [random.normal(), random.normal()],
    };
    (0..10).map(&mut disc).collect()
}

fn run(grains: &[Grain<2>], bound: Boundary, contacts: usize) -> Exact<2> {
    let system = System::new(grains.to_vec(), [bound; 2], [0.0; 2]).expect("valid");
    let mut run = Exact::new(system, law(), End::Force).expect("valid");
    for _ in 0..contacts {
        run.next_contact(1e3).expect("integrates").expect("a contact");
    }
    run
}

const BOX: Boundary = Boundary::Periodic { lo: 0.0, hi: SIDE };

/// A few contacts amplify round-off; 1e-9 leaves them three to four orders.
const CLOSE: f64 = 1e-9;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    #[test]
    fn origin_of_the_box(seed: u64, shift in [-5.0..5.0_f64, -5.0..5.0_f64]) {
        let grains = discs(seed);
        let moved: Vec<Grain<2>> = grains.iter().map(|g| Grain {
            position: [g.position[0] + shift[0], g.position[1] + shift[1]], ..*g
        }).collect();
        let (a, b) = (run(&grains, BOX, 6), run(&moved, BOX, 6));
        prop_assert!((a.now() - b.now()).abs() < CLOSE);
        for i in 0..grains.len() {
            prop_assert!(max_difference(a.velocity(i), b.velocity(i)) < CLOSE);
        }
    }

    #[test]
    fn moving_observer(seed: u64, boost in [-3.0..3.0_f64, -3.0..3.0_f64]) {
        let grains = discs(seed);
        let moving: Vec<Grain<2>> = grains.iter().map(|g| Grain {
            velocity: [g.velocity[0] + boost[0], g.velocity[1] + boost[1]], ..*g
        }).collect();
        let (a, b) = (run(&grains, BOX, 6), run(&moving, BOX, 6));
        prop_assert!((a.now() - b.now()).abs() < CLOSE);
        for i in 0..grains.len() {
            let seen: [f64; 2] = std::array::from_fn(|k| b.velocity(i)[k] - boost[k]);
            prop_assert!(max_difference(a.velocity(i), seen) < CLOSE);
        }
    }

    #[test]
    fn order_of_the_grains(seed: u64, first in 0..10_usize) {
        let grains = discs(seed);
        let mut turned = grains.clone();
        turned.rotate_left(first);
        let (a, b) = (run(&grains, BOX, 6), run(&turned, BOX, 6));
        prop_assert!((a.now() - b.now()).abs() < CLOSE);
        for i in 0..grains.len() {
            prop_assert!(max_difference(a.velocity((i + first) % 10), b.velocity(i)) < CLOSE);
        }
    }
}

/// The same flight through the box's edge and in the open.
#[test]
fn a_contact_across_the_edge() {
    let grain = |x: f64, v: f64| Grain {
        radius: 0.1,
        mass: 1.0,
        position: [x, 0.37],
        velocity: [v, 0.02 * v],
    };
    let inside = run(&[grain(1.9, 0.5), grain(0.15, -0.5)], BOX, 1);
    let open = run(&[grain(1.9, 0.5), grain(2.15, -0.5)], Boundary::Open, 1);
    assert!((inside.now() - open.now()).abs() < 1e-14);
    for i in 0..2 {
        assert!(max_difference(inside.velocity(i), open.velocity(i)) < 1e-12);
    }
}

/// A box so narrow that two discs touch on both sides at once.
#[test]
fn one_pair_in_two_images() {
    let disc = |x: f64, v: f64| Grain { radius: 0.1, mass: 1.0, position: [x], velocity: [v] };
    let system = System::new(
        vec![disc(0.0, 0.3), disc(0.195, -0.3)],
        [Boundary::Periodic { lo: 0.0, hi: 0.39 }],
        [0.0],
    )
    .expect("valid");
    let law = ForceLaw::LinearDashpot { stiffness: 10.0, damping: 0.0 };
    let energy = system.kinetic_energy() + 10.0 * 0.005_f64.powi(2);
    let mut run = Exact::new(system, law, End::Force).expect("valid");
    let mut most = 0;
    while run.now() < 3.0 {
        run.next_event(3.0).expect("integrates");
        most = most.max(run.contacts());
    }
    assert_eq!(most, 2);
    assert!(run.first_three_grain_contact().is_some());
    let [a, b] = [run.position(0)[0], run.position(1)[0]];
    let gap = (a - b).rem_euclid(0.39);
    let overlap = |d: f64| (0.2 - d).max(0.0);
    let elastic = 5.0 * (overlap(gap).powi(2) + overlap(0.39 - gap).powi(2));
    let kinetic = 0.5 * (run.velocity(0)[0].powi(2) + run.velocity(1)[0].powi(2));
    assert!((kinetic + elastic - energy).abs() < 1e-12);
}
