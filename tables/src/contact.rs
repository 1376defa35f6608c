//! How does one contact go, from first touch to end? Reads the law, the end and the scaled groups; writes the restitution to 1e-12.

use crate::read::groups::{Groups, ScaledRestitution};
use crate::read::law::{End, Law};
use crate::taylor::{PRECISE_TERMS, Parameters, QUICK_TERMS, Trajectory, value};

/// The result of the radial equation of motion for one contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct RadialSolution {
    /// Scaled contact duration.
    pub tau: f64,
    /// `|x'|` at the end.
    pub speed: f64,
    /// `integral dt / (1 - eta x)^2` over the contact: the rotation divided by `tan(alpha) eta`.
    pub rotation: f64,
    /// Whether the centres passed each other in an exactly central collision.
    pub passed_centre: bool,
}

const STEPS: usize = 20_000;

/// Integrates the scaled equation of motion of a contact (MP13 Eqs. 42, 54) for one collision.
///
/// Accurate to 1e-12 (`tau` relative, the others absolute) for any finite groups with
/// `0 < cos <= 1`, `eta >= 0`, `c_dis >= 0`, the end of the contact included.
/// With [`End::Overlap`] a contact that never opens has `tau = inf` and `speed = 0`.
///
/// # Units
/// Scaled: time in `T`, length in `X`, angle in radians.
pub fn integrate(law: Law, end: End, groups: &Groups<f64>) -> ScaledRestitution<f64> {
    integrate_loaded(law, end, groups, 0.0)
}

/// The same where something else, as gravity in a contact with a plane, accelerates the two towards each other
/// all the while: `load` is that acceleration times `T/v_n`.
///
/// A damped contact under a load that is too large never ends; it has `tau = inf` and `speed = 0`.
///
/// ```
/// use carom_tables::contact::{integrate, integrate_loaded};
/// use carom_tables::read::{End, Groups, Law};
/// let head_on = Groups { sin: 0.0, cos: 1.0, eta: 0.01, c_dis: 0.0 };
/// let pressed = integrate_loaded(Law::LinearDashpot, End::Force, &head_on, 0.1);
/// // x = sin t + load (1 - cos t).
/// assert!((pressed.tau - std::f64::consts::PI - 2.0 * 0.1_f64.atan()).abs() < 1e-12);
/// assert!(pressed.tau > integrate(Law::LinearDashpot, End::Force, &head_on).tau);
/// ```
pub fn integrate_loaded(
    law: Law,
    end: End,
    groups: &Groups<f64>,
    load: f64,
) -> ScaledRestitution<f64> {
    let Groups { eta, c_dis, .. } = *groups;
    let loaded = |kappa| Parameters { kappa, eta, c_dis, load };
    restitution(end, groups, |kappa| run::<PRECISE_TERMS>(law, end, &loaded(kappa), 1e-17))
}

/// The restitution of one collision from the solution `radial` of its radial equation.
pub(crate) fn restitution(
    end: End,
    groups: &Groups<f64>,
    radial: impl FnOnce(f64) -> RadialSolution,
) -> ScaledRestitution<f64> {
    let tan = groups.sin / groups.cos;
    let done = radial(tan * tan * groups.eta);
    let swept = if tan > 0.0 { tan * groups.eta * done.rotation } else { 0.0 };
    let angle = if done.passed_centre { core::f64::consts::PI } else { swept };
    let separation = match end {
        End::Force => 1.0 - groups.c_dis * done.speed * groups.eta,
        End::Overlap => 1.0,
    };
    ScaledRestitution { tau: done.tau, speed: done.speed, angle, separation }
}

