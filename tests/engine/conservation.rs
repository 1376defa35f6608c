//! Are energy, momentum and angular momentum kept? Runs gases for many events; compares sums.

use crate::gas::{elastic_spring, gas, length, rubber};
use carom::HeapMemory;
use carom::law::{HardSphere, Outside, Rule, Soft};
use carom::world::Motion;
use carom::{Enduring, Release, Scalar, World};
use proptest::prelude::*;

const HARD: HardSphere<f64> = HardSphere { restitution: 1.0 };

/// Relative drift of energy, and of momentum in units of Σ m |v|, over `events` events in a periodic box.
///
/// A third body that comes while a contact cannot be interrupted yet may sink in. Such a pair, which then is put
/// where its contact ends, loses energy and keeps angular momentum: once in a million collisions here. It is not
/// what is looked for and is left out, and there may be no more of them than deferred collisions.
fn drift(rule: impl Rule<f64>, enduring: Enduring, events: u64) -> (f64, f64) {
    let mut storage = HeapMemory::with_capacity(50);
    let mut world = World::builder(&mut storage)
        .enduring(enduring)
        .periodic([[0.0, 8.0]; 3])
        .rule(rule)
        .grains(gas::<f64, 3>(50, 7, 8.0, [0.2, 0.3]))
        .unwrap()
        .start()
        .unwrap();
    let start = world.view().kinetic_energy();
    let (mut last, mut sunk, mut lost) = (start, 0, 0.0);
    while world.statistics().collisions < events {
        world.step().unwrap().expect("a gas in a box never ends");
        let now = world.view().kinetic_energy();
        if now < last - 1e-9 * start {
            (sunk, lost) = (sunk + 1, lost + (last - now));
        }
        last = now;
    }
    assert!(sunk <= world.statistics().deferred, "{sunk} losses, {:?}", world.statistics());
    let energy = (last + lost - start).abs() / start;
    (energy, length(&world.view().momentum()) / (2.0 * start * 50.0).sqrt())
}

#[test]
fn a_hard_elastic_gas_keeps_energy_and_momentum() {
    let (energy, momentum) = drift(HARD, Enduring::default(), 5_000);
    assert!(energy < 1e-13 && momentum < 1e-13, "energy {energy:e}, momentum {momentum:e}");
}

#[test]
fn a_soft_elastic_gas_keeps_energy_and_momentum() {
    let rule = Soft::linear_dashpot(elastic_spring(), Outside::HardSphere);
    let (energy, momentum) = drift(rule, Enduring::Paper, 5_000);
    assert!(energy < 1e-13 && momentum < 1e-13, "energy {energy:e}, momentum {momentum:e}");
}

/// `cargo test --release --test engine -- --ignored --nocapture millions`
#[test]
#[ignore = "a minute in release"]
fn millions_of_collisions_lose_no_more_than_a_millionth_of_a_millionth() {
    for (name, (energy, momentum)) in [
        ("hard, 10^7", drift(HARD, Enduring::default(), 10_000_000)),
        (
            "eMD*, 10^6",
            drift(
                Soft::linear_dashpot(elastic_spring(), Outside::HardSphere),
                Enduring::Paper,
                1_000_000,
            ),
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
        .enduring(Enduring::Paper)
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

/// By how many units in the last place of one grain's share the energy of 50 elastic disks rises a collision.
fn trend<S: Scalar>(rule: impl Rule<S>, enduring: Enduring, radius: f64, seed: u64) -> f64 {
    const COLLISIONS: u64 = 100_000;
    // So dilute that hardly a contact is interrupted: what is tested is rounding. Where a third body comes
    // near, the default mode integrates, with an error that its number of steps decides.
    let side = 96.0 * radius;
    let mut grains = gas::<S, 2>(50, seed, side, [radius, radius]);
    grains.iter_mut().for_each(|grain| grain.radius = S::from_f64(radius));
    let mut storage = HeapMemory::with_capacity(50);
    let mut world = World::builder(&mut storage)
        .enduring(enduring)
        .periodic([[S::zero(), S::from_f64(side)]; 2])
        .rule(rule)
        .grains(grains)
        .unwrap()
        .start()
        .unwrap();
    let energy = |world: &World<'_, S, 2, _>| {
        let squares = (0..50).flat_map(|i| world.view().released(i).unwrap().velocity.data.0[0]);
        squares.map(|v| v.to_f64() * v.to_f64()).sum::<f64>()
    };
    let start = energy(&world);
    while world.statistics().collisions < COLLISIONS {
        world.step().unwrap();
    }
    let rise = energy(&world) / start - 1.0;
    rise * 50.0 / COLLISIONS as f64 / S::RESOLUTION.to_f64()
}

/// Beside a power of two a square root is rounded one way: unit vectors were too long by 0.18 units in the last
/// place on average, and energy rose by 0.9 to 1.3 of them a collision, for every seed.
#[test]
fn energy_has_no_trend_where_the_contact_distance_is_a_power_of_two() {
    let default = Enduring::default();
    for radius in [0.5, 0.3] {
        for seed in 0..2 {
            let hard = trend(HardSphere { restitution: 1.0_f32 }, default, radius, seed);
            let soft = Soft::linear_dashpot(elastic_spring::<f32>(), Outside::HardSphere);
            let soft = trend(soft, Enduring::Paper, radius, seed);
            let double = trend(HARD, default, radius, seed);
            for rise in [hard, soft, double] {
                assert!(rise.abs() < 0.05, "radius {radius}, seed {seed}: {rise}");
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// While grains press each other the stand-in's spring has some of the energy: it is compared where none do.
    #[test]
    fn dissipation_never_adds_energy(seed in 0_u64..1000, epsilon in 0.1..1.0_f64) {
        // A grazing contact of a cluster loses less than its steps are wrong by: 4e-9 were gained for the seed 307.
        for (enduring, error) in [(Enduring::Paper, 1e-14), (Enduring::Integrated, 1e-7)] {
            let mut storage = HeapMemory::with_capacity(20);
            let mut world = World::builder(&mut storage)
                .enduring(enduring)
                .hard_walls([[0.0, 6.0]; 2], 1.0)
                .rule(HardSphere { restitution: epsilon })
                .grains(gas::<f64, 2>(20, seed, 6.0, [0.2, 0.4])).unwrap()
                .start().unwrap();
            let mut before = world.view().kinetic_energy();
            let mut compared = 0;
            for _ in 0..1000 {
                if world.step().is_err() { break; }
                let view = world.view();
                if (0..20).any(|i| view.motion(i) == Some(Motion::Cluster)) { continue; }
                let now = view.kinetic_energy();
                prop_assert!(now <= before * (1.0 + error));
                (before, compared) = (now, compared + 1);
            }
            prop_assert!(compared > 100, "{}", compared);
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
