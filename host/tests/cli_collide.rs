//! Does `carom collide` answer as the reference collisions do? Reads tests/data/collisions.csv; writes nothing.

use std::collections::HashMap;
use std::path::PathBuf;
use std::process::{Command, Output};

fn data() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/data/collisions.csv"))
}

fn carom(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_carom")).args(arguments).output().expect("carom starts")
}

type Row = HashMap<String, String>;

fn rows(bytes: &[u8]) -> Vec<Row> {
    let mut reader = csv::Reader::from_reader(bytes);
    reader.deserialize().map(|row| row.expect("a CSV row")).collect()
}

fn number(row: &Row, column: &str) -> f64 {
    row[column].parse().unwrap_or_else(|_| panic!("{column} of {}: {:?}", row["id"], row[column]))
}

fn both(arguments: &[&str]) -> (Vec<Row>, Vec<Row>) {
    let data = data();
    let mut all = vec!["collide", data.to_str().expect("a path in UTF-8")];
    all.extend(arguments);
    let output = carom(&all);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let expected = rows(&std::fs::read(&data).expect("the reference data"));
    let got = rows(&output.stdout);
    assert_eq!(got.len(), expected.len());
    (got, expected)
}

const ABSOLUTE: [&str; 3] = ["one_minus_eps_r", "eps_rdot", "eps_phi"];

#[test]
fn integrated_results_are_within_1e_9_of_the_reference() {
    let (got, expected) = both(&["--with", "integrate"]);
    for (got, expected) in got.iter().zip(&expected) {
        let id = &expected["id"];
        assert_eq!(&got["id"], id);
        assert_eq!(got["status"], "ok");
        for column in ["tau", "eps_t"] {
            let (a, b) = (number(got, column), number(expected, column));
            assert!((a / b - 1.0).abs() <= 1e-9, "{id} {column}: {a} against {b}");
        }
        for column in ABSOLUTE {
            let (a, b) = (number(got, column), number(expected, column));
            assert!((a - b).abs() <= 1e-9, "{id} {column}: {a} against {b}");
        }
    }
}

/// Every answer inside a table's domain keeps the table's certificate, which `carom table --json`
/// prints; every law has such rows.
#[test]
fn table_results_are_within_their_certificates() {
    let output = carom(&["table", "--json"]);
    let tables: Vec<serde_json::Value> = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(tables.len(), 8);
    for table in &tables {
        let name = table["table"].as_str().expect("a name");
        let (got, expected) = both(&["--with", "table", "--table", name]);
        let promised = |column: &str| table["max"][column].as_f64().expect("a number");
        let mut inside = 0;
        for (got, expected) in got.iter().zip(&expected) {
            if expected["law"] != table["law"].as_str().expect("a law") || got["status"] != "ok" {
                continue;
            }
            inside += 1;
            let id = &expected["id"];
            let off = (number(got, "eps_t") / number(expected, "eps_t") - 1.0).abs();
            assert!(off <= promised("eps_t"), "{name} {id} eps_t: {off}");
            for (column, in_json) in ABSOLUTE.into_iter().zip(["eps_r", "eps_rdot", "eps_phi"]) {
                let off = (number(got, column) - number(expected, column)).abs();
                assert!(off <= promised(in_json), "{name} {id} {column}: {off}");
            }
        }
        let least = if ["wide", "fine"].contains(&name) { 80 } else { 20 };
        assert!(inside >= least, "{name}: only {inside} rows inside the domain");
    }
}

#[test]
fn outside_is_empty_unless_clamped() {
    let (plain, _) = both(&["--table", "compact"]);
    let (clamped, _) = both(&["--table", "compact", "--outside", "clamp"]);
    assert!(plain.iter().any(|row| row["status"] == "outside"));
    for (plain, clamped) in plain.iter().zip(&clamped) {
        assert_eq!(plain["status"], clamped["status"]);
        if plain["status"] == "outside" {
            assert_eq!(plain["eps_t"], "");
            assert!(number(clamped, "eps_t") > 0.0);
        } else {
            assert_eq!(plain, clamped);
        }
    }
}

/// Luding et al. (1994): a linear contact that ends at zero overlap lasts π/√(ω0² − μ²) and keeps
/// exp(−πμ/√(ω0² − μ²)) of its speed; with μ = γ/(2 m_eff).
#[test]
fn a_central_contact_that_ends_at_zero_overlap_is_the_closed_form() {
    let folder = tempfile::tempdir().expect("a temporary directory");
    let file = folder.path().join("cases.csv");
    let (stiffness, damping, mass) = (1.0e5, 20.0, 0.5f64);
    let row = format!("a,lsd,{stiffness},{damping},,,,0.1,0.1,1,1,0.2,0");
    std::fs::write(&file, format!("id,law,k,gamma,Y,nu,A,R1,R2,m1,m2,v,e\n{row}\n"))
        .expect("a file");
    let file = file.to_str().expect("a path in UTF-8");
    let mu = damping / (2.0 * mass);
    let omega = (stiffness / mass - mu * mu).sqrt();
    let wanted = [std::f64::consts::PI / omega, -(-std::f64::consts::PI * mu / omega).exp()];
    for (with, tolerance) in [("integrate", 1e-11), ("table", 1e-3)] {
        let output =
            carom(&["collide", file, "--end", "overlap", "--with", with, "--table", "compact"]);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let rows = rows(&output.stdout);
        for (column, wanted) in ["tau", "eps_rdot"].into_iter().zip(wanted) {
            let off = number(&rows[0], column) / wanted - 1.0;
            assert!(off.abs() < tolerance, "{with} {column}: {off}");
        }
        assert_eq!(number(&rows[0], "one_minus_eps_r"), 0.0);
    }
}
