//! What is a rule asked? A rule that writes down its impacts; compares the closed forms of MP13 and of a fall.

use carom::law::{Answer, Central, Impact, LinearDashpot, Outcome, Response, Rule};
use carom::law::{Outside, Soft, Viscoelastic};
use carom::space::{Plane, Surface, Vibration};
use carom::world::EventOutcome;
use carom::{Enduring, Grain, Memory, World};
use carom_host::integrated::Integrated;
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
        .enduring(Enduring::Paper)
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
        acceleration: g,
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

/// On a plate what presses is g_n less its acceleration: at the top of a plate with A₀ω² = 3g/4 a quarter is left.
#[test]
fn a_plate_at_its_top_asks_with_what_is_left_of_the_weight() {
    let (radius, g, f) = (0.25_f64, 16.0_f64, 1.0);
    let a0 = 0.75 * g / std::f64::consts::TAU.powi(2);
    let heard = Cell::new(None);
    let plate = Plane::new([0.0, 1.0], 0.0, Surface::Rule);
    let mut memory = Memory::<f64, 2, 1>::new();
    let mut world = World::builder(&mut memory)
        .plane(plate.vibrating(Vibration::new(a0, f).starting_at(0.25)))
        .gravity([0.0, -g])
        .rule(Listener(&heard))
        .grain(Grain::with_mass(radius, 3.0).at([0.0, radius + a0]).moving([0.0, -1e-5]))
        .unwrap()
        .start()
        .unwrap();
    world.step().unwrap();
    let asked = heard.take().unwrap().normal_speed;
    assert!((asked / (1e-3 * (0.25 * g * radius).sqrt()) - 1.0).abs() < 1e-6, "{asked}");
}

/// A soft lid holds a grain under gravity only if gravity would not pull it off visibly: g τ² > R/8, with
/// τ = (π − 2 arctan(1/4)) (m/k)^½ under the largest load that is reckoned with, is an instantaneous collision, and
/// counted.
#[test]
fn a_soft_lid_from_which_gravity_pulls_is_hit_as_a_hard_one() {
    let (radius, mass, stiffness) = (0.5, 2.0_f64, 1.0e4);
    let tau = (std::f64::consts::PI - 2.0 * 0.25_f64.atan()) * (mass / stiffness).sqrt();
    for (part, hard) in [(0.99, false), (1.01, true)] {
        let g = part * radius / 8.0 / (tau * tau);
        let mut memory = Memory::<f64, 1, 1>::new();
        let mut world = World::builder(&mut memory)
            .enduring(Enduring::Paper)
            .plane(Plane::new([-1.0], -1.0, Surface::Rule))
            .gravity([-g])
            .rule(Integrated::new(LinearDashpot { stiffness, damping: 0.0 }))
            .grain(Grain::with_mass(radius, mass).at([0.5]).moving([1.0]))
            .unwrap()
            .start()
            .unwrap();
        let outcome = world.step().unwrap().unwrap().outcome;
        assert_eq!(matches!(outcome, Some(EventOutcome::Collision { .. })), hard, "{outcome:?}");
        assert_eq!(world.statistics().hard_sphere, u64::from(hard));
    }
}

fn lasting(rule: impl Rule<f64>, impact: &Impact<f64>) -> Outcome<f64> {
    match rule.collide(impact).response {
        Response::Lasting(outcome) => outcome,
        other => panic!("{other:?}"),
    }
}

const IMPACT: Impact<f64> = Impact {
    contact_distance: 0.02,
    effective_radius: 0.005,
    reduced_mass: 2e-3,
    normal_speed: 0.5,
    tangential_speed: 0.0,
    acceleration: 0.0,
    materials: [0, 0],
};

/// Hertz's contact lasts 2.94 δ/v with δ the depth at rest, ρ δ^{5/2} = (5/4) m v²; a viscoelastic one gives
/// back 1 − C₁x + (3/5)C₁²x² with x = (3/2) A (ρ/m)^{2/5} v^{1/5} and C₁ = 1.15344 (Ramírez et al., Phys. Rev. E 60,
/// 4465, 1999) and, where a contact ends as its force does, more of the order of x^{5/2}.
#[test]
fn viscoelastic_spheres_touch_as_long_as_hertz_has_it_and_lose_what_ramirez_found() {
    let (m, v) = (IMPACT.reduced_mass, IMPACT.normal_speed);
    for poisson in [0.0, 0.3, 0.5_f64] {
        let young = 5.0e6;
        let rho = 2.0 / 3.0 * young * IMPACT.effective_radius.sqrt() / (1.0 - poisson * poisson);
        let dissipation = 0.01 / (1.5 * (rho / m).powf(0.4) * v.powf(0.2));
        let elastic = Viscoelastic { young, poisson, dissipation: 0.0 };
        let lossy = Viscoelastic { dissipation, ..elastic };
        assert!(Rule::check(&Soft::viscoelastic(lossy, Outside::Reject)).is_ok());
        let depth = (1.25 * m * v * v / rho).powf(0.4);
        let duration = lasting(Integrated::new(elastic), &IMPACT).duration;
        assert!((duration / (2.943_275 * depth / v) - 1.0).abs() < 1e-5, "{poisson}: {duration}");
        let epsilon = lasting(Integrated::new(lossy), &IMPACT).restitution;
        let series = 1.0 - 1.153_44e-2 + 0.6 * 1.153_44e-2_f64.powi(2);
        assert!((epsilon - series).abs() < 1e-5, "{poisson}: {epsilon} for {series}");
    }
}

/// ε(v_n) is that of the head-on impact, however oblique the impact is.
#[test]
fn the_central_rule_does_not_ask_for_the_speed_across() {
    let rule = Central(Integrated::new(LinearDashpot { stiffness: 1.0e3, damping: 0.5 }));
    let oblique = Impact { tangential_speed: 2.0, ..IMPACT };
    assert_eq!(rule.collide(&oblique), rule.collide(&IMPACT));
    let Response::Instantaneous(epsilon) = rule.collide(&IMPACT).response else { panic!() };
    assert!((lasting(rule.0, &oblique).restitution - epsilon).abs() > 1e-3);
}
