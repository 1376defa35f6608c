//! Do rough grains that hop feel friction? In the papers' mode, under gravity: balls that slide and roll, a layer on a shaken plate.

use crate::pair::{random, seeded, spheres};
use carom::law::{Answer, ContactForce, HardSphere, Impact, Response, Rough, Rule, Tangential};
use carom::space::{Plane, Surface, Vibration};
use carom::world::Rotating;
use carom::{Enduring, Error, Grain, Memory, World};

const MU: f64 = 0.3;

fn rule(inertia: f64) -> Rough<HardSphere<f64>, f64> {
    let law = Tangential::Walton { mu: MU, beta_0: 0.0 };
    Rough { inertia, ..Rough::spheres(HardSphere { restitution: 0.5 }, law) }
}

/// How long the first hop lasts, and t_c.
type Hops = [f64; 2];

/// Short ones, of which the second is too short to be one; longer ones, under the TC rule.
const SHORT: Hops = [2e-3, 0.0];
const LONG: Hops = [0.04, 0.08];

/// Speed, ω, and the energy of the hops of a ball (R = g = 1) on a floor that leans by this angle, after this time; it
/// begins with a speed.
fn ball(angle: f64, speed: f64, time: f64, [hop, t_c]: Hops) -> [f64; 3] {
    let mut memory = Rotating::new(Memory::<f64, 2, 1>::new(), [[0.0]; 3]);
    let mut world = World::builder(&mut memory)
        .plane(Plane::new([0.0, 1.0], 0.0, Surface::Rule))
        .gravity([angle.sin(), -angle.cos()])
        .enduring(Enduring::Paper)
        .tc(t_c)
        .rule(rule(0.4))
        .grain(Grain::with_mass(1.0, 1.0).at([0.0, 1.0 + hop * hop / 8.0]).moving([speed, 0.0]))
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(time).unwrap();
    assert_eq!(world.statistics().rests, 0);
    let ball = world.grain(0).unwrap();
    let hops = ball.velocity.y.powi(2) / 2.0 + (ball.position.y - 1.0) * angle.cos();
    [ball.velocity.x, world.view().angular_velocity(0).unwrap()[2], hops]
}

/// It hops on the plane; each time friction has what gravity gave since the last. Only the first touch is lossy.
#[test]
fn a_ball_that_hops_and_slides_begins_to_roll() {
    for hops in [SHORT, LONG] {
        let (rolls, hop) = (2.0 / 7.0 / MU, hops[0] / 2.0);
        let [v, w, energy] = ball(0.0, 1.0, rolls / 2.0, hops);
        assert!((v - (1.0 - MU * rolls / 2.0)).abs() < MU * 2.0 * hop, "{v}");
        assert!((w + 2.5 * MU * rolls / 2.0).abs() < 2.5 * MU * 2.0 * hop, "{w}");
        assert!((energy / (hop * hop / 8.0) - 1.0).abs() < 1e-9, "{energy}");
        for time in [1.2, 2.0, 10.0] {
            let [v, w, energy] = ball(0.0, 1.0, time * rolls, hops);
            assert!((v - 5.0 / 7.0).abs() < 1e-12, "{time}: {v}");
            assert!((w + v).abs() < 1e-12, "{time}: {v} {w}");
            assert!((energy / (hop * hop / 8.0) - 1.0).abs() < 1e-9, "{energy}");
        }
    }
}

#[test]
fn a_ball_that_hops_down_an_incline_rolls_or_slides() {
    let (steep, time) = (f64::atan(3.5 * MU), 2.0);
    for (hops, error) in [(SHORT, 2e-3), (LONG, 2e-2)] {
        for angle in [0.3 * steep, 0.9 * steep] {
            let [v, w, _] = ball(angle, 0.0, time, hops);
            assert!((v / (5.0 / 7.0 * angle.sin() * time) - 1.0).abs() < error, "{angle}: {v}");
            assert!((w / -v - 1.0).abs() < 2.0 * error, "{angle}: {v} {w}");
        }
        for angle in [1.1 * steep, 1.3 * steep] {
            let [v, w, _] = ball(angle, 0.0, time, hops);
            let wanted = (angle.sin() - MU * angle.cos()) * time;
            assert!((v / wanted - 1.0).abs() < 2.0 * error, "{angle}: {v} {wanted}");
            let turned = -2.5 * MU * angle.cos() * time;
            assert!((w / turned - 1.0).abs() < 2.0 * error, "{angle}: {w}");
        }
    }
}