/// Integrates `x'' = -kappa/(1 - eta x)^3 - g(x) - c_dis d(x) x'` from touch to end.
///
/// Taylor series of order 22 in a step variable in which both laws, and the passage close to
/// the centre, are smooth. `p = x + c_dis x'` is a state of its own: an overdamped contact
/// ends where `p` has fallen by many orders of magnitude, and only its relative precision
/// locates that instant.
pub(crate) fn integrate_radial(
    law: Law,
    end: End,
    kappa: f64,
    eta: f64,
    c_dis: f64,
) -> RadialSolution {
    run::<PRECISE_TERMS>(law, end, &unloaded(kappa, eta, c_dis), 1e-17)
}

/// [`integrate_radial`] to about 1e-10, five times faster: for the fit of tables in single precision.
pub(crate) fn integrate_radial_quickly(
    law: Law,
    end: End,
    kappa: f64,
    eta: f64,
    c_dis: f64,
) -> RadialSolution {
    run::<QUICK_TERMS>(law, end, &unloaded(kappa, eta, c_dis), 1e-9)
}

fn unloaded(kappa: f64, eta: f64, c_dis: f64) -> Parameters {
    Parameters { kappa, eta, c_dis, load: 0.0 }
}

fn run<const N: usize>(law: Law, end: End, c: &Parameters, tolerance: f64) -> RadialSolution {
    let kappa = c.kappa;
    if !(kappa + c.eta + c.c_dis + c.load).is_finite() {
        return RadialSolution {
            tau: f64::NAN,
            speed: f64::NAN,
            rotation: f64::NAN,
            passed_centre: false,
        };
    }
    let mut path = Trajectory::<N>::at_first_touch(c);
    let mut passed_centre = false;
    let scale = compression_scale(law, c);
    for _ in 0..STEPS {
        expand(law, &mut path, c);
        let h = path.step(max_step(law, &path, c), tolerance, scale, c);
        if let Some(h) = ending(law, end, &path, c, h) {
            path.advance(h);
            return outcome(law, end, &path, c, passed_centre);
        }
        path.advance(h);
        renew(law, &mut path, c);
        if kappa == 0.0 && path.q[0] < 1e-17 && !passed_centre {
            passed_centre = true;
            reflect(law, &mut path, c);
        }
    }
    RadialSolution { tau: f64::INFINITY, speed: 0.0, rotation: path.rotation[0], passed_centre }
}

/// The duration of a central contact that nothing turns, and overlap and rate at these phases p in ascending order,
/// which are the times τ p²(3 − 2p).
pub(crate) fn motion(law: Law, c_dis: f64, phases: &[f64]) -> (f64, Vec<[f64; 2]>) {
    let c = unloaded(0.0, 0.0, c_dis);
    let tau = run::<PRECISE_TERMS>(law, End::Force, &c, 1e-17).tau;
    let mut times = phases.iter().map(|p| tau * p * p * (3.0 - 2.0 * p)).peekable();
    let mut path = Trajectory::<PRECISE_TERMS>::at_first_touch(&c);
    let (scale, mut states) = (compression_scale(law, &c), Vec::new());
    for _ in 0..STEPS {
        expand(law, &mut path, &c);
        let h = path.step(max_step(law, &path, &c), 1e-17, scale, &c);
        let end = ending(law, End::Force, &path, &c, h);
        let (h, is_last) = (end.unwrap_or(h), end.is_some());
        while let Some(time) = times.next_if(|&t| is_last || t <= value(&path.time, h)) {
            states.push(state_within(law, &path, time, h));
        }
        if is_last {
            break;
        }
        path.advance(h);
        renew(law, &mut path, &c);
    }
    (tau, states)
}

/// Overlap and rate at an instant within a step.
fn state_within<const N: usize>(law: Law, path: &Trajectory<N>, time: f64, h: f64) -> [f64; 2] {
    let later = |h: f64| time - value(&path.time, h);
    let mut there = path.clone();
    there.advance(match (later(0.0) > 0.0, later(h) < 0.0) {
        (false, _) => 0.0,
        (_, false) => h,
        _ => bisect(0.0, h, later),
    });
    [compression(law, &there), there.v[0]]
}

