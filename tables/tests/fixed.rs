//! Do fixed-point numbers count right? Compares them with whole-number and f64 references; writes nothing.
#![cfg(feature = "fixed")]

use carom_tables::contact::integrate;
use carom_tables::fixed_point::integer::{quotient, root_of_difference};
use carom_tables::fixed_point::{I16F16, I32F32};
use carom_tables::random::Rng;
use carom_tables::read::{End, Groups, Law, Quantised, Real};
use carom_tables::recipe::{NumberType, Recipe};
use proptest::prelude::*;

const ULP: f64 = 1.0 / 4_294_967_296.0;
const ULP16: f64 = 1.0 / 65_536.0;

/// Bits of all sizes.
fn bits() -> impl Strategy<Value = i64> {
    (any::<i64>(), 0_u32..63).prop_map(|(x, shift)| x >> shift)
}

fn number(bits: i64) -> I32F32 {
    I32F32::from_bits(bits)
}

/// What a result that fits must be; what does not must be no number.
fn is(got: I32F32, want: Option<i128>) -> bool {
    match want.and_then(|w| i64::try_from(w).ok()).filter(|&w| w != i64::MIN) {
        Some(want) => got.to_bits() == want,
        None => !got.is_number(),
    }
}

/// Whether r is the whole number nearest to √(n/4): (r − 1/2)² ≤ n/4 ≤ (r + 1/2)².
fn is_root(r: i128, n: i128) -> bool {
    (r == 0 || (2 * r - 1) * (2 * r - 1) <= n) && n <= (2 * r + 1) * (2 * r + 1)
}

/// n/d to the nearest, halves away from zero.
fn rounded(n: i128, d: i128) -> i128 {
    let q = (2 * n.abs() + d.abs()) / (2 * d.abs());
    if (n < 0) == (d < 0) { q } else { -q }
}

