//! Does friction hold and let go where mechanics says? Balls that roll, slide and stand, against closed forms.

use carom::law::{HardSphere, Rough, Tangential};
use carom::space::{ContactState, Plane, Surface};
use carom::world::{Rotating, WithContacts};
use carom::{Grain, Memory, World};

const G: f64 = 9.81;
const R: f64 = 0.01;

fn rule(mu: f64, inertia: f64) -> Rough<HardSphere<f64>, f64> {
    let (normal, tangential) =
        (HardSphere { restitution: 0.5 }, Tangential::Walton { mu, beta_0: 0.3 });
    Rough { inertia, ..Rough::spheres(normal, tangential) }
}

/// Speed and ω of a ball on a floor that leans by this angle, after this time; it begins with a speed.
fn ball(mu: f64, angle: f64, speed: f64, time: f64) -> [f64; 2] {
    let memory = WithContacts::new(Memory::<f64, 2, 1>::new(), [ContactState::VACANT; 1]);
    let mut memory = Rotating::new(memory, [[0.0]; 3]);
    let mut world = World::builder(&mut memory)
        .plane(Plane::new([0.0, 1.0], 0.0, Surface::Rule))
        .gravity([G * angle.sin(), -G * angle.cos()])
        .rule(rule(mu, 0.4))
        .grain(Grain::with_mass(R, 1.0).at([0.0, R]).moving([speed, 0.0]))
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(time).unwrap();
    [world.grain(0).unwrap().velocity.x, world.view().angular_velocity(0).unwrap()[2]]
}

#[test]
fn a_ball_that_slides_begins_to_roll() {
    let (mu, v0) = (0.3, 1.0);
    let rolls = 2.0 / 7.0 * v0 / (mu * G);
    // While it slides friction is what it can be, and turns the ball.
    let [v, w] = ball(mu, 0.0, v0, rolls / 2.0);
    assert!((v - (v0 - mu * G * rolls / 2.0)).abs() < 2e-3, "{v}");
    assert!((w * R + 2.5 * mu * G * rolls / 2.0).abs() < 5e-3, "{w}");
    for time in [1.1, 2.0, 10.0] {
        let [v, w] = ball(mu, 0.0, v0, time * rolls);
        assert!((v - 5.0 / 7.0).abs() < 1e-3, "{time}: {v}");
        assert!((w * R + v).abs() < 1e-3, "{time}: {v} {w}");
    }
}

#[test]
fn a_ball_on_an_incline_rolls_or_slides() {
    let (mu, time) = (0.2, 0.2);
    let steep = f64::atan(3.5 * mu);
    for angle in [0.3 * steep, 0.9 * steep] {
        let [v, w] = ball(mu, angle, 0.0, time);
        let wanted = 5.0 / 7.0 * G * angle.sin() * time;
        assert!((v / wanted - 1.0).abs() < 5e-3, "{angle}: {v} {wanted}");
        assert!((w * R / -v - 1.0).abs() < 5e-3);
    }
    for angle in [1.1 * steep, 1.5 * steep] {
        let [v, w] = ball(mu, angle, 0.0, time);
        let wanted = G * (angle.sin() - mu * angle.cos()) * time;
        assert!((v / wanted - 1.0).abs() < 5e-3, "{angle}: {v} {wanted}");
        assert!((w * R / (-2.5 * mu * G * angle.cos() * time) - 1.0).abs() < 5e-3, "{w}");
    }
}

/// How far apart two cylinders are, under a third that lies on both, after a while.
fn three_cylinders(mu: f64, time: f64) -> (f64, bool) {
    let memory = WithContacts::new(Memory::<f64, 2, 3>::new(), [ContactState::VACANT; 8]);
    let mut memory = Rotating::new(memory, [[0.0; 3]; 3]);
    let cylinder = |x: f64, y: f64| Grain::with_mass(R, 1.0).at([x, y]);
    let mut world = World::builder(&mut memory)
        .plane(Plane::new([0.0, 1.0], 0.0, Surface::Rule))
        .gravity([0.0, -G])
        .rule(rule(mu, 0.5))
        .grains([
            cylinder(-R, R),
            cylinder(R, R),
            cylinder(0.0, R + R * 3_f64.sqrt() * (1.0 + 1e-9)),
        ])
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(time).unwrap();
    let apart = world.grain(1).unwrap().position.x - world.grain(0).unwrap().position.x;
    (apart / R, world.next_event_time().is_none())
}

/// Statics of the three that sleep: each of the lower two is pressed by W/2 along the line of centres and dragged by
/// W (2 − √3)/2 across it, which the plane holds against; the plane bears the weight of all.
#[test]
fn what_sleeps_is_held_by_friction_too() {
    let memory = WithContacts::new(Memory::<f64, 2, 3>::new(), [ContactState::VACANT; 8]);
    let mut memory = Rotating::new(memory, [[0.0; 3]; 3]);
    let cylinder = |x: f64, y: f64| Grain::with_mass(R, 1.0).at([x, y]);
    let mut world = World::builder(&mut memory)
        .plane(Plane::new([0.0, 1.0], 0.0, Surface::Rule))
        .gravity([0.0, -G])
        .rule(rule(0.5, 0.5))
        .grains([
            cylinder(-R * 1.0001, R),
            cylinder(R * 1.0001, R),
            cylinder(0.0, R + R * 3_f64.sqrt() * (1.0 + 1e-3)),
        ])
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(5.0).unwrap();
    assert!(world.next_event_time().is_none());
    let (mut above, mut below) = (Vec::new(), Vec::new());
    world.for_each_resting_contact(|contact, _| match contact.partner.as_grain() {
        // The force on the upper one.
        Some(with) => {
            let sign = if contact.grain == 2 { 1.0 } else { -1.0 };
            assert!(contact.grain == 2 || with == 2, "the lower two do not touch");
            above.push(contact.impulse * sign);
        }
        None => below.push(contact.impulse),
    });
    let (weight, across) = (G, 0.5 * G * (2.0 - 3_f64.sqrt()));
    assert_eq!([above.len(), below.len()], [2, 2]);
    for force in &above {
        assert!((force.y / (0.5 * weight) - 1.0).abs() < 2e-3, "{force:?}");
        assert!((force.x.abs() / across - 1.0).abs() < 2e-2, "{force:?} {across}");
        assert!((force.norm() / (0.5 * weight).hypot(across) - 1.0).abs() < 5e-3);
    }
    for force in &below {
        assert!((force.y / (1.5 * weight) - 1.0).abs() < 2e-3, "{force:?}");
        assert!((force.x.abs() / across - 1.0).abs() < 2e-2, "{force:?} {across}");
    }
}

#[test]
fn three_cylinders_stand_on_a_plane_that_is_rough_enough() {
    // μ ≥ 2 − √3 = 0.268.
    let (apart, sleeps) = three_cylinders(0.27, 3.0);
    assert!((apart - 2.0).abs() < 0.02 && sleeps, "{apart} {sleeps}");
    let (apart, _) = three_cylinders(0.265, 3.0);
    assert!(apart > 3.0, "{apart}");
}
