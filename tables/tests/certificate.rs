//! Do tables keep what their certificates promise? Reads tables at fresh points; writes nothing.

use carom_tables::collision::draw_from_mp13;
use carom_tables::contact::integrate;
use carom_tables::random::Rng;
use carom_tables::read::{End, Groups, Law, ScaledRestitution};
use carom_tables::recipe::{GeneratedTable, NumberType, Recipe};
use proptest::prelude::*;
use std::sync::LazyLock;

const LAWS: [Law; 2] = [Law::LinearDashpot, Law::Viscoelastic];

static COMPACT: LazyLock<[GeneratedTable<f32>; 2]> =
    LazyLock::new(|| LAWS.map(|law| Recipe::compact(law).generate().unwrap()));

fn single(g: &Groups<f64>) -> Groups<f32> {
    Groups { sin: g.sin as f32, cos: g.cos as f32, eta: g.eta as f32, c_dis: g.c_dis as f32 }
}

fn double(g: &Groups<f32>) -> Groups<f64> {
    Groups { sin: g.sin.into(), cos: g.cos.into(), eta: g.eta.into(), c_dis: g.c_dis.into() }
}

/// Is the reading at `g` as good as promised? `None` outside the domain.
fn holds(table: &GeneratedTable<f32>, g: &Groups<f64>, end: End) -> Option<()> {
    let g32 = single(g);
    let g = double(&g32);
    let got = table.data().read(&g32)?;
    let truth = integrate(table.certificate.law, end, &g);
    let p = &table.certificate.largest;
    let pairs = [
        (f64::from(got.tau) / truth.tau, 1.0, p.tau),
        (got.speed.into(), truth.speed, p.speed),
        (got.angle.into(), truth.angle, p.angle),
        (got.separation.into(), truth.separation, p.separation),
    ];
    for (got, want, promised) in pairs {
        assert!((got - want).abs() <= promised, "{g:?}: {got} for {want}, promised {promised:e}");
    }
    Some(())
}

#[test]
fn compact_certificates_hold_at_fresh_points() {
    let mut rng = Rng::new(0xabcd);
    for table in COMPACT.iter() {
        for _ in 0..2_000 {
            let sin = rng.uniform();
            let cos = ((1.0 - sin) * (1.0 + sin)).sqrt();
            let g = Groups { sin, cos, eta: 0.2 * cos * rng.uniform(), c_dis: rng.uniform() };
            holds(table, &g, End::Force);
        }
    }
}

#[test]
fn compact_and_standard_keep_their_budgets() {
    for (table, law) in COMPACT.iter().zip(LAWS) {
        let c = &table.certificate;
        assert!(c.bytes <= 8 * 1024 && worst(&c.largest) < 1e-3, "{law:?}: {c:?}");
        let c = Recipe::standard(law).points(1_000).generate::<f32>().unwrap().certificate;
        assert!(c.bytes <= 24 * 1024 && worst(&c.largest) < 1e-5, "{law:?}: {c:?}");
    }
}

#[test]
#[ignore = "seconds in release: cargo test --release -p carom-tables -- --ignored"]
fn wide_and_fine_certificates_hold_over_the_tables_of_mp13() {
    for law in LAWS {
        let sizes = [(Recipe::wide(law), 96, 1e-2, 1e-3), (Recipe::fine(law), 256, 1e-3, 1e-4)];
        for (recipe, kib, typical, most) in sizes {
            let table = recipe.generate::<f32>().unwrap();
            let c = &table.certificate;
            assert!(c.bytes <= kib * 1024, "{} bytes", c.bytes);
            assert!(worst(&c.typical) < typical && worst(&c.quantile_999) < most, "{c:?}");
            let mut rng = Rng::new(0x1234);
            for _ in 0..20_000 {
                let g = draw_from_mp13(law, &mut rng);
                assert!(holds(&table, &g, End::Force).is_some(), "{g:?} is outside");
            }
        }
    }
}

fn worst(s: &ScaledRestitution<f64>) -> f64 {
    s.tau.max(s.speed).max(s.angle).max(s.separation)
}

#[test]
fn the_built_in_limits_are_exact() {
    for table in COMPACT.iter() {
        for sin in [0.0_f64, 0.2, 0.9, 0.9999] {
            let cos = (1.0 - sin * sin).sqrt();
            let elastic = Groups { sin, cos, eta: 0.19 * cos, c_dis: 0.0 };
            let s = table.data().read(&elastic).unwrap();
            assert_eq!((s.speed, s.separation), (1.0, 1.0));
            let s = table.data().read(&single(&elastic)).unwrap();
            assert_eq!((s.speed, s.separation), (1.0, 1.0));
            let stiff = Groups { eta: 0.0, c_dis: 0.7, ..elastic };
            let s = table.data().read(&stiff).unwrap();
            assert_eq!((s.angle, s.separation), (0.0, 1.0));
        }
    }
}

