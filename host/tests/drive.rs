//! Do driven grains do what theory says? Runs gases with heat baths, noise and changing gravity; compares with closed forms and another program.

use carom::law::HardSphere;
use carom::particle::Body;
use carom::world::{ScheduledEvent, Snapshot};
use carom::{Grain, HeapMemory, World};
use carom_host::drive::{Action, Driving, Gravity, Source, Vector};
use rand::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use rand_pcg::Pcg64;

/// Grains on the sites of a cubic lattice in [0, edge]^D with velocities of this temperature; masses come in turn.
fn gas<const D: usize>(
    count: usize,
    edge: f64,
    radius: f64,
    (masses, temperature): (&[f64], f64),
) -> Vec<Grain<f64, D>> {
    let mut rng = Pcg64::seed_from_u64(7);
    let side = (1..).find(|side: &usize| side.pow(D as u32) >= count).unwrap();
    (0..count)
        .map(|i| {
            let site = |axis: usize| ((i / side.pow(axis as u32)) % side) as f64 + 0.5;
            let mass = masses[i % masses.len()];
            let speed = (temperature / mass).sqrt();
            let velocity = std::array::from_fn(|_| {
                let x: f64 = StandardNormal.sample(&mut rng);
                speed * x
            });
            let at = std::array::from_fn(|axis| edge / side as f64 * site(axis));
            Grain::with_mass(radius, mass).at(at).moving(velocity)
        })
        .collect()
}

/// Mean of m v² per component.
fn temperature<'a, const D: usize>(grains: impl IntoIterator<Item = &'a Grain<f64, D>>) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0);
    for grain in grains {
        sum += grain.mass * grain.velocity.dot(&grain.velocity);
        count += D as f64;
    }
    sum / count
}

/// The mean temperature of each of two kinds that come in turn, from time `from` on, and a₂ of the first: the
/// fourth cumulant ⟨v⁴⟩/⟨v²⟩² D/(D+2) − 1.
fn run<const D: usize>(
    grains: &[Grain<f64, D>],
    (edge, periodic, restitution): (f64, bool, f64),
    sources: Vec<Source<D>>,
    [from, to, every]: [f64; 3],
) -> [f64; 3] {
    let mut memory = HeapMemory::with_capacity(grains.len());
    let sides = [[0.0, edge]; D];
    let builder = World::builder(&mut memory).rule(HardSphere { restitution });
    let builder = if periodic { builder.periodic(sides) } else { builder.hard_walls(sides, 1.0) };
    let mut world = builder.grains(grains.iter().copied()).unwrap().start().unwrap();
    let mut driving = Driving::new(sources, grains.len(), 3).unwrap();
    let (mut sums, mut samples, mut fourth, mut second) = ([0.0; 2], 0.0, 0.0, 0.0);
    let mut time = from;
    while time <= to {
        driving.advance(&mut world, time, &mut ()).unwrap();
        let now: Vec<_> = (0..grains.len()).map(|i| world.grain(i).unwrap()).collect();
        for (kind, sum) in sums.iter_mut().enumerate() {
            *sum += temperature(now.iter().skip(kind).step_by(2));
        }
        for v2 in now.iter().step_by(2).map(|grain| grain.velocity.dot(&grain.velocity)) {
            (second, fourth) = (second + v2, fourth + v2 * v2);
        }
        samples += 1.0;
        time += every;
    }
    let count = samples * grains.len().div_ceil(2) as f64;
    let (mean2, mean4) = (second / count, fourth / count);
    let kurtosis = mean4 / (mean2 * mean2) * D as f64 / (D as f64 + 2.0) - 1.0;
    [sums[0] / samples, sums[1] / samples, kurtosis]
}

/// An elastic gas between thermal walls takes their temperature, light grains and heavy ones alike, and Maxwell's
/// distribution: also where it began ten times as hot.
#[test]
fn a_gas_takes_the_temperature_of_its_walls() {
    let grains = gas::<2>(64, 10.0, 0.2, (&[1.0, 4.0], 20.0));
    let walls = (0..4).map(|plane| Source::ThermalWall { plane, temperature: 2.0 }).collect();
    let [light, heavy, a2] = run(&grains, (10.0, false, 1.0), walls, [100.0, 15_000.0, 1.0]);
    // The energy of 64 components is forgotten in about 20: 750 independent values, a standard error of 0.6 %.
    assert!((light / 2.0 - 1.0).abs() < 0.018, "{light}");
    assert!((heavy / 2.0 - 1.0).abs() < 0.018, "{heavy}");
    assert!(a2.abs() < 0.02, "{a2}");
}