/// At the centre of an exactly central collision the distance begins to grow again.
fn reflect<const N: usize>(law: Law, path: &mut Trajectory<N>, c: &Parameters) {
    path.v[0] = -path.v[0];
    path.p[0] = compression(law, path) + c.c_dis * path.v[0];
}

/// About how deep a contact goes: spring, damping and centrifugal force in turn set the limit.
fn compression_scale(law: Law, c: &Parameters) -> f64 {
    match law {
        Law::LinearDashpot => 1.0 / (1.0 + c.c_dis + c.kappa),
        Law::Viscoelastic => 1.0 / libm::sqrt(1.0 + c.kappa + libm::pow(c.c_dis, 2.0 / 3.0)),
    }
}

fn expand<const N: usize>(law: Law, path: &mut Trajectory<N>, c: &Parameters) {
    match law {
        Law::LinearDashpot => path.expand_linear(c),
        Law::Viscoelastic => path.expand_viscoelastic(c),
    }
}

/// The compression `x` at the start of a step.
fn compression<const N: usize>(law: Law, path: &Trajectory<N>) -> f64 {
    match law {
        Law::LinearDashpot => path.depth[0],
        Law::Viscoelastic => path.depth[0] * path.depth[0],
    }
}

/// No step may be so long that the damping wipes out what it carries, or that an end hides in it.
fn max_step<const N: usize>(law: Law, path: &Trajectory<N>, c: &Parameters) -> f64 {
    let rate = match law {
        Law::LinearDashpot => 0.7 + c.c_dis * path.q[0],
        Law::Viscoelastic => 0.7 + 2.0 * c.c_dis * compression(law, path) * path.q[0],
    };
    2.0 / rate
}

/// Of the two ways to carry the velocity the one that keeps its precision renews the other.
fn renew<const N: usize>(law: Law, path: &mut Trajectory<N>, c: &Parameters) {
    let x = compression(law, path);
    if c.c_dis >= 1.0 {
        path.v[0] = (path.p[0] - x) / c.c_dis;
    } else {
        path.p[0] = x + c.c_dis * path.v[0];
    }
}

/// Positive while the contact lasts.
fn lasting<const N: usize>(
    law: Law,
    end: End,
    path: &Trajectory<N>,
    c: &Parameters,
    h: f64,
) -> f64 {
    let depth = value(&path.depth, h);
    match (end, law) {
        (End::Overlap, _) => depth,
        (End::Force, Law::LinearDashpot) => value(&path.p, h),
        (End::Force, Law::Viscoelastic) if c.c_dis >= 1.0 => value(&path.p, h),
        (End::Force, Law::Viscoelastic) => depth - (-c.c_dis * value(&path.v, h)).max(0.0).sqrt(),
    }
}

/// The step at which the contact ends, when it does so within `h`.
fn ending<const N: usize>(
    law: Law,
    end: End,
    path: &Trajectory<N>,
    c: &Parameters,
    h: f64,
) -> Option<f64> {
    const SAMPLES: usize = 6;
    let mut low = 0.0;
    for k in 1..=SAMPLES {
        let high = h * k as f64 / SAMPLES as f64;
        if lasting(law, end, path, c, high) <= 0.0 {
            return Some(bisect(low, high, |t| lasting(law, end, path, c, t)));
        }
        low = high;
    }
    None
}

/// The zero of `f` between `low` (positive, or the touch) and `high` (not positive): Illinois, guarded.
fn bisect(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    let (mut at_low, mut at_high) = (f(low), f(high));
    let mut kept_high = 0;
    for round in 0..200 {
        let width = high - low;
        if width <= 2.0 * f64::EPSILON * high || at_high == 0.0 {
            break;
        }
        let secant = high - at_high * width / (at_high - at_low);
        let safe = at_low > 0.0 && secant > low && secant < high && round % 8 != 7;
        let middle = if safe { secant } else { low + 0.5 * width };
        let at_middle = f(middle);
        if at_middle > 0.0 {
            (low, at_low) = (middle, at_middle);
            kept_high = (kept_high + 1).max(1);
        } else {
            (high, at_high) = (middle, at_middle);
            kept_high = (kept_high - 1).min(-1);
        }
        match kept_high {
            2.. => at_high *= 0.5,
            ..=-2 => at_low *= 0.5,
            _ => {}
        }
    }
    high
}

