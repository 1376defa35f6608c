//! Does `carom collide --with forces` show the engine's and the reference's answer, and do they agree? Runs the program; writes temporary files.

use std::collections::HashMap;
use std::process::{Command, Output};

const HEAD: &str = "id,law,k,gamma,Y,nu,A,R1,R2,m1,m2,v,e,w1,w2,restitution,exponent,damping_exponent,unloading,work,cohesion";

/// One row of each law, at this speed and eccentricity.
fn cases(speed: f64, eccentricity: f64) -> String {
    let meet = format!("0.1,0.07,1,0.5,{speed},{eccentricity},3,-2");
    [
        HEAD.to_owned(),
        format!("lsd,lsd,1e6,20,,,,{meet},,,,,,"),
        format!("viscoelastic,viscoelastic,,,1e9,0.3,1e-6,{meet},,,,,,"),
        format!("constant,constant,,,,,,{meet},0.8,,,,,"),
        format!("power,power,1e8,1e4,,,,{meet},,1.75,0.6,,,"),
        format!("hysteretic,walton-braun,1e6,,,,,{meet},,,,4e6,,0.5"),
        format!("dmt,dmt,,,1e9,0.3,1e-6,{meet},,,,,1,0"),
        format!("jkr,jkr,,,1e9,0.3,1e-6,{meet},,,,,1,0.1"),
    ]
    .join("\n")
}

fn run(text: &str, flags: &[&str]) -> Output {
    let folder = tempfile::tempdir().expect("a temporary directory");
    let file = folder.path().join("cases.csv");
    std::fs::write(&file, text).expect("a file");
    Command::new(env!("CARGO_BIN_EXE_carom"))
        .arg("collide")
        .arg(file)
        .args(flags)
        .output()
        .expect("carom starts")
}

fn answered(text: &str, flags: &[&str]) -> Vec<HashMap<String, String>> {
    let output = run(text, &[&["--with", "forces"], flags].concat());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let mut reader = csv::Reader::from_reader(output.stdout.as_slice());
    reader.deserialize().map(|row| row.expect("a CSV row")).collect()
}

fn number(row: &HashMap<String, String>, column: &str) -> f64 {
    row[column].parse().unwrap_or_else(|_| panic!("{column} of {}: {:?}", row["id"], row[column]))
}

const SPRING: [&str; 6] = ["--friction", "spring", "--mu", "0.3", "--stiffness", "3e5"];

#[test]
fn the_engine_and_the_reference_agree() {
    let damped = [&SPRING[..], &["--damping", "20"]].concat();
    // Smooth pairs of the first two laws are read from tables, of 1e-6.
    for (flags, most) in [(&[][..], 2e-5), (&SPRING, 2e-4), (&damped, 5e-3)] {
        for eccentricity in [0.0, 0.5, 0.9] {
            for row in answered(&cases(1.0, eccentricity), flags) {
                assert_eq!((row["engine"].as_str(), row["reference"].as_str()), ("parts", "parts"));
                let off = number(&row, "difference");
                assert!(off < most, "{flags:?} {eccentricity} {}: {off:e}", row["id"]);
                let late = number(&row, "apart_engine") / number(&row, "apart_reference") - 1.0;
                assert!(row["id"] == "constant" || late.abs() < 0.02, "{}: {late}", row["id"]);
            }
        }
    }
}

/// Where a force has an edge, as at the touch of some, by less than the square.
#[test]
fn more_steps_come_nearer() {
    let [few, many] = ["128", "1024"].map(|steps| {
        let flags = [&SPRING[..], &["--steps", steps]].concat();
        answered(&cases(1.0, 0.5), &flags)
    });
    for (few, many) in few.iter().zip(&many).filter(|(row, _)| row["id"] != "constant") {
        let [few, off] = [few, many].map(|row| number(row, "difference"));
        assert!(off < few / 4.0, "{}: {few:e} {off:e}", many["id"]);
    }
}