/// One grain between two thermal walls: it spends its time as slow as Maxwell's distribution says.
#[test]
fn one_grain_between_thermal_walls_has_their_temperature() {
    let grains = [Grain::with_mass(0.1, 2.0).at([0.5]).moving([1.0])];
    let walls = (0..2).map(|plane| Source::ThermalWall { plane, temperature: 3.0 }).collect();
    let [found, _, a2] = run(&grains, (1.0, false, 1.0), walls, [10.0, 20_010.0, 1.0]);
    assert!((found / 3.0 - 1.0).abs() < 0.05, "{found}");
    assert!(a2.abs() < 0.15, "{a2}");
}

/// Andersen's thermostat gives an elastic gas its temperature and Maxwell's distribution.
#[test]
fn a_thermostat_gives_its_temperature() {
    let grains = gas::<3>(64, 6.0, 0.3, (&[1.0, 0.25], 0.1));
    let bath = vec![Source::Andersen { temperature: 1.5, rate: 0.5 }];
    let [light, heavy, a2] = run(&grains, (6.0, true, 1.0), bath, [20.0, 520.0, 0.5]);
    assert!((light / 1.5 - 1.0).abs() < 0.025, "{light}");
    assert!((heavy / 1.5 - 1.0).abs() < 0.025, "{heavy}");
    assert!(a2.abs() < 0.02, "{a2}");
}

/// White noise heats an elastic gas: the variance of each component grows by ξ² t, less what the fixed momentum
/// takes, and the momentum stays.
#[test]
fn noise_heats_as_fast_as_it_must() {
    let grains = gas::<3>(512, 16.0, 0.3, (&[1.0], 0.01));
    let mut memory = HeapMemory::with_capacity(512);
    let mut world = World::builder(&mut memory)
        .periodic([[0.0, 16.0]; 3])
        .rule(HardSphere { restitution: 1.0 })
        .grains(grains.iter().copied())
        .unwrap()
        .start()
        .unwrap();
    let noise = vec![Source::WhiteNoise { strength: 0.5, interval: 0.05 }];
    let mut driving = Driving::new(noise, 512, 5).unwrap();
    let before = world.view().momentum();
    driving.advance(&mut world, 4.0, &mut ()).unwrap();
    let found = 2.0 * world.view().kinetic_energy() / (3.0 * 512.0);
    let wanted = temperature(&grains) + 0.5 * 4.0 * (1.0 - 1.0 / 512.0);
    // 1,533 squares of normal numbers: one standard error is 3.6 %.
    assert!((found / wanted - 1.0).abs() < 0.11, "{found} for {wanted}");
    assert!((world.view().momentum() - before).norm() < 1e-10);
}

/// Under a table of gravity a grain flies as its steps say: v = Σ g Δt, exactly at every change.
#[test]
fn a_grain_falls_as_the_table_says() {
    let table =
        vec![(0.0, Vector([0.0, -1.0])), (2.0, Vector([3.0, 0.0])), (3.0, Vector([0.0, 0.5]))];
    let mut memory = HeapMemory::with_capacity(1);
    let mut world = World::builder(&mut memory)
        .rule(HardSphere { restitution: 1.0 })
        .grain(Grain::with_mass(0.1, 1.0))
        .unwrap()
        .start()
        .unwrap();
    let mut driving = Driving::new(vec![Source::Gravity(Gravity::Table(table))], 1, 0).unwrap();
    driving.advance(&mut world, 5.0, &mut ()).unwrap();
    let grain = world.grain(0).unwrap();
    let (x, v) = ([1.5 + 3.0 * 2.0, -2.0 - 2.0 - 4.0 + 1.0], [3.0, -2.0 + 1.0]);
    for axis in 0..2 {
        assert!((grain.position[axis] - x[axis]).abs() < 1e-13, "{grain:?}");
        assert!((grain.velocity[axis] - v[axis]).abs() < 1e-14, "{grain:?}");
    }
}

