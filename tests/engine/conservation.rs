//! Are energy, momentum and angular momentum kept? Runs gases for many events; compares sums.

use crate::gas::{elastic_spring, gas, length, rubber};
use carom::HeapMemory;
use carom::law::{HardSphere, Outside, Rule, Soft};
use carom::{Release, World};
use proptest::prelude::*;

const HARD: HardSphere<f64> = HardSphere { restitution: 1.0 };

/// Relative drift of energy, and of momentum in units of Σ m |v|, over `events` events in a periodic box.
fn drift(rule: impl Rule<f64>, events: u64) -> (f64, f64) {
    let mut storage = HeapMemory::with_capacity(50);
    let mut world = World::builder(&mut storage)
        .periodic([[0.0, 8.0]; 3])
        .rule(rule)
        .grains(gas::<f64, 3>(50, 7, 8.0, [0.2, 0.3]))
        .unwrap()
        .start()
        .unwrap();
    let start = world.view().kinetic_energy();
    while world.statistics().collisions < events {
        world.step().unwrap().expect("a gas in a box never ends");
    }
    let energy = (world.view().kinetic_energy() - start).abs() / start;
    (energy, length(&world.view().momentum()) / (2.0 * start * 50.0).sqrt())
}

#[test]
fn a_hard_elastic_gas_keeps_energy_and_momentum() {
    let (energy, momentum) = drift(HARD, 5_000);
    assert!(energy < 1e-13 && momentum < 1e-13, "energy {energy:e}, momentum {momentum:e}");
}

#[test]
fn a_soft_elastic_gas_keeps_energy_and_momentum() {
    let (energy, momentum) =
        drift(Soft::linear_dashpot(elastic_spring(), Outside::HardSphere), 5_000);
    assert!(energy < 1e-13 && momentum < 1e-13, "energy {energy:e}, momentum {momentum:e}");
}

/// `cargo test --release --test engine -- --ignored --nocapture millions`
#[test]
#[ignore = "a minute in release"]
fn millions_of_collisions_lose_no_more_than_a_millionth_of_a_millionth() {
    for (name, (energy, momentum)) in [
        ("hard, 10^7", drift(HARD, 10_000_000)),
        (
            "eMD*, 10^6",
            drift(Soft::linear_dashpot(elastic_spring(), Outside::HardSphere), 1_000_000),
        ),
    ] {
        println!("{name}: energy {energy:e}, momentum {momentum:e}");
        assert!(
            energy <= 1e-12 && momentum <= 1e-12,
            "{name}: energy {energy:e}, momentum {momentum:e}"
        );
    }
}

/// Angular momentum about the origin, Σ m (x v_y − y v_x), of what is left when every contact has ended.
fn angular_momentum(release: Release, seed: u64) -> (f64, u64) {
    // A disc of grains that falls together and flies apart in open space.
    let mut grains = gas::<f64, 2>(30, seed, 12.0, [0.5, 0.9]);
    for g in &mut grains {
        g.position -= carom::scalar::Vector::from([6.0, 6.0]);
        g.velocity +=
            g.position * -0.3 + carom::scalar::Vector::from([-g.position[1], g.position[0]]) * 0.1;
    }
    let of = |g: &carom::Grain<f64, 2>| {
        g.mass * (g.position[0] * g.velocity[1] - g.position[1] * g.velocity[0])
    };
    let start: f64 = grains.iter().map(of).sum();
    let lever = |g: &carom::Grain<f64, 2>| g.mass * length(&g.position) * length(&g.velocity);
    let mut storage = HeapMemory::with_capacity(30);
    let soft = Soft::linear_dashpot(
        carom::law::LinearDashpot { stiffness: 2.0e2, damping: 0.5 },
        Outside::Clamp,
    );
    let mut world = World::builder(&mut storage)
        .release(release)
        .rule(soft)
        .grains(grains)
        .unwrap()
        .start()
        .unwrap();
    while world.step().unwrap().is_some() {}
    let ended: Vec<_> = (0..30).map(|i| world.grain(i).unwrap()).collect();
    let end: f64 = ended.iter().map(of).sum();
    // In units of what is summed up: Σ m |r| |v|.
    let scale: f64 = ended.iter().map(lever).sum();
    ((end - start).abs() / scale, world.statistics().interrupted)
}

#[test]
fn paired_release_keeps_angular_momentum_in_open_space() {
    let mut interrupted = 0;
    for seed in 0..20 {
        let (lost, count) = angular_momentum(Release::Paired, seed);
        assert!(lost < 1e-13, "seed {seed}: {lost:e}");
        interrupted += count;
    }
    assert!(interrupted > 20, "only {interrupted} interrupted contacts: the test shows nothing");
}

#[test]
fn independent_release_loses_a_little_as_the_paper_says() {
    let lost =
        (0..20).map(|seed| angular_momentum(Release::Independent, seed).0).fold(0.0, f64::max);
    assert!(lost > 1e-9, "{lost:e}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn dissipation_never_adds_energy(seed in 0_u64..1000, epsilon in 0.1..1.0_f64) {
        let mut storage = HeapMemory::with_capacity(20);
        let mut world = World::builder(&mut storage)
            .hard_walls([[0.0, 6.0]; 2], 1.0)
            .rule(HardSphere { restitution: epsilon })
            .grains(gas::<f64, 2>(20, seed, 6.0, [0.2, 0.4])).unwrap()
            .start().unwrap();
        let mut before = world.view().kinetic_energy();
        for _ in 0..500 {
            if world.step().is_err() { break; }
            let now = world.view().kinetic_energy();
            prop_assert!(now <= before * (1.0 + 1e-14));
            before = now;
        }
    }

    #[test]
    fn viscoelastic_contacts_lose_energy_and_keep_momentum(seed in 0_u64..1000) {
        let mut storage = HeapMemory::with_capacity(20);
        let mut world = World::builder(&mut storage)
            .periodic([[0.0, 6.0]; 2])
            .rule(Soft::viscoelastic(rubber(), Outside::HardSphere))
            .grains(gas::<f64, 2>(20, seed, 6.0, [0.2, 0.4])).unwrap()
            .start().unwrap();
        let start = world.view().kinetic_energy();
        for _ in 0..1000 { world.step().unwrap(); }
        prop_assert!(world.view().kinetic_energy() < start);
        prop_assert!(length(&world.view().momentum()) < 1e-12);
    }
}