#[test]
fn coefficients_across_are_those_of_hard_spheres() {
    for (flags, beta) in [
        (["--friction", "constant", "--beta", "0.5"].as_slice(), 0.5),
        (&["--friction", "walton", "--mu", "2", "--beta-0", "0.4"], 0.4),
    ] {
        let rows = answered(&cases(1.0, 0.5), flags);
        let row = rows.iter().find(|row| row["id"] == "constant").expect("the row");
        assert!(number(row, "difference") < 1e-14);
        assert!((number(row, "vn_engine") - 0.8 * 0.75_f64.sqrt()).abs() < 1e-14);
        let [vt, a, b] = ["vt_engine", "w1_engine", "w2_engine"].map(|name| number(row, name));
        let (before, after) = (0.5 - (0.1 * 3.0 - 0.07 * 2.0), vt - (0.1 * a + 0.07 * b));
        assert!((after + beta * before).abs() < 1e-14, "{before} {after}");
        // What the engine's spring comes to there, only it knows.
        assert!(rows.iter().all(|row| row["id"] == "constant" || row["reference"] == "unknown"));
    }
}

#[test]
fn what_is_too_slow_sticks_by_both() {
    for row in answered(&cases(1e-4, 0.1), &[]) {
        let holds = ["hysteretic", "jkr"].contains(&row["id"].as_str());
        let wanted = if holds { "sticks" } else { "parts" };
        let found = (row["engine"].as_str(), row["reference"].as_str());
        assert!(row["id"] == "dmt" || found == (wanted, wanted), "{}: {found:?}", row["id"]);
        assert_eq!(found.0, found.1, "{}", row["id"]);
    }
}

/// What is wrong is said in one line, by name, and the status is not 0.
#[test]
fn bad_flags_and_rows_are_refused() {
    let all = cases(1.0, 0.5);
    let forces = ["--with", "forces"];
    let refused = |text: &str, flags: &[&str], name: &str| {
        let output = run(text, flags);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(!output.status.success() && said.contains(name), "{flags:?}: {said}");
        said
    };
    for (flags, name) in [
        (["--friction", "walton", "--mu", "-1"].as_slice(), "mu is -1, must be between 0 and 16"),
        (&["--friction", "walton", "--mu", "0.1", "--beta-0", "2"], "beta_0 is 2"),
        (&["--friction", "constant", "--beta", "-1.5"], "beta is -1.5"),
        (&["--friction", "spring", "--mu", "1", "--stiffness", "0"], "stiffness is 0"),
        (&["--friction", "walton"], "missing field `mu`"),
        (&["--friction", "walton", "--mu", "1", "--beta", "0"], "unknown field `beta`"),
        (&["--friction", "wax"], "wax"),
        (&["--mu", "0.3"], "--mu is for --friction"),
        (&["--friction", "constant", "--beta", "0", "--inertia", "2"], "inertia is 2"),
        (&["--steps", "1"], "--steps 1"),
    ] {
        let said = refused(&all, &[&forces, flags].concat(), name);
        assert_eq!(said.trim().lines().count(), 1, "{said}");
    }
    refused(&all, &["--friction", "walton", "--mu", "0.3"], "--friction is for --with forces");
    refused(&all, &[], "it has no table: --with forces");
    let meet = "0.1,0.07,1,0.5,1,0.5,3,-2";
    for (row, name) in [
        (format!("a,walton-braun,4e6,,,,,{meet},,,,1e6,,"), "column `unloading`: `1000000`"),
        (format!("a,power,1e6,0,,,,{meet},,0.5,0,,,"), "column `exponent`: `0.5`"),
        (format!("a,lsd,1e6,0,,,,{meet},,,,,,3"), "column `cohesion`: `3`"),
        (format!("a,jkr,,,1e9,0.7,0,{meet},,,,,1,"), "column `nu`: `0.7`"),
        (format!("a,jkr,,,1e9,0.3,0,{meet},,,,,-1,"), "column `work`: `-1`"),
        (format!("a,constant,,,,,,{meet},1.5,,,,,"), "column `restitution`: `1.5`"),
        (format!("a,wax,,,,,,{meet},,,,,,"), "column `law`: `wax`"),
    ] {
        let said = refused(&format!("{HEAD}\n{row}"), &forces, name);
        assert!(said.contains("row 1 (line 2)"), "{said}");
    }
}
