//! Does MP13's Fig. 6 come out? Reads the reference's path of two soft grains; checks eMD* and eMD after the contact.

use carom::law::{Central, LinearDashpot, Outside, Rule, Soft, embedded};
use carom::{Grain, Memory, World};
use carom_host::integrated::Integrated;
use serde_json::Value;
use std::path::Path;

/// MP13 §VI.A: k = 2 kN/m, R = 0.1 m, ρ = 1140 kg/m³, elastic.
const LAW: LinearDashpot<f64> = LinearDashpot { stiffness: 2000.0, damping: 0.0 };
const CONTACT_DISTANCE: f64 = 0.2;

struct Path6 {
    tau: f64,
    t_over_tau: Vec<f64>,
    md: [Vec<[f64; 2]>; 2],
    emd_velocity: [[f64; 2]; 2],
    /// Where E^φ puts the two.
    turned: [[f64; 2]; 2],
    degrees: f64,
}

fn reference() -> Path6 {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/fig6-path.json");
    let json: Value = serde_json::from_str(&std::fs::read_to_string(file).unwrap()).unwrap();
    let record = &json[0];
    let numbers = |key: &str| -> Vec<f64> {
        record[key].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
    };
    let vector = |v: &Value| [v[0].as_f64().unwrap(), v[1].as_f64().unwrap()];
    let path = |key: &str| record[key].as_array().unwrap().iter().map(vector).collect();
    Path6 {
        tau: record["tau"].as_f64().unwrap(),
        t_over_tau: numbers("t_over_tau"),
        md: [path("md_x1"), path("md_x2")],
        emd_velocity: [vector(&record["emd_v1"]), vector(&record["emd_v2"])],
        turned: [vector(&record["emdstar_x1_t0plus"]), vector(&record["emdstar_x2_t0plus"])],
        degrees: record["angle_deg_md_vs_emd"].as_f64().unwrap(),
    }
}

/// The two grains a little before the impact, so that it is an event like any other.
const EARLY: f64 = 0.01;

fn grains(path: &Path6) -> [Grain<f64, 2>; 2] {
    let v = [[1.25, 2.5], [1.25, -2.5]];
    [0, 1].map(|i| {
        let [x, y] = path.md[i][0];
        let at = [x - v[i][0] * EARLY, y - v[i][1] * EARLY];
        Grain::with_mass(0.1, 4.775_220_833_456_486).at(at).moving(v[i])
    })
}

fn distance(a: &carom::scalar::Vector<f64, 2>, b: &[f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// The largest distance from the MD path in units of l, at t = j τ/7 once the contact is over.
fn off(rule: impl Rule<f64>, path: &Path6) -> f64 {
    let mut memory = Memory::<f64, 2, 2>::new();
    let mut world =
        World::builder(&mut memory).rule(rule).grains(grains(path)).unwrap().start().unwrap();
    let mut worst = 0.0_f64;
    for (j, t) in path.t_over_tau.iter().enumerate().filter(|(_, t)| **t > 1.0) {
        world.advance_to(EARLY + t * path.tau).unwrap();
        for i in 0..2 {
            let at = world.grain(i).unwrap().position;
            worst = worst.max(distance(&at, &path.md[i][j]) / CONTACT_DISTANCE);
        }
    }
    worst
}

#[test]
fn integrated_it_is_the_md_path() {
    let path = reference();
    let worst = off(Integrated::new(LAW), &path);
    assert!(worst < 1e-9, "{worst:e} l");
}

/// A table promises less than the figure could show: what its certificate says, carried over
/// the path after the contact, which is 2 l long in each grain's own frame.
#[test]
fn with_wide_and_fine_tables_it_is_the_md_path_within_the_certificate() {
    let path = reference();
    for table in [&embedded::wide::LINEAR_DASHPOT, &embedded::fine::LINEAR_DASHPOT] {
        let worst = off(Soft::with_table(LAW, table, Outside::Reject), &path);
        let promised = &table.certificate.quantile_999;
        let bound = 2.0 * (promised.angle + promised.speed + promised.tau) + promised.separation;
        println!("{worst:e} l, promised for 99.9 % of collisions: {bound:e} l");
        assert!(worst < bound, "{worst:e} l against {bound:e} l");
    }
}

#[test]
fn the_turn_puts_both_grains_where_the_reference_does() {
    let path = reference();
    let mut memory = Memory::<f64, 2, 2>::new();
    let rule = Integrated::new(LAW);
    let mut world =
        World::builder(&mut memory).rule(rule).grains(grains(&path)).unwrap().start().unwrap();
    world.step().unwrap();
    for i in 0..2 {
        let d = distance(&world.grain(i).unwrap().position, &path.turned[i]);
        assert!(d < 1e-12, "{d:e}");
    }
}

#[test]
fn emd_takes_the_reference_s_wrong_way() {
    let path = reference();
    let mut memory = Memory::<f64, 2, 2>::new();
    let rule = Central(Integrated::new(LAW));
    let mut world =
        World::builder(&mut memory).rule(rule).grains(grains(&path)).unwrap().start().unwrap();
    world.step().unwrap();
    let v = [0, 1].map(|i| world.grain(i).unwrap().velocity);
    for (v, wanted) in v.iter().zip(&path.emd_velocity) {
        let d = distance(v, wanted);
        assert!(d < 1e-11, "{d:e}");
    }
    // The direction of the relative motion afterwards, against that of the MD path.
    let n = path.md[0].len() - 1;
    let md: Vec<f64> = (0..2)
        .map(|a| {
            (path.md[0][n][a] - path.md[1][n][a]) - (path.md[0][n - 1][a] - path.md[1][n - 1][a])
        })
        .collect();
    let emd = v[0] - v[1];
    let cos = (emd[0] * md[0] + emd[1] * md[1]) / (emd.dot(&emd).sqrt() * md[0].hypot(md[1]));
    let degrees = cos.acos().to_degrees();
    assert!((degrees - path.degrees).abs() < 1e-6 && (degrees - 98.8).abs() < 0.05, "{degrees}");
}
