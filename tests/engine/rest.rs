//! Do grains come to rest, stay there and get up again? Reads worlds of columns, plates and piles; compares closed forms.

use carom::law::{HardSphere, LinearDashpot, Outside, Soft};
use carom::space::{Plane, Surface, Vibration};
use carom::world::View;
use carom::{Enduring, Grain, Memory, Scalar, World};

const G: f64 = 9.81;

pub fn at_rest<const D: usize>(view: View<'_, f64, D>) -> usize {
    (0..view.len()).filter(|&i| view.is_at_rest(i)).count()
}

/// A ball dropped from h rests at t = sqrt(2h/g) (1 + ε)/(1 − ε), the sum of all its bounces.
fn ball<S: Scalar>(epsilon: f64, tolerance: f64) {
    let s = S::from_f64;
    let mut memory = Memory::<S, 1, 1>::new();
    let mut world = World::builder(&mut memory)
        .enduring(Enduring::Paper)
        .hard_walls([[s(0.0), s(100.0)]], s(epsilon))
        .gravity([s(-10.0)])
        .rule(HardSphere { restitution: S::one() })
        .grain(Grain::with_mass(s(0.5), s(1.0)).at([s(1.5)]))
        .unwrap()
        .start()
        .unwrap();
    while world.step().unwrap().is_some() {
        assert!(world.statistics().plane_collisions < 100_000, "{epsilon} runs on");
    }
    let expected = (2.0_f64 / 10.0).sqrt() * (1.0 + epsilon) / (1.0 - epsilon);
    let t = world.now().as_f64();
    assert!((t / expected - 1.0).abs() < tolerance, "{epsilon}: {t} for {expected}");
    let grain = world.grain(0).unwrap();
    assert_eq!(grain.velocity[0], S::zero());
    assert!((grain.position[0].to_f64() - 0.5).abs() < 1e-5);
    assert_eq!(world.statistics().rests, 1);
    world.advance_to(s(1000.0)).unwrap();
    assert_eq!(world.grain(0).unwrap(), grain);
}

#[test]
fn a_bouncing_ball_rests_when_the_closed_form_has_it() {
    for epsilon in [0.0, 0.1, 0.5, 0.9, 0.99] {
        ball::<f64>(epsilon, 1e-6 / (1.0 - epsilon));
        ball::<f32>(epsilon, 4e-3 / (1.0 - epsilon));
    }
}

fn column(epsilon: f64, gap: f64) -> Memory<f64, 1, 10> {
    let mut memory = Memory::<f64, 1, 10>::new();
    let grains =
        (0..10).map(|i| Grain::with_mass(0.5, 1.0).at([0.5 + 0.3 + f64::from(i) * (1.0 + gap)]));
    let mut world = World::builder(&mut memory)
        .enduring(Enduring::Paper)
        .plane(Plane::new([1.0], 0.0, Surface::Hard(epsilon)))
        .gravity([-G])
        .rule(HardSphere { restitution: epsilon })
        .grains(grains)
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(200.0).unwrap();
    let view = world.view();
    assert_eq!(at_rest(view), 10, "{epsilon} {gap}: {:?}", world.statistics());
    for i in 0..10 {
        let x = view.grain(i).unwrap().position[0];
        assert!((x - (0.5 + i as f64)).abs() < 1e-9, "{epsilon} {gap}: grain {i} at {x}");
    }
    assert!(world.next_event_time().is_none());
    memory
}

#[test]
fn a_column_comes_to_rest_as_one() {
    for epsilon in [0.0, 0.5, 0.6, 0.9] {
        for gap in [0.0, 1e-6, 0.1] {
            column(epsilon, gap);
        }
    }
}

#[test]
fn a_column_at_rest_wakes_when_it_is_hit_and_rests_again() {
    let mut memory = Memory::<f64, 1, 4>::new();
    let at = |x: f64| Grain::with_mass(0.5, 1.0).at([x]);
    let mut world = World::builder(&mut memory)
        .enduring(Enduring::Paper)
        .plane(Plane::new([1.0], 0.0, Surface::Hard(0.5)))
        .gravity([-G])
        .rule(HardSphere { restitution: 0.7 })
        .grains([at(0.5), at(1.5), at(2.5), at(13.5)])
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(1.0).unwrap();
    assert_eq!(at_rest(world.view()), 3);
    world.advance_to(1.5).unwrap();
    assert!(world.statistics().take_offs >= 3, "{:?}", world.statistics());
    world.advance_to(60.0).unwrap();
    assert_eq!(at_rest(world.view()), 4);
    world.set_gravity([1.0]).unwrap();
    world.advance_to(61.0).unwrap();
    for i in 0..4 {
        assert!((world.grain(i).unwrap().velocity[0] - 1.0).abs() < 1e-7);
    }
}

