//! Does it matter in how many calls a run arrives, and is what contacts are told to do what they did? Runs a gas in pieces; compares bits, momentum and energy.

use carom_reference::{
    Boundary, ContactStep, End, Exact, ForceLaw, Grain, Partner, System, Verlet, VerletOptions,
};

const LAW: ForceLaw = ForceLaw::LinearDashpot { stiffness: 2e3, damping: 2.0 };

/// Disks in a box that repeats along x, between walls across y, under gravity.
fn gas() -> System<2> {
    let grain = |k: u32| {
        let (x, y) = (f64::from(k % 4), f64::from(k / 4));
        let velocity = [3, 5].map(|i| f64::from(k * i % 7) - 3.0);
        Grain {
            radius: 0.3 + 0.01 * x,
            mass: 1.0 + 0.1 * y,
            position: [x + 0.5, y + 0.5],
            velocity,
        }
    };
    let boundary = [Boundary::Periodic { lo: 0.0, hi: 4.0 }, Boundary::Walls { lo: 0.0, hi: 4.0 }];
    System::new((0..16).map(grain).collect(), boundary, [0.0, -2.0]).unwrap()
}

fn verlet() -> Verlet<2> {
    Verlet::new(&gas(), LAW, End::Force, VerletOptions::default()).unwrap()
}

#[test]
fn pauses_change_no_bit() {
    let (mut whole, mut parts) = (verlet(), verlet());
    for t in [0.7, 2.5, 3.0] {
        whole.advance_to(t).unwrap();
        while !parts.advance_observed(t, 7, None).unwrap() {
            assert!(parts.now() < t);
        }
        assert_eq!(whole.grains(), parts.grains());
        assert_eq!(whole.statistics(), parts.statistics());
    }
    assert!(whole.statistics().contacts > 50);
    let mut whole = Exact::new(gas(), LAW, End::Force).unwrap();
    let mut parts = whole.clone();
    whole.advance_to(1.0).unwrap();
    while !parts.advance_within(1.0, 1).unwrap() {}
    assert_eq!(whole.grains(), parts.grains());
    assert!(whole.records().len() > 20);
}

/// Between two steps velocities are shown at the time of the positions; who wants to go elsewhere can from there.
#[test]
fn a_pause_is_a_state() {
    let ball = Grain { radius: 0.1, mass: 1.0, position: [0.0, 5.0], velocity: [1.0, 0.0] };
    let system = System::new(vec![ball], [Boundary::Open; 2], [0.0, -2.0]).unwrap();
    let mut run = Verlet::new(&system, LAW, End::Force, VerletOptions::default()).unwrap();
    assert!(!run.advance_observed(1.0, 5, None).unwrap());
    let now = run.now();
    assert!(now > 0.0 && now < 1.0);
    assert!((run.velocity(0)[1] + 2.0 * now).abs() < 1e-13);
    assert!((run.position(0)[1] - 5.0 + now * now).abs() < 1e-13);
    assert!(run.advance_observed(0.5 * now, 1, None).is_err());
    run.advance_to(0.5 + now).unwrap();
    assert!((run.velocity(0)[1] + 2.0 * (0.5 + now)).abs() < 1e-13);
}

/// What contacts gave is what grains have more than gravity gave; what they took of the kinetic energy is missing, to
/// second order of the step.
#[test]
fn contacts_tell_momentum_and_energy() {
    let (mut run, system) = (verlet(), gas());
    let (mut given, mut lost, mut touches) = ([0.0; 2], 0.0, [0_u64; 2]);
    let mut tell = |contact: &ContactStep<2>| {
        let ContactStep { force, separation, velocities, step, began, .. } = contact;
        let wall = matches!(contact.partner, Partner::Wall { .. });
        let virial: f64 = (0..2).map(|k| force[k] * separation[k]).sum();
        assert!(virial >= 0.0, "contacts push: {contact:?}");
        touches[usize::from(wall)] += u64::from(*began);
        for k in 0..2 {
            let other = if wall { 0.0 } else { velocities[1][k] };
            lost -= force[k] * (velocities[0][k] - other) * step;
            if wall {
                given[k] += force[k] * step;
            }
        }
    };
    run.advance_observed(3.0, u64::MAX, Some(&mut tell)).unwrap();
    let end = run.system().unwrap();
    let [before, after] = [&system, &end].map(System::momentum);
    let weight: f64 = system.grains().iter().map(|grain| 2.0 * grain.mass).sum();
    assert!((after[0] - before[0] - given[0]).abs() < 1e-10);
    assert!((after[1] - before[1] + 3.0 * weight - given[1]).abs() < 1e-9);
    // What gravity gave: the way of each grain down, which walls bound.
    let fallen = system.gravitational_energy() - end.gravitational_energy();
    let missing = system.kinetic_energy() - end.kinetic_energy() + fallen;
    assert!(missing > 0.3 * system.kinetic_energy());
    assert!((lost / missing - 1.0).abs() < 1e-4, "{lost} of {missing}");
    assert_eq!(touches.iter().sum::<u64>(), run.statistics().contacts);
    assert!(touches.iter().all(|count| *count > 10), "{touches:?}");
}
