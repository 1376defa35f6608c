//! Are scenarios what they say, and do the methods agree on them? Reads the shipped scenarios; writes nothing.

use carom_host::compare;
use carom_host::scenario::{MethodName, Placed, Scenario, Side, Start, touching};
use proptest::prelude::*;
use std::f64::consts::PI;

const GAS: &str = include_str!("../scenarios/gas.toml");
const BEADS: &str = include_str!("../scenarios/beads.toml");
const FIG6: &str = include_str!("../scenarios/fig6.toml");

fn started(text: &str) -> Start {
    let scenario = Scenario::parse(text).expect("a good scenario");
    Start::new(&scenario).expect("a place for every grain")
}

/// Looks at every pair.
fn touching_by_brute_force(start: &Start, grains: &[Placed]) -> Vec<bool> {
    let overlap = |a: &Placed, b: &Placed| {
        let d = start.nearest(&a.position, &b.position);
        d.iter().map(|x| x * x).sum::<f64>() < (a.radius + b.radius).powi(2)
    };
    let mut flags = vec![false; grains.len()];
    for i in 0..grains.len() {
        for j in (0..grains.len()).filter(|&j| j != i) {
            flags[i] |= overlap(&grains[i], &grains[j]);
        }
    }
    flags
}

#[test]
fn shipped_scenarios_start_without_overlap() {
    for text in [GAS, BEADS, FIG6] {
        let start = started(text);
        assert!(!touching(&start, &start.grains).contains(&true));
        assert!(!touching_by_brute_force(&start, &start.grains).contains(&true));
    }
}

#[test]
fn the_gas_has_the_packing_fraction_and_temperature_of_its_file() {
    let start = started(GAS);
    let Side::Periodic([from, to]) = start.sides[0] else { panic!("not periodic") };
    let filled: f64 = start.grains.iter().map(|g| 4.0 / 3.0 * PI * g.radius.powi(3)).sum();
    assert!((filled / (to - from).powi(3) - 0.01).abs() < 1e-12);
    for axis in 0..3 {
        let momentum: f64 = start.grains.iter().map(|g| g.mass * g.velocity[axis]).sum();
        assert!(momentum.abs() < 1e-9, "momentum {momentum}");
        // <v_k^2> = v_th^2 / 2; the standard error of 1,000 normal numbers is 4.5 %.
        let square: f64 =
            start.grains.iter().map(|g| g.velocity[axis].powi(2)).sum::<f64>() / 1000.0;
        assert!((square / 2.0 - 1.0).abs() < 0.15, "<v^2> = {square}");
    }
}

#[test]
fn the_same_seed_gives_the_same_gas_and_another_one_another() {
    let other = GAS.replace("seed = 2013", "seed = 2014");
    assert_eq!(started(GAS), started(GAS));
    assert_ne!(started(GAS).grains, started(&other).grains);
}

#[test]
fn polydisperse_grains_keep_to_their_range_and_walls() {
    let start = started(BEADS);
    for grain in &start.grains {
        assert!((0.002..=0.004).contains(&grain.radius));
        assert_eq!((grain.position[2], grain.velocity[2]), (0.0, 0.0));
        for (side, x) in start.sides.iter().zip(grain.position).take(2) {
            let Side::Walls([from, to], ..) = *side else { panic!("not a soft wall") };
            assert!(x - grain.radius >= from && x + grain.radius <= to);
        }
    }
}

/// A crowded gas says so instead of looking for a place for ever.
#[test]
fn a_gas_that_does_not_fit_is_an_error() {
    let text = GAS
        .replace("packing_fraction = 0.01", "packing_fraction = 0.73")
        .replace("count = 1000", "count = 50");
    let scenario = Scenario::parse(&text).expect("a good scenario");
    let error = Start::new(&scenario).expect_err("no place").to_string();
    assert!(error.contains("cannot be reached"), "{error}");
}

/// Fifty grains for half a second: eMD* stays with force-based MD to the certificate of its table
/// (3e-7, grown by a few collisions), eMD is off by orders of magnitude more.
#[test]
fn emd_star_follows_md_and_emd_does_not() {
    let text = GAS
        .replace("count = 1000", "count = 50")
        .replace("packing_fraction = 0.01", "packing_fraction = 0.02")
        .replace("duration = 8.0", "duration = 0.6")
        .replace("dissipation = 4.0e-5", "dissipation = 0.0");
    let scenario = Scenario::parse(&text).expect("a good scenario");
    let (start, tracks) = compare::tracks(&scenario).expect("a run");
    let found = compare::summarise(&scenario, &start, &tracks).expect("a comparison");
    let rms = |method: MethodName| {
        let summary = found.methods.iter().find(|s| s.method == method).expect("the method");
        let difference =
            summary.series.last().and_then(|point| point.difference).expect("a difference");
        (summary.collisions, difference.rms / found.mean_radius)
    };
    let [(exact, _), (_, verlet), (_, emd), (counted, star)] =
        [MethodName::Exact, MethodName::Md, MethodName::Emd, MethodName::EmdStar].map(rms);
    assert!(exact >= 10, "only {exact} collisions");
    assert_eq!(exact, counted);
    assert!(star < 1e-4, "eMD* is off by {star} radii");
    assert!(emd > 1e-2, "eMD is off by {emd} radii only");
    assert!(star < verlet && verlet < emd, "{star} {verlet} {emd}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// The sweep finds what looking at every pair finds, across periodic faces too.
    #[test]
    fn touching_is_what_every_pair_says(
        places in prop::collection::vec((0.0f64..1.0, 0.0f64..1.0, 0.0f64..1.0, 0.01f64..0.2), 2..40)
    ) {
        let grains: Vec<Placed> = places
            .into_iter()
            .map(|(x, y, z, radius)| Placed {
                radius, mass: 1.0, position: [x, y, z], velocity: [0.0; 3],
            })
            .collect();
        let sides = [Side::Periodic([0.0, 1.0]), Side::Open, Side::Periodic([0.0, 1.0])];
        let start = Start { dimension: 3, grains, sides, ..Start::default() };
        prop_assert_eq!(
            touching(&start, &start.grains),
            touching_by_brute_force(&start, &start.grains)
        );
    }

    /// Whatever a scenario file holds, it is a scenario or one line that says why not.
    #[test]
    fn no_text_makes_the_reader_panic(text in "[a-z=\\[\\]{}\", .0-9\n]{0,200}") {
        if let Err(error) = Scenario::parse(&text) {
            prop_assert_eq!(error.to_string().lines().count(), 1);
        }
    }
}
