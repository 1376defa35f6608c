//! Does bad input get a sentence that names it? Reads bad input; writes nothing.

use carom_reference::{
    Boundary, End, Exact, ForceLaw, Grain, ReferenceError, System, Verlet, VerletOptions, collide,
};

const GRAIN: Grain<2> =
    Grain { radius: 0.1, mass: 1.0, position: [0.5, 0.5], velocity: [0.0, 0.0] };
const OTHER: Grain<2> = Grain { position: [0.9, 0.5], ..GRAIN };
const OPEN: [Boundary; 2] = [Boundary::Open; 2];
const SPRING: ForceLaw = ForceLaw::LinearDashpot { stiffness: 1e3, damping: 0.0 };

fn system(grains: &[Grain<2>], boundary: [Boundary; 2]) -> Result<System<2>, ReferenceError> {
    System::new(grains.to_vec(), boundary, [0.0; 2])
}

fn error_contains<T>(result: Result<T, ReferenceError>, words: &[&str]) {
    let Err(error) = result else { panic!("accepted, but should name {words:?}") };
    let line = error.to_string();
    assert!(words.iter().all(|word| line.contains(word)), "{line:?} should name {words:?}");
    assert!(!line.contains('\n'));
}

#[test]
fn grains() {
    let with = |bad: Grain<2>| system(&[GRAIN, bad], OPEN);
    error_contains(with(Grain { radius: 0.0, ..OTHER }), &["grain 1", "radius = 0", "above 0"]);
    error_contains(with(Grain { mass: f64::NAN, ..OTHER }), &["grain 1", "mass = NaN"]);
    error_contains(with(Grain { mass: -1.0, ..OTHER }), &["grain 1", "mass = -1"]);
    error_contains(
        with(Grain { position: [0.0, f64::INFINITY], ..OTHER }),
        &["grain 1", "position[1] = inf"],
    );
    error_contains(with(Grain { velocity: [f64::NAN, 0.0], ..OTHER }), &["grain 1", "velocity[0]"]);
    error_contains(with(GRAIN), &["grains 0 and 1", "same centre"]);
    error_contains(system(&[], OPEN), &["number of grains = 0"]);
}

#[test]
fn boundaries() {
    let with = |b| system(&[GRAIN, OTHER], [Boundary::Open, b]);
    error_contains(with(Boundary::Periodic { lo: 1.0, hi: 0.0 }), &["axis 1", "from 1 to 0"]);
    error_contains(with(Boundary::Periodic { lo: 0.0, hi: 0.2 }), &["axis 1", "diameter, 0.2"]);
    error_contains(with(Boundary::Walls { lo: f64::NAN, hi: 1.0 }), &["axis 1", "NaN"]);
    error_contains(
        with(Boundary::Walls { lo: 0.6, hi: 1.0 }),
        &["grain 0", "position[1] = 0.5", "walls"],
    );
    let image = Grain { position: [0.5, 1.5], ..GRAIN };
    let narrow = [Boundary::Open, Boundary::Periodic { lo: 0.0, hi: 1.0 }];
    error_contains(system(&[GRAIN, image], narrow), &["grains 0 and 1", "same centre"]);
    error_contains(System::new(vec![GRAIN], OPEN, [0.0, f64::NAN]), &["gravity = NaN"]);
}

#[test]
fn laws_and_runs() {
    let run = |law| Exact::new(system(&[GRAIN, OTHER], OPEN)?, law, End::Force);
    error_contains(
        run(ForceLaw::LinearDashpot { stiffness: 0.0, damping: 0.0 }),
        &["stiffness = 0"],
    );
    error_contains(
        run(ForceLaw::LinearDashpot { stiffness: 1.0, damping: -2.0 }),
        &["damping = -2"],
    );
    let spheres =
        |young, poisson, dissipation| run(ForceLaw::Viscoelastic { young, poisson, dissipation });
    error_contains(spheres(f64::INFINITY, 0.3, 0.0), &["young = inf"]);
    error_contains(spheres(1e6, 0.6, 0.0), &["poisson = 0.6", "0.5"]);
    error_contains(spheres(1e6, 0.3, f64::NAN), &["dissipation = NaN"]);
    let mut exact = run(SPRING).expect("valid");
    exact.advance_to(1.0).expect("goes on");
    error_contains(exact.advance_to(0.5), &["until = 0.5"]);
    error_contains(exact.advance_to(f64::NAN), &["until = NaN"]);
    let fine = |steps_per_contact, skin| {
        let options = VerletOptions { steps_per_contact, skin };
        Verlet::new(&system(&[GRAIN, OTHER], OPEN)?, SPRING, End::Force, options)
    };
    error_contains(fine(0.0, None), &["steps_per_contact = 0"]);
    error_contains(fine(50.0, Some(-1.0)), &["skin = -1"]);
    error_contains(fine(50.0, None).expect("valid").advance_to(f64::INFINITY), &["t = inf"]);
}

#[test]
fn impacts() {
    let hit = |a, b| collide([a, b], SPRING, End::Force, &[]);
    error_contains(hit(GRAIN, OTHER), &["grains 0 and 1", "distance / (R1 + R2) = 2"]);
    let touching = Grain { position: [0.7, 0.5], ..GRAIN };
    error_contains(hit(GRAIN, touching), &["approach speed = 0"]);
    let leaving = Grain { velocity: [1.0, 0.0], ..touching };
    error_contains(hit(GRAIN, leaving), &["approach speed = -1"]);
    let coming = Grain { velocity: [-1.0, 0.0], ..touching };
    error_contains(collide([GRAIN, coming], SPRING, End::Force, &[-1.0]), &["time = -1"]);
}

/// Soft grains that run through each other's centre have no direction of force: said, not guessed.
#[test]
fn centres_that_coincide() {
    let coming = Grain { position: [0.7, 0.5], velocity: [-100.0, 0.0], ..GRAIN };
    let soft = ForceLaw::LinearDashpot { stiffness: 1.0, damping: 0.0 };
    error_contains(
        collide([GRAIN, coming], soft, End::Force, &[]),
        &["at time", "grain 0", "cannot be resolved"],
    );
}