proptest! {
    #[test]
    fn four_operations_are_exact_or_nearest_or_no_number(a in bits(), b in bits()) {
        let (x, y) = (number(a), number(b));
        let known = |f: fn(i128, i128) -> i128| {
            (a != i64::MIN && b != i64::MIN).then(|| f(a.into(), b.into()))
        };
        prop_assert!(is(x + y, known(|a, b| a + b)));
        prop_assert!(is(x - y, known(|a, b| a - b)));
        prop_assert!(is(x * y, known(|a, b| rounded(a * b, 1 << 32))));
        prop_assert!(is(-x, known(|a, _| -a)));
        if b == 0 {
            prop_assert!(!(x / y).is_number());
        } else {
            prop_assert!(is(x / y, known(|a, b| rounded(a << 32, b))));
        }
    }

    #[test]
    fn products_add_up_exactly_and_no_number_stays_none(a in bits(), b in bits(), c in bits()) {
        let (x, y, z) = (number(a), number(b), number(c));
        let sum = x.times(y) - y.times(z);
        let want = [a, b, c].iter().all(|&v| v != i64::MIN).then(|| {
            i128::from(a) * i128::from(b) - i128::from(b) * i128::from(c)
        });
        prop_assert_eq!(sum.bits(), want);
        prop_assert!(is(sum.rounded(), want.map(|w| rounded(w, 1 << 32))));
        let bad = I32F32::NAN;
        for r in [bad + x, x - bad, bad * x, x / bad, -bad, bad.sqrt(), bad.cbrt(), bad.ln_1p()] {
            prop_assert!(!r.is_number());
        }
        prop_assert!(bad != x && bad != bad.sqrt() && bad.partial_cmp(&x).is_none());
        prop_assert!(x.partial_cmp(&bad).is_none() && x.times(bad).partial_cmp(&x.times(x)).is_none());
    }

    #[test]
    fn square_roots_are_the_nearest(a in bits()) {
        let (x, r) = (number(a), number(a).sqrt());
        if a < 0 {
            prop_assert!(!r.is_number());
            return Ok(());
        }
        let (r, n) = (i128::from(r.to_bits()), i128::from(a) << 34);
        prop_assert!(is_root(r, n));
        let s = x.times(x).root();
        prop_assert_eq!(s.to_bits(), a);
    }

    #[test]
    fn sines_are_the_nearest(a in -(1_i64 << 52)..(1 << 52)) {
        let x = number(a);
        let (sine, cosine) = x.sin_cos();
        let (s, c) = x.to_f64().sin_cos();
        // 1e-6 ulp is what f64 adds.
        prop_assert!((sine.to_f64() - s).abs() <= 0.500_001 * ULP, "{x}: {sine} for {s}");
        prop_assert!((cosine.to_f64() - c).abs() <= 0.500_001 * ULP, "{x}: {cosine} for {c}");
        let narrow = I16F16::from_bits(a as i32 | 1);
        let (sine, cosine) = narrow.sin_cos();
        let (s, c) = narrow.to_f64().sin_cos();
        prop_assert!((sine.to_f64() - s).abs() <= 0.500_001 * ULP16);
        prop_assert!((cosine.to_f64() - c).abs() <= 0.500_001 * ULP16);
    }

    #[test]
    fn fifth_roots_are_within_half_a_step(a in bits(), b in bits()) {
        let [a, b] = [a, b].map(|x| x.checked_abs().unwrap_or(1).max(1));
        let x = number(a);
        let got = I32F32::inverse_fifth_root([x]).to_f64();
        let want = x.to_f64().powf(-0.2);
        prop_assert!((got - want).abs() <= 0.501 * ULP, "{x}: {got} for {want}");
        // MP13's T = k^(−2/5) v^(−1/5), where k² v is far out of range.
        let y = number(b);
        let got = I32F32::inverse_fifth_root([x, x, y]);
        let want = (x.to_f64().ln().mul_add(-0.4, y.to_f64().ln() * -0.2)).exp();
        prop_assert!((got.to_f64() - want).abs() <= 0.501 * ULP + 1e-14 * want, "{x} {y}: {got}");
    }

    #[test]
    fn cube_roots_and_logarithms_are_as_stated(a in 0..i64::MAX, shift in 0_u32..63) {
        let x = number(a >> shift);
        let (root, log) = (x.cbrt().to_f64(), x.ln_1p().to_f64());
        prop_assert!((root - x.to_f64().cbrt()).abs() <= 0.501 * ULP, "{x}: {root}");
        prop_assert!((log - x.to_f64().ln_1p()).abs() <= 0.6 * ULP, "{x}: {log}");
    }

    #[test]
    fn floats_become_the_nearest_and_come_back(a in bits(), f in any::<f64>(), g in any::<f32>()) {
        let x = number(a);
        if x.is_number() {
            prop_assert_eq!(x.to_f64().to_bits(), (a as f64 * ULP).to_bits());
        }
        for (got, value) in [(I32F32::from_f64(f), f), (I32F32::from_f32(g), f64::from(g))] {
            if value.abs() < 2_147_483_000.0 {
                prop_assert!((got.to_f64() - value).abs() <= 0.5 * ULP, "{value}: {got}");
            } else if !(value.abs() < 2_147_483_649.0) {
                prop_assert!(!got.is_number(), "{value}: {got}");
            }
        }
    }

    #[test]
    fn quotients_of_wide_numbers_are_the_nearest(n in any::<u64>(), d in 1..u64::MAX, shift in 0_u32..60) {
        let (wide, d) = (u128::from(n) << shift, u128::from(d));
        let want = (2 * wide + d) / (2 * d);
        prop_assert_eq!(quotient(n.into(), d, shift), i64::try_from(want).ok());
    }

    #[test]
    fn discriminants_of_256_bits_have_the_right_root(
        b in 1_u64..1 << 62, a in 1_u64..1 << 62, c in 1_u64..1 << 62, scale in 0_u32..62,
    ) {
        let [b, a, c] = [b, a, c].map(u128::from);
        let got = root_of_difference(b << scale, a << scale, c << scale);
        match (b * b).checked_sub(a * c).filter(|&d| d > 0) {
            None => prop_assert_eq!(got, None),
            Some(d) => {
                let want = (d as f64).sqrt() * 2_f64.powi(scale as i32);
                let got = got.unwrap() as f64;
                prop_assert!((got - want).abs() <= 1e-15 * want + 1.0, "{got} for {want}");
            }
        }
    }

    #[test]
    fn narrow_numbers_overflow_to_no_number(a in any::<i32>(), b in any::<i32>()) {
        let (x, y) = (I16F16::from_bits(a), I16F16::from_bits(b));
        let whole = a != i32::MIN && b != i32::MIN;
        let want = |w: i64| i32::try_from(w).ok().filter(|&w| whole && w != i32::MIN);
        let got = |x: I16F16| x.is_number().then(|| x.to_bits());
        prop_assert_eq!(got(x + y), want(i64::from(a) + i64::from(b)));
        let product = rounded(i128::from(a) * i128::from(b), 1 << 16);
        prop_assert_eq!(got(x * y), want(product as i64));
        if b != 0 {
            prop_assert_eq!(got(x / y), want(rounded(i128::from(a) << 16, b.into()) as i64));
        }
        let n = i128::from(a) << 18;
        let r = i128::from(x.sqrt().to_bits());
        prop_assert!(a < 0 || is_root(r, n));
    }
}