/// Gravity that turns once round leaves a grain as fast as it was, on the polygon that the steps are.
#[test]
fn turning_gravity_comes_round() {
    let turning = Gravity::Rotating { magnitude: 2.0, axes: [0, 1], period: 1.0, steps: 64 };
    let mut memory = HeapMemory::<f64, 2>::with_capacity(1);
    let mut world = World::builder(&mut memory)
        .rule(HardSphere { restitution: 1.0 })
        .grain(Grain::with_mass(0.1, 1.0))
        .unwrap()
        .start()
        .unwrap();
    let mut driving = Driving::new(vec![Source::Gravity(turning)], 1, 0).unwrap();
    for turn in 1..=3 {
        driving.advance(&mut world, f64::from(turn), &mut ()).unwrap();
        assert!(world.grain(0).unwrap().velocity.norm() < 1e-13);
    }
    driving.advance(&mut world, 3.5, &mut ()).unwrap();
    // Half a turn: 2 g ÷ ω along the second axis, on the circle.
    let half = world.grain(0).unwrap().velocity;
    assert!((half[1] * std::f64::consts::TAU / 4.0 - 1.0).abs() < 1e-3, "{half:?}");
}

/// A driven run that is saved in the middle, as text, goes on with the same bits; and in how many calls it arrives
/// does not matter.
#[test]
fn a_driven_run_goes_on_with_the_same_bits() {
    let grains = gas::<2>(40, 8.0, 0.25, (&[1.0], 1.0));
    let rule = HardSphere { restitution: 0.8 };
    let sources = || {
        vec![
            Source::ThermalWall { plane: 2, temperature: 1.0 },
            Source::Andersen { temperature: 0.7, rate: 0.02 },
            Source::WhiteNoise { strength: 0.01, interval: 0.25 },
            Source::At { time: 3.3, action: Action::Kick(4, Vector([0.5, 0.0])) },
            Source::At { time: 3.4, action: Action::SetVelocity(5, Vector([0.5, 0.1])) },
            Source::At { time: 3.5, action: Action::Remove(6) },
        ]
    };
    let mut memory = HeapMemory::with_capacity(40);
    let mut world = World::builder(&mut memory)
        .hard_walls([[0.0, 8.0]; 2], 1.0)
        .gravity([0.0, -0.2])
        .rule(rule)
        .grains(grains.iter().copied())
        .unwrap()
        .start()
        .unwrap();
    let mut driving = Driving::new(sources(), 40, 9).unwrap();
    while !driving.advance_within(&mut world, 3.45, 7, &mut ()).unwrap() {}
    let text = serde_json::to_string(&(world.save(), &driving)).unwrap();
    type Saved = (Snapshot<f64, 2, Vec<Body<f64, 2>>, Vec<ScheduledEvent<f64>>>, Driving<2>);
    let (saved, mut again): Saved = serde_json::from_str(&text).unwrap();
    let mut other = HeapMemory::with_capacity(40);
    let mut restored = World::restore(&mut other, rule, &saved).unwrap();
    driving.advance(&mut world, 9.0, &mut ()).unwrap();
    again.advance(&mut restored, 9.0, &mut ()).unwrap();
    assert_eq!(world.digest(), restored.digest());
    assert!(world.grain(6).is_none());
    assert!(world.statistics().collisions > 20);
}

#[test]
fn sources_that_make_no_sense_are_named() {
    let said = |source: Source<2>| format!("{:#}", Driving::new(vec![source], 3, 0).unwrap_err());
    let cold = said(Source::ThermalWall { plane: 0, temperature: -1.0 });
    assert_eq!(cold, "driving source 0: temperature is -1, must be finite and above 0");
    assert!(said(Source::Andersen { temperature: 1.0, rate: f64::NAN }).contains("rate is NaN"));
    assert!(said(Source::WhiteNoise { strength: 1.0, interval: 0.0 }).contains("interval is 0"));
    assert!(said(Source::At { time: -1.0, action: Action::Remove(0) }).contains("time is -1"));
    let turning = Gravity::Rotating { magnitude: 1.0, axes: [0, 2], period: 1.0, steps: 8 };
    assert!(said(Source::Gravity(turning)).contains("axes 0 and 2"));
    assert!(said(Source::Gravity(Gravity::Table(vec![]))).contains("table"));
}

