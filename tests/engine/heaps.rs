//! Does a heap hold where sleepers, heavy grains and sliding ones meet? Reads worlds; compares with energy, statics and what must wake.

use crate::gas::gas;
use carom::detect::EventKind;
use carom::law::{HardSphere, LinearDashpot, Outside, Rule, Soft};
use carom::{Enduring, Grain, HeapMemory, Memory, Storage, World};

/// Grains on a line above a floor of this restitution; (R/g)^½ = 1.
fn column<'m, R: Rule<f64>>(
    memory: &'m mut impl Storage<f64, 1>,
    floor: f64,
    rule: R,
    grains: impl IntoIterator<Item = Grain<f64, 1>>,
) -> World<'m, f64, 1, R> {
    World::builder(memory)
        .enduring(Enduring::Integrated)
        .hard_walls([[0.0, 100.0]], floor)
        .gravity([-1.0])
        .rule(rule)
        .grains(grains)
        .unwrap()
        .start()
        .unwrap()
}

fn energy<R: Rule<f64>>(world: &World<'_, f64, 1, R>) -> f64 {
    let view = world.view();
    let potential = |i| {
        let grain = view.grain(i).unwrap();
        grain.mass * grain.position[0]
    };
    view.kinetic_energy() + (0..view.len()).map(potential).sum::<f64>()
}

/// Whoever fell asleep while another was on its way to it is not overlooked.
#[test]
fn a_grain_lands_on_one_that_fell_asleep_meanwhile() {
    for height in [3.0, 3.5, 4.0, 6.0, 10.0] {
        let mut memory = Memory::<f64, 1, 2>::new();
        let spring = LinearDashpot { stiffness: 8000.0, damping: 17.0 };
        let rule = Soft::linear_dashpot(spring, Outside::HardSphere);
        let grain = |radius: f64, at: f64| Grain::with_mass(radius, radius).at([at]);
        let grains = [grain(0.26, 0.3), grain(0.28, height)];
        let mut world = column(&mut memory, 0.1, rule, grains);
        let start = energy(&world);
        // Its kinetic energy in one spring, that of the contact.
        let deepest = (2.0 * height * 0.28 / 8000.0).sqrt();
        let mut slept = false;
        while world.now().as_f64() < 12.0 && world.next_event_time().is_some() {
            world.step().unwrap();
            slept |= world.view().is_at_rest(0);
            let at = |i| world.grain(i).unwrap().position[0];
            let overlap = 0.54 - (at(1) - at(0));
            assert!(overlap < deepest, "{height}: {overlap} at {}", world.now());
            assert!(energy(&world) < start + 1e-9, "{height} at {}", world.now());
        }
        assert!(slept);
    }
}

/// Ten grains a hundred times as heavy as the lowest sink into it by no more than a tenth of its radius.
#[test]
fn a_small_grain_carries_heavy_ones() {
    let mut memory = HeapMemory::<f64, 1>::with_capacity(11);
    let large = (0..10).map(|i| Grain::with_mass(1.0, 1.0).at([1.5 + 2.05 * f64::from(i)]));
    let grains = std::iter::once(Grain::with_mass(0.2, 0.01).at([0.21])).chain(large);
    let mut world = column(&mut memory, 0.5, HardSphere { restitution: 0.5 }, grains);
    while world.next_event_time().is_some() {
        world.step().unwrap();
        let at = |i| world.grain(i).unwrap().position[0];
        let gaps = [at(0) - 0.2, at(1) - at(0) - 1.2];
        assert!(gaps.iter().all(|&gap| gap > -0.02), "{gaps:?} at {}", world.now());
        assert!(world.now().as_f64() < 400.0);
    }
}

/// Numbers between 0 and 1 from a seed.
fn numbers(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) + 1;
    move || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as f64 / 2_f64.powi(31)
    }
}