/// A plate with α = A₀ω²/g = 2 is left where sin ωt = 1/2, with the plate's velocity there.
#[test]
fn grains_leave_a_plate_that_falls_away_faster_than_they_do() {
    let (f, a0) = (5.0, 2.0 * G / (std::f64::consts::TAU * 5.0).powi(2));
    let mut memory = Memory::<f64, 1, 10>::new();
    let grains = (0..5).map(|i| Grain::with_mass(0.5, 1.0).at([0.5 + f64::from(i)]));
    let plate = Plane::new([1.0], 0.0, Surface::Hard(0.5)).vibrating(Vibration::new(a0, f));
    let mut world = World::builder(&mut memory)
        .enduring(Enduring::Paper)
        .plane(plate)
        .gravity([-G])
        .rule(HardSphere { restitution: 0.5 })
        .grains(grains)
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(1e-6).unwrap();
    assert_eq!(at_rest(world.view()), 5, "{:?}", world.statistics());
    let leaves = (0.5_f64).asin() / (std::f64::consts::TAU * f);
    world.advance_to(leaves - 1e-7).unwrap();
    assert_eq!(at_rest(world.view()), 5);
    let rides = world.grain(4).unwrap().position[0] - 4.5;
    assert!((rides - 0.5 * a0).abs() < 1e-6, "{rides}");
    world.advance_to(leaves + 1e-7).unwrap();
    assert_eq!(at_rest(world.view()), 0, "{:?}", world.statistics());
    let speed = a0 * std::f64::consts::TAU * f * 0.75_f64.sqrt();
    for i in 0..5 {
        let grain = world.grain(i).unwrap();
        assert!((grain.velocity[0] - speed).abs() < 1e-5);
    }
    // They land together where the parabola crosses the sine again.
    let flight = |t: f64| 0.5 * a0 + speed * t - 0.5 * G * t * t;
    let plate = |t: f64| a0 * (std::f64::consts::TAU * f * (leaves + t)).sin();
    let (mut low, mut high) = (0.02, 0.15);
    assert!(flight(low) > plate(low) && flight(high) < plate(high));
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if flight(middle) > plate(middle) { low = middle } else { high = middle }
    }
    world.advance_to(leaves + low - 1e-6).unwrap();
    let before = world.statistics().plane_collisions;
    world.advance_to(leaves + low + 1e-6).unwrap();
    assert!(world.statistics().plane_collisions > before);
}

/// L94 §IV: ε_eff = 0.341 ± 0.002 for N = 10, ε = 0.9, its wall, whatever s₀ is.
#[test]
fn an_event_driven_column_loses_what_luding_found() {
    // ε = exp(−π μ/√(ω₀² − μ²)) for a pair; at the wall the mass is twice the reduced mass and μ half.
    let ratio = -0.9_f64.ln() / std::f64::consts::PI;
    let omega2 = 1.0 + 1.0 / (ratio * ratio);
    let wall = (-std::f64::consts::PI * 0.5 / (0.5 * omega2 - 0.25).sqrt()).exp();
    for gap in [0.0, 1e-7, 1e-5, 1e-3, 1e-2] {
        let mut memory = Memory::<f64, 1, 10>::new();
        let grain = |i| Grain::with_mass(0.5e-3, 1.0).at([0.5e-3 + f64::from(i) * (1e-3 + gap)]);
        let mut world = World::builder(&mut memory)
            .enduring(Enduring::Paper)
            .plane(Plane::new([1.0], 0.0, Surface::Hard(wall)))
            .rule(HardSphere { restitution: 0.9 })
            .grains((0..10).map(|i| grain(i).moving([-0.2])))
            .unwrap()
            .start()
            .unwrap();
        let before = world.view().kinetic_energy();
        while world.step().unwrap().is_some() {}
        let effective = (world.view().kinetic_energy() / before).sqrt();
        assert!((effective - 0.3415).abs() < 5e-4, "{gap}: {effective}");
    }
}

/// Soft grains rest where their hop would be shorter than the contact.
#[test]
fn soft_grains_come_to_rest() {
    let law = LinearDashpot { stiffness: 1e7, damping: 200.0 };
    let mut memory = Memory::<f64, 1, 3>::new();
    let grains = (0..3).map(|i| Grain::with_mass(0.05, 1.0).at([0.06 + f64::from(i) * 0.11]));
    let mut world = World::builder(&mut memory)
        .plane(Plane::new([1.0], 0.0, Surface::Rule))
        .gravity([-G])
        .rule(Soft::linear_dashpot(law, Outside::HardSphere))
        .grains(grains)
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(30.0).unwrap();
    assert_eq!(at_rest(world.view()), 3, "{:?}", world.statistics());
}

/// Three grains that collapse in free space (ε below 7 − 4√3): after the collapse they part.
#[test]
fn a_collapse_in_free_space_ends() {
    for epsilon in [0.0, 0.01, 0.05] {
        let mut memory = Memory::<f64, 1, 3>::new();
        let at = |x: f64, v: f64| Grain::with_mass(0.5, 1.0).at([x]).moving([v]);
        let mut world = World::builder(&mut memory)
            .enduring(Enduring::Paper)
            .rule(HardSphere { restitution: epsilon })
            .grains([at(0.0, 1.0), at(2.0, 0.0), at(4.0, -1.0)])
            .unwrap()
            .start()
            .unwrap();
        world.advance_to(1.0e3).unwrap();
        let spread = world.grain(2).unwrap().position[0] - world.grain(0).unwrap().position[0];
        assert!((2.0 - 1e-9..2.1).contains(&spread), "{epsilon}: {spread}");
        assert!(world.next_event_time().is_none());
    }
}
