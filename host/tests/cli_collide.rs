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
fn integrated_answers_are_within_1e_9_of_the_reference() {
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
