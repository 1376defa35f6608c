//! What is a rule asked? A rule that writes down its impacts; compares the closed forms of MP13 and of a fall.

use carom::law::{Answer, Impact, Response, Rule};
use carom::space::{Plane, Surface};
use carom::{Grain, Memory, World};
use std::cell::Cell;

/// Answers as an elastic hard sphere, and keeps what it was asked.
struct Listener<'a>(&'a Cell<Option<Impact<f64>>>);

impl Rule<f64> for Listener<'_> {
    fn collide(&self, impact: &Impact<f64>) -> Answer<f64> {
        self.0.set(Some(*impact));
        Answer::exact(Response::Instantaneous(1.0))
    }
}

/// What is asked of a grain of radius 1/4 that hits the floor with this speed under gravity g.
fn on_the_floor(speed: f64, g: f64) -> Impact<f64> {
    let heard = Cell::new(None);
    let mut memory = Memory::<f64, 2, 1>::new();
    let mut world = World::builder(&mut memory)
        .plane(Plane::new([0.0, 1.0], 0.0, Surface::Rule))
        .gravity([0.0, -g])
        .rule(Listener(&heard))
        .grain(Grain::with_mass(0.25, 3.0).at([0.0, 0.25]).moving([7.0, -speed]).of_material(2))
        .unwrap()
        .start()
        .unwrap();
    assert_eq!(world.step().unwrap().unwrap().at.as_f64(), 0.0);
    heard.take().unwrap()
}

/// Below the speed of a fall through 5e-7 R, (2 g · 5e-7 R)^½, the weight and not the impact says how long a
/// contact lasts, and it is given the duration of that speed; above, and without gravity, the speed is the impact's own.
#[test]
fn a_wall_asks_for_the_impact_s_own_speed_down_to_a_fall_through_a_millionth_of_the_radius() {
    let (radius, g) = (0.25_f64, 16.0);
    let floor = (2.0 * g * 5e-7 * radius).sqrt();
    for faster in [1.01, 1.1, 2.0, 10.0, 1e3] {
        assert_eq!(on_the_floor(faster * floor, g).normal_speed, faster * floor);
    }
    for slower in [0.5, 0.1, 1e-3] {
        let asked = on_the_floor(slower * floor, g).normal_speed;
        assert!((asked / floor - 1.0).abs() < 1e-12, "{slower}: {asked}");
        assert_eq!(on_the_floor(slower * floor, 0.0).normal_speed, slower * floor);
    }
    // The other body is infinitely heavy and flat: m_eff = m, l = R_eff = R, and nothing turns.
    let wall = Impact {
        contact_distance: 0.25,
        effective_radius: 0.25,
        reduced_mass: 3.0,
        normal_speed: 1.0,
        tangential_speed: 0.0,
        materials: [2, 2],
    };
    assert_eq!(on_the_floor(1.0, g), wall);
}

/// MP13 Eq. (5) and below Eq. (52) for grains that differ in everything; the velocities along and across the
/// line of centres, which lies in the direction (3, 4)/5.
#[test]
fn a_pair_is_asked_for_its_reduced_mass_effective_radius_and_both_speeds() {
    let heard = Cell::new(None);
    let mut memory = Memory::<f64, 2, 2>::new();
    let mut world = World::builder(&mut memory)
        .rule(Listener(&heard))
        .grain(Grain::with_mass(4.0, 3.0).moving([2.0, 1.0]).of_material(1))
        .unwrap()
        .grain(Grain::with_mass(1.0, 6.0).at([3.0, 4.0]).moving([-0.5, 1.0]).of_material(3))
        .unwrap()
        .start()
        .unwrap();
    assert_eq!(world.step().unwrap().unwrap().at.as_f64(), 0.0);
    let impact: Impact<f64> = heard.take().unwrap();
    let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-14, "{impact:?}: {a} for {b}");
    near(impact.contact_distance, 5.0);
    near(impact.effective_radius, 0.8);
    near(impact.reduced_mass, 2.0);
    near(impact.normal_speed, 1.5);
    near(impact.tangential_speed, 2.0);
    assert_eq!(impact.materials, [1, 3]);
}
