//! When is a hop too short to be one, and a collision too soon to lose energy? Single hops; compares times of flight.

use carom::law::{HardSphere, LinearDashpot, Outside, Soft};
use carom::space::{Plane, Surface, Vibration};
use carom::world::{EventKind, EventOutcome};
use carom::{Enduring, Grain, Memory, World};

const G: f64 = 8.0;

/// How often a ball that comes down on a floor of ε = 1/2 with speed 1 hits it before it rests.
fn hits(t_c: f64) -> u64 {
    let mut memory = Memory::<f64, 1, 1>::new();
    let mut world = World::builder(&mut memory)
        .enduring(Enduring::Paper)
        .plane(Plane::new([1.0], 0.0, Surface::Hard(0.5)))
        .gravity([-G])
        .tc(t_c)
        .rule(HardSphere { restitution: 0.5 })
        .grain(Grain::with_mass(0.5, 1.0).at([0.5]).moving([-1.0]))
        .unwrap()
        .start()
        .unwrap();
    while world.step().unwrap().is_some() {
        assert!(world.statistics().plane_collisions < 100, "{t_c}: it hops on");
    }
    assert_eq!(world.statistics().rests, 1);
    world.statistics().plane_collisions
}

/// A grain that would be back within t_c lies still: the n-th hop lasts 2 v/g with v = 2^−n.
#[test]
fn a_grain_that_would_be_back_within_t_c_lies_still() {
    for n in 1..6 {
        let hop = 2.0 * 0.5_f64.powi(n) / G;
        assert_eq!(hits(1.001 * hop), n as u64);
        assert_eq!(hits(0.999 * hop), n as u64 + 1);
    }
}

/// A grain that is put onto an elastic floor lies there.
#[test]
fn a_grain_without_speed_lies_on_an_elastic_floor() {
    let mut memory = Memory::<f64, 1, 1>::new();
    let mut world = World::builder(&mut memory)
        .enduring(Enduring::Paper)
        .plane(Plane::new([1.0], 0.0, Surface::Hard(1.0)))
        .gravity([-G])
        .rule(HardSphere { restitution: 1.0 })
        .grain(Grain::with_mass(0.5, 1.0).at([0.5]))
        .unwrap()
        .start()
        .unwrap();
    assert_eq!(world.step().unwrap().unwrap().outcome, Some(EventOutcome::CameToRest));
    assert!(world.step().unwrap().is_none());
}

/// On a soft floor a hop that is shorter than the contact, (π + 1/2) (m/k)^½ under the largest load that is reckoned
/// with, is none, though nothing is lost.
#[test]
fn a_hop_shorter_than_a_soft_contact_is_none() {
    let law = LinearDashpot { stiffness: 1.0e4, damping: 0.0 };
    let contact = (std::f64::consts::PI + 0.5) * (2.0_f64 / 1.0e4).sqrt();
    for (part, rests) in [(0.99, true), (1.01, false)] {
        let speed = part * contact * G / 2.0;
        let mut memory = Memory::<f64, 1, 1>::new();
        let mut world = World::builder(&mut memory)
            .enduring(Enduring::Paper)
            .plane(Plane::new([1.0], 0.0, Surface::Rule))
            .gravity([-G])
            .rule(Soft::linear_dashpot(law, Outside::Reject))
            .grain(Grain::with_mass(0.5, 2.0).at([0.5]).moving([-speed]))
            .unwrap()
            .start()
            .unwrap();
        let outcome = world.step().unwrap().unwrap().outcome;
        assert_eq!(outcome == Some(EventOutcome::CameToRest), rests, "{part}: {outcome:?}");
    }
}

