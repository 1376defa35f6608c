//! Does a soft ball on a floor lose what it should, weight and all? Bounces against the reference MD, and the table's correction against integrated contacts.

use carom::law::{
    Answer, ForceLaw, Impact, LinearDashpot, Outside, Response, Rule, Soft, Viscoelastic,
    embedded::Fine,
};
use carom::space::{Plane, Surface};
use carom::{Enduring, Grain, Memory, World};
use carom_host::integrated::Integrated;
use carom_reference::{Boundary, End, Exact, System};
use carom_tables::contact::{integrate, integrate_loaded};
use carom_tables::read::{self, Groups, Law};

const GRAVITY: f64 = 9.81;
const RADIUS: f64 = 0.1;
const MASS: f64 = 4.775_220_8;
/// Long after any contact here, and long before the ball is back.
const AFTER: f64 = 0.15;

/// A rule that hears nothing of weight, as the engine was once.
struct Weightless<R>(R);

impl<R: Rule<f64>> Rule<f64> for Weightless<R> {
    fn collide(&self, impact: &Impact<f64>) -> Answer<f64> {
        self.0.collide(&Impact { acceleration: 0.0, ..*impact })
    }
    fn force(&self, impact: &Impact<f64>, overlap: f64) -> Option<carom::law::ContactForce<f64>> {
        self.0.force(impact, overlap)
    }
}

/// Height over the floor and velocity of a ball some time after it hit the floor at this speed.
fn bounce(rule: impl Rule<f64>, enduring: Enduring, speed: f64) -> [f64; 2] {
    let mut memory = Memory::<f64, 1, 1>::new();
    let mut world = World::builder(&mut memory)
        .enduring(enduring)
        .gravity([-GRAVITY])
        .plane(Plane::new([1.0], 0.0, Surface::Rule))
        .rule(rule)
        .grain(Grain::with_mass(RADIUS, MASS).at([RADIUS]).moving([-speed]))
        .unwrap()
        .start()
        .unwrap();
    world.advance_to(AFTER).unwrap();
    assert_eq!(world.statistics().plane_collisions, 1);
    assert_eq!(world.statistics().joins, 0, "the pair alone is meant");
    let ball = world.grain(0).unwrap();
    [ball.position[0] - RADIUS, ball.velocity[0]]
}

/// The same by force-based MD, contact integrated to 12 digits.
fn bounce_by_md(law: carom_reference::ForceLaw, speed: f64) -> [f64; 2] {
    let ball = carom_reference::Grain {
        radius: RADIUS,
        mass: MASS,
        position: [RADIUS],
        velocity: [-speed],
    };
    let floor = Boundary::Walls { lo: 0.0, hi: 1e3 };
    let system = System::new(vec![ball], [floor], [-GRAVITY]).unwrap();
    let mut run = Exact::new(system, law, End::Force).unwrap();
    run.advance_to(AFTER).unwrap();
    [run.position(0)[0] - RADIUS, run.velocity(0)[0]]
}

/// Energy over that of the impact.
fn energy([height, velocity]: [f64; 2], speed: f64) -> f64 {
    (velocity * velocity + 2.0 * GRAVITY * height) / (speed * speed)
}

fn compare<L: ForceLaw<f64> + Copy>(law: L, reference: carom_reference::ForceLaw) {
    for enduring in [Enduring::Integrated, Enduring::Paper] {
        for speed in [5.0, 15.0] {
            let exact = bounce_by_md(reference, speed);
            let ours = bounce(Integrated::new(law), enduring, speed);
            let error = energy(ours, speed) - energy(exact, speed);
            assert!(error.abs() < 1e-9, "{reference:?} {enduring:?} {speed}: {error:e}");
            // When it leaves, too.
            assert!((ours[0] - exact[0]).abs() < 1e-9 * RADIUS, "{ours:?} {exact:?}");
            let weightless = bounce(Weightless(Integrated::new(law)), enduring, speed);
            let error = energy(weightless, speed) - energy(exact, speed);
            assert!(error.abs() > 1e-5, "what would this test see? {error:e}");
        }
    }
}