fn outcome<const N: usize>(
    law: Law,
    end: End,
    path: &Trajectory<N>,
    c: &Parameters,
    passed_centre: bool,
) -> RadialSolution {
    let speed = match end {
        _ if c.c_dis == 0.0 => 1.0,
        End::Force if c.c_dis >= 1.0 => compression(law, path) / c.c_dis,
        _ => (-path.v[0]).max(0.0),
    };
    RadialSolution { tau: path.time[0], speed, rotation: path.rotation[0], passed_centre }
}

#[cfg(test)]
mod tests {
    use crate::contact::{integrate_radial, integrate_radial_quickly, run, unloaded};
    use crate::random::Rng;
    use crate::read::law::{End, Law};
    use crate::taylor::PRECISE_TERMS;

    /// Other steps, another order, the same contact: 1e-12 all over MP13's tables and beyond.
    #[test]
    fn the_result_does_not_depend_on_steps_and_order() {
        let mut rng = Rng::new(8);
        for _ in 0..400 {
            let kappa = rng.log_uniform(1e-11, 1e2);
            for (law, eta, most) in
                [(Law::LinearDashpot, 10.0, 56.0), (Law::Viscoelastic, 0.7, 5e6)]
            {
                let eta = rng.log_uniform(1e-7, eta);
                let kappa = kappa.max(1e-4 * eta);
                let c_dis = rng.log_uniform(1e-4, most);
                let c = unloaded(kappa, eta, c_dis);
                let a = run::<PRECISE_TERMS>(law, End::Force, &c, 1e-17);
                let b = run::<30>(law, End::Force, &c, 1e-19);
                let turn = libm::sqrt(kappa * eta);
                let at = (law, kappa, eta, c_dis);
                assert!((a.tau / b.tau - 1.0).abs() < 1e-12, "{at:?} {a:?} {b:?}");
                assert!((a.speed - b.speed).abs() < 1e-12, "{at:?} {a:?} {b:?}");
                assert!((a.rotation - b.rotation).abs() * turn < 1e-12, "{at:?} {a:?} {b:?}");
            }
        }
    }

    #[test]
    fn quick_and_precise_integration_agree() {
        let mut rng = Rng::new(3);
        for _ in 0..300 {
            let kappa = rng.log_uniform(1e-9, 1e3);
            let eta = rng.log_uniform(1e-7, 0.9);
            for (law, most) in [(Law::LinearDashpot, 50.0), (Law::Viscoelastic, 5e5)] {
                let c_dis = rng.log_uniform(1e-5, most);
                let a = integrate_radial(law, End::Force, kappa, eta, c_dis);
                let b = integrate_radial_quickly(law, End::Force, kappa, eta, c_dis);
                assert!((a.tau / b.tau - 1.0).abs() < 1e-8, "{a:?} {b:?}");
                assert!((a.speed - b.speed).abs() < 1e-8, "{a:?} {b:?}");
                assert!((a.rotation / b.rotation - 1.0).abs() < 1e-8, "{a:?} {b:?}");
            }
        }
    }

    #[test]
    fn what_is_not_finite_gives_nan_and_no_panic() {
        for bad in [f64::NAN, f64::INFINITY] {
            assert!(integrate_radial(Law::Viscoelastic, End::Force, bad, 0.1, 0.1).tau.is_nan());
            assert!(integrate_radial(Law::LinearDashpot, End::Force, 0.1, bad, 0.1).tau.is_nan());
            assert!(integrate_radial(Law::LinearDashpot, End::Overlap, 0.1, 0.1, bad).tau.is_nan());
        }
    }
}