/// The TC rule counts from the last collision of either grain (Luding & McNamara 1998): the second of two
/// collisions of the grain in the middle is elastic if it comes within t_c, the other's first though it is.
#[test]
fn a_collision_soon_after_the_last_of_either_grain_is_elastic() {
    for (t_c, restitution) in [(0.26, 1.0), (0.24, 0.5)] {
        let mut memory = Memory::<f64, 1, 3>::new();
        let grain = |x: f64, v: f64| Grain::with_mass(0.5, 1.0).at([x]).moving([v]);
        // The middle one is hit at t = 1, goes on with 3/4 and is at the third, 3/16 away, a quarter later.
        let mut world = World::builder(&mut memory)
            .enduring(Enduring::Paper)
            .tc(t_c)
            .rule(HardSphere { restitution: 0.5 })
            .grains([grain(-2.0, 1.0), grain(0.0, 0.0), grain(1.1875, 0.0)])
            .unwrap()
            .start()
            .unwrap();
        for (at, epsilon) in [(1.0, 0.5), (1.25, restitution)] {
            let event = world.step().unwrap().unwrap();
            assert!((event.at.as_f64() - at).abs() < 1e-12);
            let outcome = Some(EventOutcome::Collision { restitution: epsilon });
            assert_eq!(event.outcome, outcome, "{t_c}");
        }
    }
}

/// A plate that starts downwards is left half a turn later than one that starts upwards: where its
/// acceleration A₀ω² sin ωt is −g, with its velocity there.
#[test]
fn a_plate_that_starts_downwards_is_left_half_a_turn_later() {
    let (f, alpha) = (2.0, 2.0);
    let omega = std::f64::consts::TAU * f;
    let a0 = alpha * G / (omega * omega);
    let mut memory = Memory::<f64, 1, 1>::new();
    let mut world = World::builder(&mut memory)
        .enduring(Enduring::Paper)
        .plane(Plane::new([1.0], 0.0, Surface::Hard(0.0)).vibrating(Vibration::new(-a0, f)))
        .gravity([-G])
        .rule(HardSphere { restitution: 0.0 })
        .grain(Grain::with_mass(0.5, 1.0).at([0.5]))
        .unwrap()
        .start()
        .unwrap();
    let leaves = (std::f64::consts::PI + (1.0 / alpha).asin()) / omega;
    let event = loop {
        let event = world.step().unwrap().unwrap();
        if event.kind == EventKind::TakeOff {
            break event;
        }
    };
    assert!((event.at.as_f64() / leaves - 1.0).abs() < 1e-6, "{} for {leaves}", event.at);
    let speed = a0 * omega * (1.0 - 1.0 / (alpha * alpha)).sqrt();
    assert!((world.grain(0).unwrap().velocity[0] - speed).abs() < 1e-5 * speed);
}

/// A grain that falls onto one that rides on a plate meets it where its parabola crosses the plate's sine two
/// radii higher, whoever of the two has the lower number.
#[test]
fn a_falling_grain_meets_a_rider_where_parabola_and_sine_cross() {
    let (f, alpha) = (2.0, 0.95);
    let omega = std::f64::consts::TAU * f;
    let a0 = alpha * G / (omega * omega);
    for height in [0.01, 0.1, 0.3, 0.7, 1.0, 1.7] {
        for swap in [false, true] {
            let mut grains = [0.5, 1.5 + height].map(|x| Grain::with_mass(0.5, 1.0).at([x]));
            if swap {
                grains.reverse();
            }
            let mut memory = Memory::<f64, 1, 2>::new();
            let plate = Plane::new([1.0], 0.0, Surface::Hard(0.0));
            let mut world = World::builder(&mut memory)
                .enduring(Enduring::Paper)
                .plane(plate.vibrating(Vibration::new(a0, f)))
                .gravity([-G])
                .rule(HardSphere { restitution: 0.5 })
                .grains(grains)
                .unwrap()
                .start()
                .unwrap();
            let meets = loop {
                let event = world.step().unwrap().unwrap();
                if event.kind == EventKind::Collision && event.partner.as_grain().is_some() {
                    break event.at.as_f64();
                }
            };
            let gap = |t: f64| height - 0.5 * G * t * t - a0 * (omega * t).sin();
            assert!(gap(meets).abs() < 1e-12, "{height} {swap}: {:e}", gap(meets));
            // Nothing was missed before.
            let earlier = (0..1000).map(|k| gap(meets * f64::from(k) / 1000.0));
            assert!(earlier.fold(f64::MAX, f64::min) > 0.0, "{height} {swap}");
        }
    }
}