/// A plate that goes down ever slower catches a ball without weight, which hops on it, and throws it as it comes up.
#[test]
fn a_ball_without_weight_is_caught_and_thrown() {
    let mut memory = Rotating::new(Memory::<f64, 2, 1>::new(), [[0.0]; 3]);
    let plate = Plane::new([0.0, 1.0], 0.0, Surface::Rule).vibrating(Vibration::new(0.5, 0.25));
    let fastest = 0.25 * std::f64::consts::PI;
    let mut world = World::builder(&mut memory)
        .plane(plate)
        .enduring(Enduring::Paper)
        .rule(rule(0.4))
        // At t = 2, when the plate is as fast, it is above it by 0.02.
        .grain(Grain::with_mass(1.0, 1.0).at([0.0, 1.02 + 2.0 * fastest]).moving([0.0, -fastest]))
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(20.0).unwrap();
    let v = world.grain(0).unwrap().velocity.y;
    assert!((v / fastest - 1.0).abs() < 0.02, "{v} {fastest}");
    assert!(world.statistics().plane_collisions > 20 && world.statistics().rests == 0);
}

/// Gravity that comes later finds rough grains hopping, too.
#[test]
fn gravity_may_come_later() {
    let mut memory = Rotating::new(Memory::<f64, 2, 1>::new(), [[0.0]; 3]);
    let mut world = World::builder(&mut memory)
        .plane(Plane::new([0.0, 1.0], 0.0, Surface::Rule))
        .enduring(Enduring::Paper)
        .rule(rule(0.4))
        .grain(Grain::with_mass(1.0, 1.0).at([0.0, 1.1]).moving([1.0, 0.0]))
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(1.0).unwrap();
    world.set_gravity([0.0, -1.0]).unwrap();
    world.advance_to(9.0).unwrap();
    assert!((world.grain(0).unwrap().velocity.x - 5.0 / 7.0).abs() < 1e-12);
    assert_eq!(world.statistics().rests, 0);
}

/// ε falls with the speed, so that a layer that lies on its plate does not collapse at once.
#[derive(Clone, Copy, Debug)]
struct Falling;

impl Rule<f64> for Falling {
    fn collide(&self, impact: &Impact<f64>) -> Answer<f64> {
        let speed = impact.normal_speed.min(1.0);
        Answer::exact(Response::Instantaneous(1.0 - 0.3 * speed.powf(0.75)))
    }
}

/// Momentum, and the kinetic energy beside the centre's, of grains of mass 1.
fn moments<R: Rule<f64>>(world: &World<'_, f64, 3, R>) -> ([f64; 3], f64) {
    let view = world.view();
    let momentum: [f64; 3] = view.momentum().into();
    let centre = momentum.iter().map(|p| p * p).sum::<f64>() / (2.0 * view.len() as f64);
    (momentum, view.kinetic_energy() + view.rotational_energy(0.4) - centre)
}

/// A layer is thrown and caught by its plate. Whenever it flies it falls as its centre does, and only loses energy.
#[test]
fn a_layer_on_a_shaken_plate_flies_as_mechanics_says() {
    let (side, count, rate) = (5.1, 150, 0.12);
    let plate = Plane::new([0.0, 0.0, 1.0], 0.0, Surface::Rule);
    let amplitude = 3.0 / (std::f64::consts::TAU * rate).powi(2);
    let mut memory = spheres(vec![[0.0; 3]; count]);
    let mut rng = seeded(3);
    let sphere = |k: usize| {
        let at = [k % 5, k / 5 % 5, k / 25].map(|n| 1.02 * n as f64 + 0.51);
        Grain::with_mass(0.5, 1.0).at(at).moving(random(&mut rng, 0.1))
    };
    let mut world = World::builder(&mut memory)
        .periodic_axis(0, [0.0, side])
        .periodic_axis(1, [0.0, side])
        .plane(plate.vibrating(Vibration::new(amplitude, rate)))
        .gravity([0.0, 0.0, -1.0])
        .enduring(Enduring::Paper)
        .rule(Rough::spheres(Falling, Tangential::Walton { mu: 0.5, beta_0: 0.35 }))
        .grains((0..count).map(sphere))
        .unwrap()
        .start()
        .unwrap();
    let (mut flights, mut touches, mut before) = (0, 0, (0.0, moments(&world)));
    for slice in 1..=400 {
        let now = 0.2 * f64::from(slice);
        world.advance_to(now).unwrap();
        let (momentum, energy) = moments(&world);
        let plate = world.statistics().plane_collisions;
        let (then, ([px, py, pz], most)) = before;
        if plate == touches {
            flights += 1;
            let wanted = [px, py, pz - count as f64 * (now - then)];
            let off = momentum.iter().zip(wanted).map(|(p, q)| (p - q).abs());
            assert!(off.fold(0.0, f64::max) < 1e-9, "{now}: {momentum:?} {wanted:?}");
            assert!(energy < most + 1e-9, "{now}: {energy} {most}");
        }
        (touches, before) = (plate, (now, (momentum, energy)));
    }
    assert!((100..350).contains(&flights), "{flights}");
    assert_eq!(world.statistics().rests, 0);
    assert!(world.statistics().collisions > 50 * count as u64);
}

