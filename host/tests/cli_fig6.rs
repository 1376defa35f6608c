//! Does `carom run` give MP13's Fig. 6? Reads tests/data/fig6-path.json; writes into a temporary directory.
//!
//! Müller and Pöschel, Phys. Rev. E 87, 033301 (2013): the paths of two soft grains. The data were
//! integrated outside of this project.

use serde_json::Value;
use std::path::Path;
use std::process::Command;

/// Distance of the centres at contact [m].
const L: f64 = 0.2;
/// Sample of dot 0 and of dot 7, the end of the contact.
const BEGIN: usize = 4;
const END: usize = BEGIN + 7;

/// One grain of one frame: position and velocity.
type State = [f64; 6];

fn frames(file: &Path) -> Vec<[State; 2]> {
    let text = std::fs::read_to_string(file).expect("a trajectory");
    let lines: Vec<&str> = text.lines().collect();
    let state = |line: &str| -> State {
        let numbers: Vec<f64> =
            line.split_whitespace().skip(1).map(|x| x.parse().expect("a number")).collect();
        std::array::from_fn(|k| numbers[k])
    };
    lines.chunks(4).map(|frame| [state(frame[2]), state(frame[3])]).collect()
}

fn run(method: &str) -> Vec<[State; 2]> {
    let folder = tempfile::tempdir().expect("a temporary directory");
    let scenario = concat!(env!("CARGO_MANIFEST_DIR"), "/scenarios/fig6.toml");
    let output = Command::new(env!("CARGO_BIN_EXE_carom"))
        .args(["run", scenario, "--method", method, "--out"])
        .arg(folder.path())
        .output()
        .expect("carom starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let stem = if method == "emd*" { "emd-star" } else { method };
    frames(&folder.path().join(format!("{stem}.xyz")))
}

fn reference() -> Value {
    let text = include_str!("../../tests/data/fig6-path.json");
    let all: Value = serde_json::from_str(text).expect("JSON");
    all[0].clone()
}

fn vector(value: &Value) -> [f64; 3] {
    std::array::from_fn(|k| value[k].as_f64().expect("a number"))
}

/// Largest distance from the reference's MD path over the given dots, in units of l.
fn off(frames: &[[State; 2]], dots: std::ops::RangeInclusive<usize>) -> f64 {
    let reference = reference();
    let mut largest = 0.0f64;
    for dot in dots {
        for (grain, path) in ["md_x1", "md_x2"].into_iter().enumerate() {
            let wanted = vector(&reference[path][dot]);
            let got = frames[BEGIN + dot][grain];
            let square: f64 = (0..3).map(|k| (got[k] - wanted[k]).powi(2)).sum();
            largest = largest.max(square.sqrt());
        }
    }
    largest / L
}

#[test]
fn exact_md_follows_the_reference_path() {
    assert!(off(&run("md-exact"), 0..=14) < 1e-10);
}

#[test]
fn emd_star_is_back_on_the_path_when_the_contact_ends() {
    let frames = run("emd*");
    // The last instant of the contact itself may fall on either side of a rounding.
    assert!(off(&frames, 8..=14) < 1e-9);
    assert!(off(&frames, 1..=6) > 0.05, "during the contact the grains stand elsewhere");
    let end = END - BEGIN;
    assert!(off(&frames, end..=end) < 1e-9);
}

#[test]
fn emd_leaves_in_another_direction() {
    let (md, emd) = (run("md-exact"), run("emd"));
    let relative = |frames: &[[State; 2]]| -> [f64; 2] {
        let [a, b] = frames[frames.len() - 1];
        [a[3] - b[3], a[4] - b[4]]
    };
    let (a, b) = (relative(&md), relative(&emd));
    let cos = (a[0] * b[0] + a[1] * b[1]) / (a[0].hypot(a[1]) * b[0].hypot(b[1]));
    let wanted = reference()["angle_deg_md_vs_emd"].as_f64().expect("an angle");
    assert!((cos.acos().to_degrees() - wanted).abs() < 1e-9);
}
