//! Does a heap hold where sleepers, heavy grains and sliding ones meet? Reads worlds; compares with energy, statics and what must wake.

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