/// 1,372 grains of two sizes fall onto a floor of k T = 1 under g = 1 between elastic walls: each has an event every
/// 0.8946 units of time, as in a test of DynamO (thermalisedwalls_test.cpp; its tolerance is 6 %).
#[test]
#[ignore = "500,000 collisions: in release"]
fn a_thermal_floor_as_in_dynamo() {
    let edge = (1372.0_f64 / 0.1).cbrt();
    let grains = gas::<3>(1372, edge, 0.25, (&[0.125], 1.0)).into_iter().enumerate();
    let grains = grains.map(|(i, grain)| match i {
        0..100 => Grain { radius: 0.5, mass: 1.0, ..grain },
        _ => grain,
    });
    let sides = [[-1.0, edge + 1.0]; 3];
    let mut memory = HeapMemory::with_capacity(1372);
    let wall = |axis: usize, at: f64, sign: f64| {
        let mut normal = [0.0; 3];
        normal[axis] = sign;
        carom::space::Plane::new(normal, sign * at, carom::space::Surface::Hard(1.0))
    };
    let mut builder = World::builder(&mut memory)
        .gravity([0.0, -1.0, 0.0])
        .rule(HardSphere { restitution: 1.0 })
        .plane(wall(1, -1.0, 1.0));
    for axis in [0, 2] {
        builder = builder.plane(wall(axis, sides[axis][0], 1.0));
        builder = builder.plane(wall(axis, sides[axis][1], -1.0));
    }
    let mut world = builder.grains(grains).unwrap().start().unwrap();
    let floor = Source::ThermalWall { plane: 0, temperature: 1.0 };
    let mut driving = Driving::new(vec![floor], 1372, 4).unwrap();
    let events = |world: &World<'_, f64, 3, HardSphere<f64>>| {
        2 * world.statistics().collisions + world.statistics().plane_collisions
    };
    let mut until = |world: &mut World<'_, f64, 3, HardSphere<f64>>, count: u64| {
        let (before, mut time) = (events(world), world.now().as_f64());
        while events(world) - before < count {
            time += 1.0;
            driving.advance(world, time, &mut ()).unwrap();
        }
        (events(world) - before) as f64
    };
    until(&mut world, 200_000);
    let begin = world.now().as_f64();
    let counted = until(&mut world, 800_000);
    let mean_free_time = (world.now().as_f64() - begin) * 1372.0 / counted;
    assert!((mean_free_time / 0.8946 - 1.0).abs() < 0.06, "{mean_free_time}");
}

/// A dilute gas of ε = 1/2 heated by white noise: a₂ = 16 (1 − ε)(1 − 2 ε²) / (73 + 56 D − 24 ε D − 105 ε +
/// 30 (1 − ε) ε²) (van Noije & Ernst, Granul. Matter 1, 57, 1998), 0.0256 in three dimensions, and as much is lost
/// as comes in: ξ² = (1 − ε²)/3 · 4 n σ² √π T^(3/2) (1 + 3 a₂/16). Denser gases have a larger a₂: 0.034 at packing
/// 0.11, where fast and slow regions form.
#[test]
#[ignore = "millions of kicks: in release"]
fn a_heated_gas_has_the_published_fourth_cumulant() {
    let (edge, strength) = (100.0_f64, 0.0055);
    let grains = gas::<3>(2_000, edge, 0.5, (&[1.0], 1.0));
    let noise = vec![Source::WhiteNoise { strength, interval: 2.0 }];
    let [found, other, a2] = run(&grains, (edge, true, 0.5), noise, [2_000.0, 22_000.0, 50.0]);
    let density = 2_000.0 / edge.powi(3);
    let loss =
        0.75 / 3.0 * 4.0 * density * std::f64::consts::PI.sqrt() * (1.0 + 3.0 * 0.0256 / 16.0);
    let wanted = (strength / loss).powf(2.0 / 3.0);
    assert!((0.5 * (found + other) / wanted - 1.0).abs() < 0.01, "{found}, {other} for {wanted}");
    assert!((a2 - 0.0256).abs() < 0.005, "{a2}");
}
