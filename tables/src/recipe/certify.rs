//! How large are the errors of a table? Reads it at points that the fit did not use; writes its certificate.

use super::generated::{GeneratedTable, ZERO};
use super::number_type::{EncodeNumber, NumberType};
use crate::collision::draw_from_mp13;
use crate::contact::{integrate_radial, integrate_radial_quickly, restitution};
use crate::fit::cube::test_point;
use crate::fit::options::FitOptions;
#[cfg(feature = "fixed")]
use crate::fixed_point::number::{I16F16, I32F32};
use crate::random::Rng;
use crate::read::certificate::Certificate;
use crate::read::domain::Domain;
use crate::read::groups::{Groups, ScaledRestitution};
use crate::read::law::Law;
use crate::read::layout::TableData;
use crate::read::real::Real;

/// The certificate of a table, measured by reading it in the number type `reader`.
///
/// Half of the points are typical, a quarter lie where errors peak (corners, faces and inside of
/// every leaf), a quarter anywhere in the domain.
pub(super) fn certify<C: EncodeNumber>(
    options: &FitOptions,
    reader: NumberType,
    table: &GeneratedTable<C>,
    points: usize,
) -> Certificate {
    let data = table.data();
    let mut rng = Rng::new(29);
    let (mut largest, mut largest_typical) = (ZERO, ZERO);
    let margin = table.certificate.margin;
    let mut typical = [const { Vec::new() }; 4];
    let mut measured = 0;
    for n in 0..points {
        let is_typical = n % 2 == 0;
        let g = match n % 4 {
            1 => uniform_collision(&options.domain, &mut rng),
            3 => leaf_point(options, table, n / 4, &mut rng),
            _ => typical_collision(options, &mut rng),
        };
        let Some(error) = error_at(options, reader, &data, &g) else { continue };
        measured += 1;
        largest = max_of_each(largest, error);
        if is_typical {
            largest_typical = max_of_each(largest_typical, error);
            for (list, e) in typical.iter_mut().zip(to_array(error)) {
                list.push(e);
            }
        }
    }
    Certificate {
        bytes: data.bytes(),
        largest: from_array(to_array(largest).map(|e| round_up(e * margin))),
        typical: from_array(to_array(largest_typical).map(|e| round_up(e * margin))),
        quantile_999: from_array(typical.map(|list| round_up(quantile_999(list)))),
        points: measured,
        digest: digest(&data),
        ..table.certificate
    }
}

/// A typical collision: drawn from MP13's tables for a wide table, uniform in the domain otherwise.
fn typical_collision(options: &FitOptions, rng: &mut Rng) -> Groups<f64> {
    if !options.typical.is_empty() {
        return draw_from_mp13(options.law, rng);
    }
    uniform_collision(&options.domain, rng)
}

/// Uniform in eccentricity, softness and damping; some exactly on a face.
fn uniform_collision(domain: &Domain, rng: &mut Rng) -> Groups<f64> {
    let sin_max = libm::sqrt(1.0 - domain.cos_min * domain.cos_min);
    let face = rng.uniform();
    let sin = if face < 0.04 { 0.0 } else { rng.uniform() * sin_max };
    // One in four is grazing, its cosine uniform in the logarithm.
    let grazing = face > 0.5 && face < 0.75;
    let cos = if grazing {
        rng.log_uniform(domain.cos_min, 1.0)
    } else {
        libm::sqrt((1.0 - sin) * (1.0 + sin))
    };
    let sin = if grazing { libm::sqrt((1.0 - cos) * (1.0 + cos)) } else { sin };
    let soft = rng.uniform() * if domain.softness_max > 0.3 { rng.uniform() } else { 1.0 };
    let soft = if face > 0.96 { 1.0 } else { soft };
    let c_dis = match face {
        f if f > 0.02 && f < 0.06 => 0.0,
        f if f < 0.6 && domain.c_dis_max > 2.0 => rng.log_uniform(1e-4, domain.c_dis_max),
        _ => domain.c_dis_max * rng.uniform(),
    };
    let eta = if face > 0.06 && face < 0.07 { 0.0 } else { domain.softness_max * cos * soft };
    Groups { sin, cos, eta, c_dis }
}

/// A corner, face or inner point of one leaf.
fn leaf_point<C: EncodeNumber>(
    options: &FitOptions,
    table: &GeneratedTable<C>,
    n: usize,
    rng: &mut Rng,
) -> Groups<f64> {
    let leaf = n % table.cubes.len();
    let y = test_point(n / table.cubes.len(), rng);
    let [kappa, eta, c_dis] = options.coordinates.groups_at(table.cubes[leaf].at(y));
    let whole = kappa + eta;
    Groups { sin: libm::sqrt(kappa / whole), cos: libm::sqrt(eta / whole), eta, c_dis }
}

