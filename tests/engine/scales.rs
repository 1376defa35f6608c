//! Which sizes can a world have? Two grains that meet, in all units; compares with the time that division gives.

use carom::law::{Answer, HardSphere, Impact, Outcome, Response, Rule};
use carom::{Error, Grain, Memory, Scalar, World};

/// Two grains of this size, five diameters apart, meet with this speed: when, in units of size over speed.
fn meeting<S: Scalar>(size: f64, speed: f64) -> Result<f64, Error> {
    let [r, v] = [size, speed].map(S::from_f64);
    let mut memory = Memory::<S, 2, 2>::new();
    let grain = |x: f64| Grain::with_mass(r, S::one()).at([S::from_f64(x * size), S::zero()]);
    let mut world = World::builder(&mut memory)
        .rule(HardSphere { restitution: S::one() })
        .grain(grain(-6.0).moving([v, S::zero()]))?
        .grain(grain(6.0).moving([-v, S::zero()]))?
        .start()?;
    let event = world.step()?;
    let at = event.map_or(f64::INFINITY, |event| event.at.as_f64());
    Ok(at * (speed / size))
}

/// At no scale is a meeting late, at once, or lost: it is right, or the start says what does not fit.
#[test]
fn a_meeting_is_right_or_refused_by_name() {
    let (mut right, mut refused) = (0, 0);
    for exponent in -38..=38 {
        for slower in [0, 3, -3, 12] {
            let size = 10.0_f64.powi(exponent);
            let cases = [
                (meeting::<f32>(size, size * 10.0_f64.powi(-slower)), 1e-5),
                (meeting::<f64>(size.powi(8), size.powi(8) * 10.0_f64.powi(-slower)), 1e-13),
            ];
            for (met, rounding) in cases {
                match met {
                    Ok(t) if (t - 5.0).abs() < rounding => right += 1,
                    Err(Error::Input { field, .. }) => {
                        assert!(["radius", "position", "velocity", "mass"].contains(&field));
                        refused += 1;
                    }
                    other => panic!("10^{exponent}, slower by 10^{slower}: {other:?}"),
                }
            }
        }
    }
    assert!(right > 100 && refused > 100, "{right} right, {refused} refused");
}

#[test]
fn what_cannot_be_squared_is_named() {
    for (size, speed) in [(1e10, 1e10), (1e-12, 1e-12), (1.0, 1e20)] {
        assert!(matches!(meeting::<f32>(size, speed), Err(Error::Input { .. })), "{size} {speed}");
    }
    for scale in [1e78, 1e-81, 1e155] {
        assert!(matches!(meeting::<f64>(scale, scale), Err(Error::Input { .. })), "{scale}");
    }
    let falls = |g: f32| {
        let mut memory = Memory::<f32, 1, 1>::new();
        let grain = Grain::with_mass(1.0, 1.0);
        let rule = HardSphere { restitution: 0.5 };
        World::builder(&mut memory).gravity([g]).rule(rule).grain(grain)?.start().map(|_| ())
    };
    assert_eq!(falls(-9.81), Ok(()));
    let error = falls(1e30).unwrap_err();
    assert!(error.to_string().contains("gravity"), "{error}");
}

/// A rule that answers what it was told to.
struct Told(Response<f64>, bool);

impl Rule<f64> for Told {
    fn collide(&self, _: &Impact<f64>) -> Answer<f64> {
        Answer::exact(self.0)
    }
    fn adds_energy(&self) -> bool {
        self.1
    }
}

fn told(response: Response<f64>, adds_energy: bool) -> Result<(), Error> {
    let mut memory = Memory::<f64, 2, 2>::new();
    let mut world = World::builder(&mut memory)
        .rule(Told(response, adds_energy))
        .grain(Grain::with_mass(0.5, 1.0).at([-2.0, 0.0]).moving([1.0, 0.0]))?
        .grain(Grain::with_mass(0.5, 1.0).at([2.0, 0.0]))?
        .start()?;
    world.step().map(|_| ())
}

#[test]
fn an_own_rule_cannot_move_grains_apart_or_add_energy_unasked() {
    let outcome = Outcome { duration: 0.1, restitution: 0.5, separation: 0.9, angle: 0.0 };
    let refused = |answer: Response<f64>, field: &str| match told(answer, false) {
        Err(Error::InvalidOutcome { field: named, .. }) => assert_eq!(named, field),
        other => panic!("{other:?}"),
    };
    assert_eq!(told(Response::Lasting(outcome), false), Ok(()));
    for separation in [50.0, 1.1, 0.0, -1.0, f64::NAN] {
        refused(Response::Lasting(Outcome { separation, ..outcome }), "separation");
    }
    for restitution in [2.0, 1.1, -0.5, f64::NAN] {
        refused(Response::Lasting(Outcome { restitution, ..outcome }), "restitution");
        refused(Response::Instantaneous(restitution), "restitution");
    }
    assert_eq!(told(Response::Instantaneous(2.0), true), Ok(()));
}