#[test]
fn numbers_are_shown_as_decimals() {
    let x = I32F32::from_f64(-2.5);
    assert_eq!(
        (x.to_string(), format!("{x:.3}"), I32F32::NAN.to_string()),
        ("-2.5".into(), "-2.500".into(), "NaN".into())
    );
    assert_eq!(Option::<fixed::types::I32F32>::from(x), Some(fixed::types::I32F32::from_num(-2.5)));
    assert_eq!(I16F16::from(fixed::types::I16F16::from_num(0.75)).to_f64(), 0.75);
}

/// Is what the table says in `S`, at the groups as `S` has them, as good as promised?
fn holds<S: Real>(law: Law, number_type: NumberType, points: u32) {
    let table = Recipe::compact(law).number_type(number_type).generate::<Quantised>().unwrap();
    let promised = &table.certificate.largest;
    let (mut rng, mut inside) = (Rng::new(0x51d), 0);
    for _ in 0..points {
        let sin = rng.uniform();
        let cos = ((1.0 - sin) * (1.0 + sin)).sqrt();
        let g = [sin, cos, 0.2 * cos * rng.uniform(), rng.uniform()].map(S::from_f64);
        let [sin, cos, eta, c_dis] = g;
        let Some(got) = table.data().read(&Groups { sin, cos, eta, c_dis }) else { continue };
        inside += 1;
        let [sin, cos, eta, c_dis] = g.map(S::to_f64);
        let truth = integrate(law, End::Force, &Groups { sin, cos, eta, c_dis });
        let pairs = [
            (got.tau.to_f64() / truth.tau.max(1.0), truth.tau / truth.tau.max(1.0), promised.tau),
            (got.speed.to_f64(), truth.speed, promised.speed),
            (got.angle.to_f64(), truth.angle, promised.angle),
            (got.separation.to_f64(), truth.separation, promised.separation),
        ];
        for (got, want, promised) in pairs {
            assert!(
                (got - want).abs() <= promised,
                "{law:?} {number_type:?}: {got} for {want}, promised {promised:e}"
            );
        }
    }
    assert!(inside > points * 9 / 10);
}

#[test]
fn quantised_certificates_hold_at_fresh_points() {
    for law in [Law::LinearDashpot, Law::Viscoelastic] {
        holds::<I32F32>(law, NumberType::I32F32, 400);
        holds::<I16F16>(law, NumberType::I16F16, 400);
    }
}

#[test]
fn a_wide_table_cannot_be_quantised() {
    let error = Recipe::wide(Law::LinearDashpot)
        .number_type(NumberType::I32F32)
        .emit("WIDE")
        .map(|_| ())
        .unwrap_err();
    assert!(error.to_string().contains("number_type is I32F32"), "{error}");
}
