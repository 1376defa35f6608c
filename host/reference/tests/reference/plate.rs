//! Does a vibrating plate push as it should? Reads closed forms; writes nothing.

use carom_reference::{
    Boundary, End, Exact, ForceLaw, Gear, Grain, Plate, System, Verlet, VerletOptions,
};
use std::f64::consts::TAU;

const GRAVITY: f64 = 9.81;
const RADIUS: f64 = 0.01;
const FREQUENCY: f64 = 5.0;
/// ω_0 and 2μ of the bead on its spring.
const PROPER: f64 = 200.0;
const DAMPING: f64 = 10.0;

fn plate() -> Plate {
    let amplitude = 0.5 * GRAVITY / (TAU * FREQUENCY).powi(2);
    Plate { amplitude, frequency: FREQUENCY, phase: 0.1, ..Plate::fixed(0.3) }
}

/// Overlap and its rate of a bead that never leaves the plate (α = 1/2):
/// ẍ + 2μ ẋ + ω_0² x = g + z̈_0, without a transient.
fn overlap(t: f64) -> [f64; 2] {
    let (plate, omega) = (plate(), TAU * FREQUENCY);
    let [re, im] = [PROPER * PROPER - omega * omega, omega * DAMPING];
    let force = -plate.amplitude * omega * omega / (re * re + im * im);
    let phase = omega * t + TAU * plate.phase;
    let x = force * (re * phase.sin() - im * phase.cos());
    let rate = force * omega * (re * phase.cos() + im * phase.sin());
    [GRAVITY / (PROPER * PROPER) + x, rate]
}

fn start() -> (System<1>, ForceLaw) {
    let ([x, u], plate) = (overlap(0.0), plate());
    let bead = Grain {
        radius: RADIUS,
        mass: 2.0,
        position: [plate.height(0.0) + RADIUS - x],
        velocity: [plate.velocity(0.0) - u],
    };
    let system = System::new(vec![bead], [Boundary::Plate(plate)], [-GRAVITY]).expect("valid");
    (system, ForceLaw::LinearDashpot { stiffness: 2.0 * PROPER * PROPER, damping: 2.0 * DAMPING })
}

/// In units of the mean overlap.
fn wrong(position: f64, t: f64) -> f64 {
    let wanted = plate().height(t) + RADIUS - overlap(t)[0];
    (position - wanted).abs() * PROPER * PROPER / GRAVITY
}

#[test]
fn a_bead_rides_on_a_plate() {
    let (system, law) = start();
    let options = VerletOptions { steps_per_contact: 200.0, ..VerletOptions::default() };
    for end in [End::Force, End::Overlap] {
        let mut exact = Exact::new(system.clone(), law, end).expect("valid");
        let mut gear = Gear::new(&system, law, end, options).expect("valid");
        let mut verlet = Verlet::new(&system, law, end, options).expect("valid");
        for t in [0.013, 0.1, 0.37, 0.5] {
            exact.advance_to(t).expect("integrates");
            gear.advance_to(t).expect("integrates");
            verlet.advance_to(t).expect("integrates");
            let all = [exact.position(0)[0], gear.position(0)[0], verlet.position(0)[0]];
            let all = all.map(|position| wrong(position, t));
            assert!(all[0] < 1e-9 && all[1] < 1e-6 && all[2] < 1e-3, "{end:?} {t} {all:?}");
        }
        assert_eq!(exact.contacts(), 1);
    }
}

/// A hard bead that falls onto the plate leaves it with 2 ż_0 − v; the spring makes that true to
/// the contact time.
#[test]
fn a_bead_bounces_off_a_moving_plate() {
    let plate = Plate { amplitude: 2e-3, frequency: 20.0, phase: 0.3, ..Plate::fixed(0.0) };
    let bead = Grain { radius: RADIUS, mass: 1.0, position: [0.05], velocity: [-0.2] };
    let system = System::new(vec![bead], [Boundary::Plate(plate)], [-GRAVITY]).expect("valid");
    let contact_time = 1e-6;
    let law = ForceLaw::spring_of(1.0, contact_time, 1.0).expect("valid");
    let mut exact = Exact::new(system.clone(), law, End::Overlap).expect("valid");
    let hit = exact.next_contact(1.0).expect("integrates").expect("they collide");
    let t = hit.begin;
    let height = 0.05 - 0.2 * t - 0.5 * GRAVITY * t * t - RADIUS;
    assert!((height - plate.height(t)).abs() < 1e-14);
    let wanted = 2.0 * plate.velocity(t) + 0.2 + GRAVITY * t;
    let got = exact.velocity(0)[0];
    assert!((got - wanted).abs() < 1e-4, "{got} {wanted}");
    let mut gear = Gear::new(&system, law, End::Overlap, VerletOptions::default()).expect("valid");
    gear.advance_to(exact.now()).expect("integrates");
    assert!((gear.velocity(0)[0] - got).abs() < 2e-3, "{} {got}", gear.velocity(0)[0]);
}

/// Many bounces of a lossy bead: the two integrators stay together as their steps allow.
#[test]
fn a_shaken_bead_by_both_integrators() {
    let plate = Plate { amplitude: 1e-3, frequency: 20.0, ..Plate::fixed(0.0) };
    let bead = Grain { radius: RADIUS, mass: 1.0, position: [0.012], velocity: [0.0] };
    let system = System::new(vec![bead], [Boundary::Plate(plate)], [-GRAVITY]).expect("valid");
    let law = ForceLaw::spring_of(1.0, 1e-3, 0.5).expect("valid");
    let mut exact = Exact::new(system.clone(), law, End::Overlap).expect("valid");
    exact.advance_to(0.2).expect("integrates");
    assert!(exact.records().len() > 2, "{}", exact.records().len());
    let error = |steps: f64| {
        let options = VerletOptions { steps_per_contact: steps, ..VerletOptions::default() };
        let mut gear = Gear::new(&system, law, End::Overlap, options).expect("valid");
        gear.advance_to(0.2).expect("integrates");
        (gear.position(0)[0] - exact.position(0)[0]).abs()
    };
    let [coarse, fine] = [error(25.0), error(400.0)];
    // Sixteen times the steps: 256 times closer at second order, which the ends of contacts limit it to.
    assert!(fine < 1e-5 && fine < coarse / 100.0, "{coarse:e} {fine:e}");
}
