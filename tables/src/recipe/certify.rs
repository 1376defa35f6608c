//! How wrong is a table at worst? Reads it at points the fit did not see; writes its certificate.

use super::made::{Made, Number, Store};
use super::range;
use super::spread::Spread;
use crate::contact::{follow, follow_quickly, outcome_at};
use crate::fit::{Ask, Fit, place};
use crate::form::{Body, Certificate, Domain, Groups, Law, Scaled};
use crate::number::Real;
#[cfg(feature = "fixed")]
use crate::number::{I16F16, I32F32};

const CITATION: &str = "P. Müller and T. Pöschel, Event-driven molecular dynamics of soft particles, \
     Phys. Rev. E 87, 033301 (2013), Eqs. 8, 10, 40, 51";
const NOTHING: Scaled<f64> = Scaled { tau: 0.0, speed: 0.0, angle: 0.0, separation: 0.0 };

/// The certificate before anything was measured.
pub(super) fn blank(ask: &Ask, fit: &Fit) -> Certificate {
    Certificate {
        law: ask.law,
        end: ask.end,
        domain: ask.domain,
        bytes: 0,
        terms: fit.terms,
        largest: NOTHING,
        typical: NOTHING,
        usual: NOTHING,
        points: 0,
        // The errors of a wide table have a long tail in corners that no typical collision sees.
        margin: if ask.frame.wide { 2.0 } else { 1.5 },
        digest: 0,
        citation: CITATION,
    }
}

/// Half of the points are typical, a quarter lie where errors peak (corners, faces and inside of
/// every leaf), a quarter anywhere in the domain.
pub(super) fn certify<C: Store>(ask: &Ask, made: &Made<C>, points: usize) -> Certificate {
    let body = made.body();
    let mut spread = Spread::new(29);
    let (mut worst, mut common) = (NOTHING, NOTHING);
    let margin = made.certificate.margin;
    let mut typical = [const { Vec::new() }; 4];
    let mut measured = 0;
    for n in 0..points {
        let usual = n % 2 == 0;
        let g = match n % 4 {
            1 => uniform(&ask.domain, &mut spread),
            3 => peak(ask, made, n / 4, &mut spread),
            _ => typically(ask, &mut spread),
        };
        let Some(error) = error_at(ask, &body, &g) else { continue };
        measured += 1;
        worst = larger(worst, error);
        if usual {
            common = larger(common, error);
            for (list, e) in typical.iter_mut().zip(numbers(error)) {
                list.push(e);
            }
        }
    }
    Certificate {
        bytes: body.bytes(),
        largest: scaled(numbers(worst).map(|e| round_up(e * margin))),
        typical: scaled(numbers(common).map(|e| round_up(e * margin))),
        usual: scaled(typical.map(|list| round_up(quantile(list)))),
        points: measured,
        digest: digest(&body),
        ..made.certificate
    }
}

/// A typical collision: drawn from MP13's tables for a wide table, uniform in the domain otherwise.
pub(crate) fn typically(ask: &Ask, spread: &mut Spread) -> Groups<f64> {
    if !ask.typical.is_empty() {
        return range::draw(ask.law, spread);
    }
    uniform(&ask.domain, spread)
}

/// Uniform in eccentricity, softness and damping; some exactly on a face.
fn uniform(domain: &Domain, spread: &mut Spread) -> Groups<f64> {
    let sin_max = libm::sqrt(1.0 - domain.cos_min * domain.cos_min);
    let face = spread.uniform();
    let sin = if face < 0.04 { 0.0 } else { spread.uniform() * sin_max };
    // One in four is grazing, its cosine uniform in the logarithm.
    let grazing = face > 0.5 && face < 0.75;
    let cos = if grazing {
        spread.logarithmic(domain.cos_min, 1.0)
    } else {
        libm::sqrt((1.0 - sin) * (1.0 + sin))
    };
    let sin = if grazing { libm::sqrt((1.0 - cos) * (1.0 + cos)) } else { sin };
    let soft = spread.uniform() * if domain.softness_max > 0.3 { spread.uniform() } else { 1.0 };
    let soft = if face > 0.96 { 1.0 } else { soft };
    let c_dis = match face {
        f if f > 0.02 && f < 0.06 => 0.0,
        f if f < 0.6 && domain.c_dis_max > 2.0 => spread.logarithmic(1e-4, domain.c_dis_max),
        _ => domain.c_dis_max * spread.uniform(),
    };
    let eta = if face > 0.06 && face < 0.07 { 0.0 } else { domain.softness_max * cos * soft };
    Groups { sin, cos, eta, c_dis }
}

/// A corner, face or inner point of one leaf.
fn peak<C: Store>(ask: &Ask, made: &Made<C>, n: usize, spread: &mut Spread) -> Groups<f64> {
    let leaf = n % made.cubes.len();
    let y = place(n / made.cubes.len(), spread);
    let [kappa, eta, c_dis] = ask.frame.groups(made.cubes[leaf].at(y));
    let whole = kappa + eta;
    Groups { sin: libm::sqrt(kappa / whole), cos: libm::sqrt(eta / whole), eta, c_dis }
}

