//! Does a contact turn and part as the force says? Oblique contacts of two grains; compares the motion integrated in the plane.

use crate::gas::length;
use carom::law::{LinearDashpot, Outside, Soft};
use carom::scalar::Vector;
use carom::world::EventOutcome;
use carom::{Grain, Memory, World};

type Pair = [Vector<f64, 2>; 2];

const REACH: f64 = 1.0;
const REDUCED_MASS: f64 = 0.75;

/// The force that pushes the first grain off the second, along their line of centres (MP13 Eq. 40).
fn force(law: &LinearDashpot<f64>, [r, v]: Pair) -> f64 {
    law.stiffness * (REACH - length(&r)) - law.damping * r.dot(&v) / length(&r)
}

/// One step of the classical method of Runge and Kutta for the separation and its rate, in the plane as Newton has it.
fn step(law: &LinearDashpot<f64>, [r, v]: Pair, h: f64) -> Pair {
    let rate = |[r, v]: Pair| [v, r / length(&r) * (force(law, [r, v]) / REDUCED_MASS)];
    let on = |[a, b]: Pair, by: f64| [r + a * by, v + b * by];
    let k1 = rate([r, v]);
    let k2 = rate(on(k1, 0.5 * h));
    let k3 = rate(on(k2, 0.5 * h));
    let k4 = rate(on(k3, h));
    [0, 1].map(|i| [r, v][i] + (k1[i] + (k2[i] + k3[i]) * 2.0 + k4[i]) * (h / 6.0))
}

/// Separation and its rate when the force has vanished again, and how long that took.
fn integrated(law: &LinearDashpot<f64>, start: Pair) -> (Pair, f64) {
    let (mut now, mut t, mut h) = (step(law, start, 1e-5), 1e-5, 1e-5);
    while h > 1e-14 {
        let next = step(law, now, h);
        if force(law, next) > 0.0 {
            (now, t) = (next, t + h);
        } else {
            h *= 0.5;
        }
    }
    (now, t)
}

/// Separation and its rate after a contact of the engine, each from the second grain to the first.
fn simulated(law: LinearDashpot<f64>, [r, v]: Pair) -> (Pair, f64) {
    let mut memory = Memory::<f64, 2, 2>::new();
    let mut world = World::builder(&mut memory)
        .rule(Soft::linear_dashpot(law, Outside::Reject))
        .grain(Grain::with_mass(0.625, 1.0).at(r.into()).moving(v.into()))
        .unwrap()
        .grain(Grain::with_mass(0.375, 3.0))
        .unwrap()
        .start()
        .unwrap();
    let begin = world.step().unwrap().unwrap();
    assert!(matches!(begin.outcome, Some(EventOutcome::ContactBegan(_))), "{begin:?}");
    let end = world.step().unwrap().unwrap();
    assert_eq!(end.outcome, Some(EventOutcome::ContactEnded));
    let [a, b] = [0, 1].map(|i| world.grain(i).unwrap());
    let duration = end.at.as_f64() - begin.at.as_f64();
    ([a.position - b.position, a.velocity - b.velocity], duration)
}

/// Both ways round, the line of centres turns in the sense of r × v, and the grains part where, when and as
/// fast as the equation of motion says; the table's certificate says how well.
#[test]
fn an_oblique_contact_turns_and_parts_as_the_equation_of_motion_says() {
    let promised = carom::law::embedded::standard::LINEAR_DASHPOT.certificate.largest;
    for damping in [0.0, 2.0] {
        let law = LinearDashpot { stiffness: 400.0, damping };
        for (across, direction) in [(0.5, 0.0), (-0.5, 0.0), (1.2, 2.0), (-1.2, 2.0)] {
            let (sin, cos) = f64::sin_cos(direction);
            let start = [
                Vector::from([cos, sin]),
                Vector::from([-cos - across * sin, -sin + across * cos]),
            ];
            let (expected, duration) = integrated(&law, start);
            let (found, lasted) = simulated(law, start);
            let turned = |[r, _]: &Pair| (start[0].perp(r)).atan2(start[0].dot(r));
            let what = format!("{damping} {across}: {found:?} for {expected:?}");
            assert!(turned(&expected) * across > 0.04 * across.abs(), "{what}");
            assert!((turned(&found) - turned(&expected)).abs() <= promised.angle, "{what}");
            assert!(
                (length(&found[0]) - length(&expected[0])).abs() <= promised.separation,
                "{what}"
            );
            assert!((lasted / duration - 1.0).abs() <= promised.tau, "{what}");
            // The velocity has the errors of the speed, of the angle and of the distance.
            let error = promised.speed + (promised.angle + promised.separation) * length(&start[1]);
            assert!(length(&(found[1] - expected[1])) <= error, "{what}");
        }
    }
}
