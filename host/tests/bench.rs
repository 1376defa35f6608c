//! Does `carom bench` measure what it says? Runs short parts of its cases; writes nothing.

use carom_host::bench::{self, Case, Contact, Effort, Row};
use std::f64::consts::PI;
use std::process::Command;

/// A short part of a case.
fn part(case: &Case, collisions: u64) -> Row {
    bench::measure_with(case, Effort { equilibration: collisions, collisions }).unwrap()
}

/// Packing fractions and sizes as they were asked for.
#[test]
fn the_cases_are_those_that_were_asked_for() {
    let packing = |name: &str| {
        let [case] = bench::named(name)[..] else { panic!("{name}") };
        assert_eq!(case.dimension, 3);
        case.count as f64 * 4.0 / 3.0 * PI * case.radius().powi(3) / case.edge().powi(3)
    };
    for (name, wanted) in [
        ("hs3d-1372", 0.2618),
        ("hs3d-13500", 0.2618),
        ("hs3d-108000", 0.2618),
        ("hs3d-1000000", 0.2618),
        ("hs3d-dilute", 0.01),
        ("hs3d-dilute-0.001", 0.001),
        ("emdstar-10000-0.001", 0.001),
        ("emdstar-10000-0.01", 0.01),
    ] {
        assert!((packing(name) / wanted - 1.0).abs() < 1e-4, "{name}: {}", packing(name));
    }
    assert_eq!(bench::named("emdstar-10000").len(), 2);
    assert_eq!(bench::named("hs3d").len(), 6);
    assert!(bench::named("hs3d-13").is_empty());
}

/// Every case starts and collides; a world of 3D doubles takes no more than 256 bytes a grain.
#[test]
fn every_case_runs() {
    for case in bench::ALL.iter().filter(|case| case.count < 20_000) {
        let row = part(case, 500);
        assert_eq!(row.events, 500, "{}", case.name);
        assert!(row.bytes_per_grain <= 256.0, "{}: {} bytes", case.name, row.bytes_per_grain);
        assert!(row.simulated > 0.0);
    }
}

/// The gas of MP13 collides as often as kinetic theory says: √2 n π σ² v̄ N/2 with v̄ = √(8kT/πm),
/// and a contact value of 1.025 at packing 0.01 (Carnahan & Starling 1969).
#[test]
fn the_viscoelastic_gas_collides_as_often_as_it_must() {
    let [case] = bench::named("emdstar-10000-0.01")[..] else { panic!() };
    assert!(matches!(case.contact, Contact::Viscoelastic { star: true, .. }));
    let row = part(&case, 3000);
    let density = case.count as f64 / case.edge().powi(3);
    let mean_speed = (8.0 / PI).sqrt() * case.speed();
    let rate = 0.5 * 2f64.sqrt() * density * PI * 0.04 * mean_speed * case.count as f64 * 1.025;
    let found = row.events as f64 / row.simulated;
    // 3,000 collisions: a standard error of 2 %.
    assert!((found / rate - 1.0).abs() < 0.07, "{found} for {rate} collisions a second");
}

#[test]
fn the_json_has_the_six_fields() {
    let mut carom = Command::new(env!("CARGO_BIN_EXE_carom"));
    let output = carom.args(["bench", "nothing"]).output().unwrap();
    assert!(!output.status.success());
    let why = String::from_utf8(output.stderr).unwrap();
    assert!(why.contains("there is no case nothing; there are hs3d-1372,"), "{why}");
    let [case] = bench::named("small-32")[..] else { panic!() };
    let row = serde_json::to_value(part(&case, 1000)).unwrap();
    let fields: Vec<&String> = row.as_object().unwrap().keys().collect();
    let mut wanted =
        ["case", "n", "collisions_per_s", "bytes_per_grain", "clustered", "events", "seconds"];
    wanted.sort_unstable();
    assert_eq!(fields, wanted);
}