/// The error of the reader for which the table is meant; for `f32` the larger of those of both floats.
/// `None` outside the domain.
fn error_at<C: Store>(ask: &Ask, body: &Body<'_, C>, g: &Groups<f64>) -> Option<Scaled<f64>> {
    match ask.number {
        Number::F64 => Some(difference(truth(ask, g), body.read(g)?, 0.0)),
        Number::F32 => {
            let (g, got) = read_in::<f32, C>(body, g)?;
            let truth = truth(ask, &g);
            let double = body.read(&g).map_or(NOTHING, |double| difference(truth, double, 0.0));
            Some(larger(difference(truth, got, 0.0), double))
        }
        #[cfg(feature = "fixed")]
        Number::I32F32 => fixed_error(ask, read_in::<I32F32, C>(body, g)?),
        #[cfg(feature = "fixed")]
        Number::I16F16 => fixed_error(ask, read_in::<I16F16, C>(body, g)?),
    }
}

/// The groups as `S` has them, and what the table says to them in `S`.
fn read_in<S: Real, C: Store>(
    body: &Body<'_, C>,
    g: &Groups<f64>,
) -> Option<(Groups<f64>, Scaled<f64>)> {
    let [sin, cos, eta, c_dis] = [g.sin, g.cos, g.eta, g.c_dis].map(S::from_f64);
    let got = body.read(&Groups { sin, cos, eta, c_dis })?;
    let [sin, cos, eta, c_dis] = [sin, cos, eta, c_dis].map(S::to_f64);
    let got = scaled([got.tau, got.speed, got.angle, got.separation].map(S::to_f64));
    Some((Groups { sin, cos, eta, c_dis }, got))
}

/// A fixed-point number has no relative precision: durations below T count as T.
#[cfg(feature = "fixed")]
fn fixed_error(ask: &Ask, (g, got): (Groups<f64>, Scaled<f64>)) -> Option<Scaled<f64>> {
    Some(difference(truth(ask, &g), got, 1.0))
}

fn truth(ask: &Ask, g: &Groups<f64>) -> Scaled<f64> {
    let run = if ask.precise { follow } else { follow_quickly };
    outcome_at(ask.end, g, |kappa| run(ask.law, ask.end, kappa, g.eta, g.c_dis))
}

/// Of the duration relative to it, or to `least` if that is longer.
fn difference(truth: Scaled<f64>, got: Scaled<f64>, least: f64) -> Scaled<f64> {
    let tau =
        if truth.tau < least { (got.tau - truth.tau) / least } else { got.tau / truth.tau - 1.0 };
    Scaled {
        tau: tau.abs(),
        speed: (got.speed - truth.speed).abs(),
        angle: (got.angle - truth.angle).abs(),
        separation: (got.separation - truth.separation).abs(),
    }
}

fn numbers(s: Scaled<f64>) -> [f64; 4] {
    [s.tau, s.speed, s.angle, s.separation]
}

fn scaled([tau, speed, angle, separation]: [f64; 4]) -> Scaled<f64> {
    Scaled { tau, speed, angle, separation }
}

/// The larger of each; NaN counts as infinite.
fn larger(a: Scaled<f64>, b: Scaled<f64>) -> Scaled<f64> {
    let max = |a: f64, b: f64| {
        if b <= a {
            a
        } else if b.is_nan() {
            f64::INFINITY
        } else {
            b
        }
    };
    Scaled {
        tau: max(a.tau, b.tau),
        speed: max(a.speed, b.speed),
        angle: max(a.angle, b.angle),
        separation: max(a.separation, b.separation),
    }
}

fn quantile(mut errors: Vec<f64>) -> f64 {
    errors.sort_by(f64::total_cmp);
    let at = errors.len() * 999 / 1000;
    errors.get(at).copied().unwrap_or(0.0)
}

/// Three digits, never less than the value.
fn round_up(value: f64) -> f64 {
    if !value.is_finite() || value <= 0.0 {
        return value;
    }
    let unit = libm::pow(10.0, libm::floor(libm::log10(value)) - 2.0);
    format!("{:.2e}", (libm::floor(value / unit) + 1.0) * unit).parse().unwrap_or(value)
}

/// FNV-1a, 64 bit.
fn digest<C: Store>(body: &Body<'_, C>) -> u64 {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    let mut eat = |byte: u8| hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    eat(u8::from(body.frame.law == Law::Viscoelastic));
    eat(u8::from(body.frame.wide));
    eat(body.frame.end as u8);
    let d = &body.domain;
    let f = &body.frame;
    for number in [
        d.softness_max,
        d.c_dis_max,
        d.cos_min,
        d.sin_min,
        d.stick_max,
        f.kappa_scale,
        f.softness,
        f.c_dis,
        f.bend,
    ] {
        number.bytes().into_iter().for_each(&mut eat);
    }
    for b in body.branches {
        eat(b.axis);
        b.low.to_le_bytes().into_iter().chain(b.high.to_le_bytes()).for_each(&mut eat);
    }
    for l in body.leaves {
        l.row.to_le_bytes().into_iter().chain(l.coefficient.to_le_bytes()).for_each(&mut eat);
        l.rows.into_iter().chain(l.terms).chain([u8::from(l.direct)]).for_each(&mut eat);
    }
    body.rows.iter().flat_map(|r| [r.orders, r.terms]).for_each(&mut eat);
    body.coefficients.iter().flat_map(|c| c.bytes()).for_each(&mut eat);
    hash
}