/// On a floor that shakes, too, a spinning ball ends up rolling, with the angular momentum about the contact that it had.
#[test]
fn a_spinning_ball_on_a_shaking_floor_ends_up_rolling() {
    let mut memory = Rotating::new(Memory::<f64, 2, 1>::new(), [[-7.0], [0.0], [0.0]]);
    let floor = Plane::new([0.0, 1.0], 0.0, Surface::Rule).vibrating(Vibration::new(0.2, 0.5));
    let mut world = World::builder(&mut memory)
        .plane(floor)
        .gravity([0.0, -1.0])
        .enduring(Enduring::Paper)
        .rule(rule(0.4))
        .grain(Grain::with_mass(1.0, 1.0).at([0.0, 1.5]))
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(100.0).unwrap();
    // (2/5) 7 = (7/5) v.
    assert!((world.grain(0).unwrap().velocity.x - 2.0).abs() < 1e-12);
    assert!((world.view().angular_velocity(0).unwrap()[2] + 2.0).abs() < 1e-12);
}

/// Hard among themselves, soft beside the material 1.
#[derive(Clone, Copy, Debug)]
struct SoftBesideOne;

impl Rule<f64> for SoftBesideOne {
    fn collide(&self, _: &Impact<f64>) -> Answer<f64> {
        Answer::exact(Response::Instantaneous(0.9))
    }
    fn force(&self, impact: &Impact<f64>, overlap: f64) -> Option<ContactForce<f64>> {
        let elastic = 100.0 * overlap;
        let soft = impact.materials.contains(&1);
        soft.then_some(ContactForce { elastic, damping: 0.0 })
    }
}

/// Contacts that last have no friction in this mode: not those of a grain that comes later either.
#[test]
fn a_soft_grain_may_not_come_later() {
    let start = |materials: [u8; 2]| {
        let mut memory = spheres(vec![[0.0; 3]; 2]);
        let [first, later] =
            materials.map(|material| Grain { material, ..Grain::with_mass(0.5, 1.0) });
        let mut world = World::builder(&mut memory)
            .enduring(Enduring::Paper)
            .rule(Rough::spheres(SoftBesideOne, Tangential::Constant { beta: 0.5 }))
            .grain(first)?
            .reserve(1)?
            .start()?;
        world.add(later.at([3.0, 0.0, 0.0]))
    };
    assert_eq!(start([0, 0]), Ok(1));
    for materials in [[0, 1], [1, 0]] {
        assert!(start(materials).unwrap_err().to_string().contains("rough surfaces"));
    }
}

/// A ball that is laid down has no hop: the collapse is reported.
#[test]
fn a_rough_ball_that_lies_is_stuck() {
    let mut memory = Rotating::new(Memory::<f64, 2, 1>::new(), [[0.0]; 3]);
    let mut world = World::builder(&mut memory)
        .plane(Plane::new([0.0, 1.0], 0.0, Surface::Rule))
        .gravity([0.0, -1.0])
        .enduring(Enduring::Paper)
        .rule(rule(0.4))
        .grain(Grain::with_mass(1.0, 1.0).at([0.0, 1.0]))
        .unwrap()
        .start()
        .unwrap();
    assert!(matches!(world.advance_to(1.0), Err(Error::Stuck { grain: 0, .. })));
    assert!(matches!(world.advance_to(1.0), Err(Error::Stuck { grain: 0, .. })));
}