/// The error of the reader for which the table is meant; for `f32` the larger of those of both floats.
/// `None` outside the domain.
fn error_at<C: EncodeNumber>(
    options: &FitOptions,
    reader: NumberType,
    data: &TableData<'_, C>,
    g: &Groups<f64>,
) -> Option<ScaledRestitution<f64>> {
    match reader {
        NumberType::F64 => Some(difference(exact(options, g), data.read(g)?, 0.0)),
        NumberType::F32 => {
            let (g, got) = read_in::<f32, C>(data, g)?;
            let truth = exact(options, &g);
            let double = data.read(&g).map_or(ZERO, |double| difference(truth, double, 0.0));
            Some(max_of_each(difference(truth, got, 0.0), double))
        }
        #[cfg(feature = "fixed")]
        NumberType::I32F32 => fixed_error(options, read_in::<I32F32, C>(data, g)?),
        #[cfg(feature = "fixed")]
        NumberType::I16F16 => fixed_error(options, read_in::<I16F16, C>(data, g)?),
    }
}

/// The groups as `S` has them, and what the table says to them in `S`.
fn read_in<S: Real, C: EncodeNumber>(
    data: &TableData<'_, C>,
    g: &Groups<f64>,
) -> Option<(Groups<f64>, ScaledRestitution<f64>)> {
    let [sin, cos, eta, c_dis] = [g.sin, g.cos, g.eta, g.c_dis].map(S::from_f64);
    let got = data.read(&Groups { sin, cos, eta, c_dis })?;
    let [sin, cos, eta, c_dis] = [sin, cos, eta, c_dis].map(S::to_f64);
    let got = from_array([got.tau, got.speed, got.angle, got.separation].map(S::to_f64));
    Some((Groups { sin, cos, eta, c_dis }, got))
}

/// A fixed-point number has no relative precision: durations below T count as T.
#[cfg(feature = "fixed")]
fn fixed_error(
    options: &FitOptions,
    (g, got): (Groups<f64>, ScaledRestitution<f64>),
) -> Option<ScaledRestitution<f64>> {
    Some(difference(exact(options, &g), got, 1.0))
}

fn exact(options: &FitOptions, g: &Groups<f64>) -> ScaledRestitution<f64> {
    let integrate = if options.precise { integrate_radial } else { integrate_radial_quickly };
    restitution(options.end, g, |kappa| integrate(options.law, options.end, kappa, g.eta, g.c_dis))
}

/// Of the duration relative to it, or to `least` if that is longer.
fn difference(
    exact: ScaledRestitution<f64>,
    got: ScaledRestitution<f64>,
    least: f64,
) -> ScaledRestitution<f64> {
    let tau =
        if exact.tau < least { (got.tau - exact.tau) / least } else { got.tau / exact.tau - 1.0 };
    ScaledRestitution {
        tau: tau.abs(),
        speed: (got.speed - exact.speed).abs(),
        angle: (got.angle - exact.angle).abs(),
        separation: (got.separation - exact.separation).abs(),
    }
}

fn to_array(s: ScaledRestitution<f64>) -> [f64; 4] {
    [s.tau, s.speed, s.angle, s.separation]
}

fn from_array([tau, speed, angle, separation]: [f64; 4]) -> ScaledRestitution<f64> {
    ScaledRestitution { tau, speed, angle, separation }
}

/// The larger of each; NaN counts as infinite.
fn max_of_each(a: ScaledRestitution<f64>, b: ScaledRestitution<f64>) -> ScaledRestitution<f64> {
    let max = |a: f64, b: f64| {
        if b <= a {
            a
        } else if b.is_nan() {
            f64::INFINITY
        } else {
            b
        }
    };
    ScaledRestitution {
        tau: max(a.tau, b.tau),
        speed: max(a.speed, b.speed),
        angle: max(a.angle, b.angle),
        separation: max(a.separation, b.separation),
    }
}

fn quantile_999(mut errors: Vec<f64>) -> f64 {
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
fn digest<C: EncodeNumber>(data: &TableData<'_, C>) -> u64 {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    let mut eat = |byte: u8| hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    eat(u8::from(data.coordinates.law == Law::Viscoelastic));
    eat(u8::from(data.coordinates.wide));
    eat(data.coordinates.end as u8);
    let d = &data.domain;
    let f = &data.coordinates;
    for number in [
        d.softness_max,
        d.c_dis_max,
        d.cos_min,
        d.sin_min,
        d.c_dis_softness_max,
        f.kappa_scale,
        f.softness_max,
        f.c_dis_max,
        f.coupling,
    ] {
        number.le_bytes().into_iter().for_each(&mut eat);
    }
    for b in data.branches {
        eat(b.axis);
        b.low.to_le_bytes().into_iter().chain(b.high.to_le_bytes()).for_each(&mut eat);
    }
    for l in data.leaves {
        l.first_row
            .to_le_bytes()
            .into_iter()
            .chain(l.first_coefficient.to_le_bytes())
            .for_each(&mut eat);
        l.rows.into_iter().chain(l.terms).chain([u8::from(l.direct_angle)]).for_each(&mut eat);
    }
    data.rows.iter().flat_map(|r| [r.orders, r.terms]).for_each(&mut eat);
    data.coefficients.iter().flat_map(|c| c.le_bytes()).for_each(&mut eat);
    hash
}