/// The most steps, and the most collisions of one grain, in a contact time of a crowded box.
fn busiest(seed: u64, steps: u32) -> [u32; 2] {
    const N: usize = 12;
    const T: f64 = 1.0 / 16.0;
    let mut next = numbers(seed);
    let [restitution, speed] = [next(), 10.0 * next()];
    let high = 8.2 + 2.0 * next();
    let mut memory = Memory::<f64, 2, N>::new();
    let grains = (0..N).map(|i| {
        let at = [1.01 + 2.02 * (i % 3) as f64, 1.01 + 2.02 * (i / 3) as f64];
        Grain::with_mass(1.0, 1.0).at(at).moving([speed * (next() - 0.5), speed * (next() - 0.5)])
    });
    let mut world = World::builder(&mut memory)
        .enduring(Enduring::Integrated)
        .steps_per_contact(steps)
        .contact_time(T)
        .hard_walls([[0.0, 6.1], [0.0, high]], restitution)
        .gravity([0.0, -1.0])
        .rule(HardSphere { restitution })
        .grains(grains)
        .unwrap()
        .start()
        .unwrap();
    let mut most = [0; 2];
    for window in 1..200 {
        let mut done = 0;
        let mut of_grain = [0; N];
        while let Some(event) = world.step_until(T * f64::from(window)).unwrap() {
            if event.kind == EventKind::Step {
                done += 1;
            } else {
                of_grain[event.grain] += 1;
                event.partner.as_grain().into_iter().for_each(|k| of_grain[k] += 1);
            }
        }
        most = [most[0].max(done), of_grain.into_iter().fold(most[1], u32::max)];
    }
    most
}

/// The bound on work that `Enduring::Integrated` states.
#[test]
fn work_is_bounded() {
    for (seed, steps) in (0..60).map(|seed| (seed, [8, 32, 64][seed as usize % 3])) {
        let [done, collisions] = busiest(seed, steps);
        assert!(done <= steps + 1, "{done} steps of {steps}");
        assert!(collisions <= 1040 + 16 * steps + 64, "{collisions} collisions, {steps} steps");
    }
}

/// Three disks side by side between walls and two on top of them, asleep.
fn pyramid(memory: &mut impl Storage<f64, 2>) -> World<'_, f64, 2, HardSphere<f64>> {
    let place = |x: f64, y: f64| Grain::with_mass(1.0, 1.0).at([x, y]);
    let grains = [(1.0, 1.0), (3.0, 1.0), (5.0, 1.0), (2.0, 2.74), (4.0, 2.74)];
    let mut world = World::builder(memory)
        .enduring(Enduring::Integrated)
        .hard_walls([[0.0, 6.0], [0.0, 1000.0]], 0.5)
        .gravity([0.0, -1.0])
        .rule(HardSphere { restitution: 0.5 })
        .grains(grains.map(|(x, y)| place(x, y)))
        .unwrap()
        .grain(Grain::with_mass(0.5, 0.1).at([2.2, 900.0]))
        .unwrap()
        .start()
        .unwrap();
    while (0..5).any(|i| !world.view().is_at_rest(i)) {
        world.step().unwrap();
        assert!(world.now().as_f64() < 40.0, "awake");
    }
    world
}

/// In a pyramid at rest the normal forces of the stand-in, taken from its overlaps, balance each weight.
#[test]
fn a_pyramid_stands_in_balance() {
    let mut memory = Memory::<f64, 2, 6>::new();
    let world = pyramid(&mut memory);
    // k = m_eff (π/t)² with t = 1/16, a little stiffer the deeper it is.
    let stiffness = |mass: f64| mass * (16.0 * std::f64::consts::PI).powi(2);
    let force = |mass: f64, depth: f64| {
        let depth = depth.max(0.0);
        stiffness(mass) * depth * (1.0 + (32.0 * depth).powi(4))
    };
    let at = |i: usize| -> [f64; 2] { world.grain(i).unwrap().position.into() };
    for i in 0..5 {
        let [x, y] = at(i);
        let mut sum = [force(1.0, 1.0 - x) - force(1.0, x - 5.0), force(1.0, 1.0 - y) - 1.0];
        for k in (0..5).filter(|&k| k != i) {
            let [dx, dy] = [x - at(k)[0], y - at(k)[1]];
            let distance = dx.hypot(dy);
            let push = force(0.5, 2.0 - distance);
            sum = [sum[0] + push * dx / distance, sum[1] + push * dy / distance];
        }
        assert!(sum.iter().all(|f| f.abs() < 1e-3), "{i}: {sum:?}");
    }
}