/// The digests that this version makes, on every machine and in every build.
#[test]
fn digests_are_the_same_everywhere() {
    let digests = COMPACT.each_ref().map(|table| table.certificate.digest);
    assert_eq!(digests, [COMPACT_LINEAR, COMPACT_VISCOELASTIC], "{digests:#018x?}");
    let again = Recipe::compact(LAWS[0]).search().generate::<f32>().unwrap();
    assert_eq!(again.certificate, COMPACT[0].certificate);
}
const COMPACT_LINEAR: u64 = 0xb5d7_1089_14bb_74a6;
const COMPACT_VISCOELASTIC: u64 = 0x2b4e_c100_1173_4c0a;

/// The kept bisections are what a search finds.
#[test]
#[ignore = "searches: cargo test --release -p carom-tables -- --ignored"]
fn kept_bisections_are_what_a_search_finds() {
    for law in LAWS {
        for recipe in [Recipe::standard(law), Recipe::wide(law), Recipe::fine(law)] {
            let recipe = recipe.points(100);
            let kept = recipe.generate::<f32>().unwrap();
            let found = recipe.search().generate::<f32>().unwrap();
            assert_eq!(kept.bisection(), found.bisection());
            assert_eq!(kept.certificate.digest, found.certificate.digest);
        }
    }
}

#[test]
fn tables_of_luding_1994_end_with_the_overlap() {
    for law in LAWS {
        let recipe = Recipe::compact(law).end(End::Overlap).c_dis_max(0.5).points(1_000);
        let table = recipe.generate::<f32>().unwrap();
        assert!(worst(&table.certificate.largest) < 1e-3, "{:?}", table.certificate);
        let g = Groups { sin: 0.6, cos: 0.8, eta: 0.1, c_dis: 0.3 };
        holds(&table, &g, End::Overlap).unwrap();
    }
}

#[test]
fn double_precision_tables_go_below_single_precision() {
    let recipe =
        Recipe::standard(Law::LinearDashpot).softness_max(0.02).c_dis_max(0.2).cos_min(0.2);
    let table = recipe.tolerance(2e-8).points(200).generate::<f64>().unwrap();
    assert!(worst(&table.certificate.largest) < 1e-7, "{:?}", table.certificate);
}

#[test]
fn bad_recipes_name_the_field() {
    let recipe = || Recipe::compact(Law::Viscoelastic);
    let cases = [
        (recipe().softness_max(f64::NAN), "softness_max"),
        (recipe().c_dis_max(-1.0), "c_dis_max"),
        (recipe().cos_min(0.0), "cos_min"),
        (recipe().tolerance(0.0), "tolerance"),
        (recipe().points(3), "points"),
        (recipe().terms_max(1), "terms_max"),
        (recipe().bytes_max(40), "bytes_max"),
        (recipe().end(End::Overlap).c_dis_max(30.0), "c_dis_max"),
    ];
    for (recipe, field) in cases {
        let error = recipe.emit("X").unwrap_err().to_string();
        assert!(error.contains(field), "{error}");
    }
    assert!(recipe().emit("no name").unwrap_err().to_string().contains("no name"));
    let text = recipe().number_type(NumberType::F64).points(200).emit("MINE").unwrap();
    assert!(text.contains("pub static MINE: ::carom_tables::read::Table<f64>"));
}

#[test]
fn budgets_in_bytes_are_kept() {
    let table = Recipe::standard(Law::LinearDashpot).bytes_max(900).points(200);
    let table = table.generate::<f32>().unwrap();
    assert!(table.certificate.bytes <= 900 && worst(&table.certificate.largest) < 1e-2);
}

proptest! {
    #[test]
    fn reading_never_panics_and_never_gives_nan(
        sin in proptest::num::f32::ANY, cos in proptest::num::f32::ANY,
        eta in proptest::num::f32::ANY, c_dis in proptest::num::f32::ANY,
    ) {
        for table in COMPACT.iter() {
            let g = Groups { sin, cos, eta, c_dis };
            let data = table.data();
            prop_assert_eq!(data.read(&g).is_some(), data.domain.contains(&g));
            let near = data.domain.clamp(&g);
            let s = data.read(&near);
            prop_assert!(s.is_some(), "{near:?}");
            let s = s.unwrap();
            prop_assert!(s.tau > 0.0 && s.tau.is_finite());
            prop_assert!((0.0..=1.0).contains(&s.speed));
            prop_assert!((0.0..=3.2).contains(&s.angle) && s.separation <= 1.0);
        }
    }

    #[test]
    fn integrating_never_panics_and_stays_finite(
        sin in 0.0..1.0_f64, eta in 0.0..12.0_f64, power in -6.0..6.0_f64,
    ) {
        for law in LAWS {
            let g = Groups { sin, cos: (1.0 - sin * sin).sqrt(), eta, c_dis: 10_f64.powf(power) };
            let s = integrate(law, End::Force, &g);
            prop_assert!(s.tau > 0.0 && s.tau.is_finite());
            prop_assert!((0.0..=1.0).contains(&s.speed) && s.angle.is_finite());
        }
    }
}