#[test]
fn a_bounce_under_weight_leaves_the_energy_that_md_leaves() {
    let (stiffness, damping) = (2e7, 3e3);
    compare(
        LinearDashpot { stiffness, damping },
        carom_reference::ForceLaw::LinearDashpot { stiffness, damping },
    );
    let (young, poisson, dissipation) = (2e9, 0.4, 5e-5);
    compare(
        Viscoelastic { young, poisson, dissipation },
        carom_reference::ForceLaw::Viscoelastic { young, poisson, dissipation },
    );
}

/// What the engine's rule makes of weight, without the table's own error: the difference to no weight.
fn changes<L: ForceLaw<f64> + Copy>(law: L, rule: &impl Rule<f64>, acceleration: f64) -> [f64; 2] {
    let impact = |acceleration| Impact {
        contact_distance: RADIUS,
        effective_radius: RADIUS,
        reduced_mass: MASS,
        normal_speed: 1.0,
        tangential_speed: 0.0,
        acceleration,
        materials: [0; 2],
    };
    let outcome = |acceleration| match rule.collide(&impact(acceleration)).response {
        Response::Lasting(outcome) => outcome,
        other => panic!("{other:?}"),
    };
    let (with, without) = (outcome(acceleration), outcome(0.0));
    let time = law.scales(&impact(0.0)).time;
    [with.restitution - without.restitution, (with.duration - without.duration) / time]
}

fn integrated_changes(law: Law, c_dis: f64, load: f64) -> [f64; 2] {
    let central = Groups { sin: 0.0, cos: 1.0, eta: 1e-3, c_dis };
    let with = integrate_loaded(law, read::End::Force, &central, load);
    let without = integrate(law, read::End::Force, &central);
    [with.speed - without.speed, with.tau - without.tau]
}

/// In the middle of the tables; the load from what the default mode leaves to pairs, 1/(256 τ), to its tenth.
#[test]
fn the_correction_of_the_linear_law_is_its_closed_form_to_third_order() {
    let stiffness = 2e6;
    let time = (MASS / stiffness).sqrt();
    for c_dis in [0.0, 0.03, 0.1, 0.3, 0.7] {
        let law = LinearDashpot { stiffness, damping: c_dis * MASS / time };
        let rule = Soft::embedded(law, Fine, Outside::Reject);
        for load in [-1e-3, 1e-4, 1e-3, 1e-2] {
            let [speed, tau] = changes(law, &rule, load / time);
            let [exact_speed, exact_tau] = integrated_changes(Law::LinearDashpot, c_dis, load);
            // The table gives ε with an error of its own, which the correction is multiplied by.
            let most = 40.0 * load.abs().powi(3) + 1e-4 * load.abs();
            assert!(
                (speed - exact_speed).abs() < most,
                "{c_dis} {load}: {speed:e} {exact_speed:e}"
            );
            assert!((tau - exact_tau).abs() < 4.0 * most, "{c_dis} {load}: {tau:e} {exact_tau:e}");
        }
    }
}

#[test]
fn the_correction_of_viscoelastic_spheres_is_of_first_order() {
    let (young, poisson) = (1e9, 0.4);
    let of = |dissipation| Viscoelastic { young, poisson, dissipation };
    let impact = Impact {
        contact_distance: RADIUS,
        effective_radius: RADIUS,
        reduced_mass: MASS,
        normal_speed: 1.0,
        tangential_speed: 0.0,
        acceleration: 0.0,
        materials: [0; 2],
    };
    let time = of(0.0).scales(&impact).time;
    for c_dis in [0.0, 0.03, 0.1, 0.3, 0.7] {
        let law = of(c_dis * time / 1.5);
        let rule = Soft::embedded(law, Fine, Outside::Reject);
        for load in [-1e-3, 1e-4, 1e-3] {
            let [speed, tau] = changes(law, &rule, load / time);
            let [exact_speed, exact_tau] = integrated_changes(Law::Viscoelastic, c_dis, load);
            let (second, load) = (2.0 * load * load, load.abs());
            let most = second + 0.003 * c_dis * load;
            assert!(
                (speed - exact_speed).abs() < most,
                "{c_dis} {load}: {speed:e} {exact_speed:e}"
            );
            let most = 4.0 * second + 0.01 * 1.5 * load / 0.5;
            assert!((tau - exact_tau).abs() < most, "{c_dis} {load}: {tau:e} {exact_tau:e}");
        }
    }
}