/// What falls onto a sleeping heap wakes it; until then, and after, it sleeps.
#[test]
fn a_heap_wakes_when_it_is_hit_and_sleeps_again() {
    let mut memory = Memory::<f64, 2, 6>::new();
    let mut world = pyramid(&mut memory);
    let before: Vec<_> = (0..5).map(|i| world.grain(i).unwrap()).collect();
    world.advance_to(42.0).unwrap();
    assert!((0..5).all(|i| world.grain(i).unwrap() == before[i]), "nothing has come yet");
    world.advance_to(42.6).unwrap();
    assert!((0..5).any(|i| !world.view().is_at_rest(i)), "hit at 42 times (R/g)^½");
    while world.next_event_time().is_some() {
        world.step().unwrap();
        assert!(world.now().as_f64() < 800.0);
    }
}

/// A gas of hard spheres, and what became of it.
fn gas_after(enduring: Enduring) -> (Vec<[f64; 3]>, u64, u64) {
    let mut memory = HeapMemory::<f64, 3>::with_capacity(64);
    let mut world = World::builder(&mut memory)
        .enduring(enduring)
        .periodic([[0.0, 1.0]; 3])
        .rule(HardSphere { restitution: 1.0 })
        .grains(gas(64, 5, 1.0, [0.1, 0.1]))
        .unwrap()
        .start()
        .unwrap();
    while world.statistics().collisions < 5_000 {
        world.step().unwrap().unwrap();
    }
    let places = (0..64).map(|i| world.grain(i).unwrap().position.into()).collect();
    (places, world.statistics().joins, world.statistics().steps)
}

#[test]
fn a_gas_without_gravity_makes_no_clusters() {
    let (places, joins, steps) = gas_after(Enduring::Integrated);
    let (paper, ..) = gas_after(Enduring::Paper);
    assert_eq!([joins, steps], [0, 0]);
    // Slow and glancing collisions included: to the last bit.
    assert_eq!(places, paper);
}

#[test]
fn grains_that_stick_take_work_in_proportion_to_their_number() {
    let events = |count: u32| {
        let mut memory = HeapMemory::<f64, 1>::with_capacity(count as usize);
        let mut random = numbers(7);
        let grains = (0..count).map(|i| {
            let at = 3.0 * f64::from(i) + 0.9 * random();
            Grain::with_mass(1.0, 1.0).at([at]).moving([random() - 0.03 * f64::from(i)])
        });
        let mut world = World::builder(&mut memory)
            .enduring(Enduring::Integrated)
            .rule(HardSphere { restitution: 0.0 })
            .grains(grains)
            .unwrap()
            .start()
            .unwrap();
        world.advance_to(200.0).unwrap();
        let speed = |i: u32| world.grain(i as usize).unwrap().velocity[0];
        let spread = (1..count).map(|i| (speed(i) - speed(i - 1)).abs()).fold(0.0, f64::max);
        (world.statistics().collisions, spread)
    };
    for count in [15, 60] {
        let (collisions, spread) = events(count);
        assert!(collisions < 64 * u64::from(count), "{collisions}");
        // The stand-in gives back something of what is slow: below a sixteenth of the fastest at the start.
        assert!(spread < 1.0 / 16.0, "{spread}");
    }
}
