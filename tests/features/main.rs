//! Do cargo features only add? Builds two small crates alone and in one workspace, and carom with each feature and without it;
//! compares what they print.

use std::fs;
use std::path::Path;
use std::process::Command;

/// With the compact tables alone.
const ONE: &str = r#"
use carom::law::embedded::{Compact, compact, read::Table};
use carom::law::{Outside, Soft, Viscoelastic};
use carom::{Grain, Memory, World};

fn main() -> Result<(), carom::Error> {
    let table: &Table<f32> = &compact::VISCOELASTIC;
    let law = Viscoelastic { young: 5.0e6, poisson: 0.4, dissipation: 1.0e-4 };
    let mut memory = Memory::<f64, 2, 4>::new();
    let mut world = World::builder(&mut memory)
        .walls([[0.0, 0.02]; 2])
        .rule(Soft::embedded(law, Compact, Outside::HardSphere))
        .grains((0..4).map(|i| {
            let x = 0.004 * f64::from(i + 1);
            Grain::sphere(1.0e-3, 2500.0).at([x, 0.005]).moving([0.7 - 40.0 * x, 0.5])
        }))?
        .start()?;
    world.advance_to(0.2)?;
    println!("{:016x} {:e}", world.digest(), table.certificate.largest.tau);
    Ok(())
}
"#;

/// With the default rule and everything else.
const OTHER: &str = r#"
use carom::law::embedded::{standard, read::Table};
use carom::law::{LinearDashpot, Outside, Soft};
use carom::scalar::{I32F32, Real};
use carom::{Grain, HeapMemory, World};

fn main() -> Result<(), carom::Error> {
    let table: &Table<f64> = &standard::VISCOELASTIC_F64;
    let n = I32F32::from_f64;
    let law = LinearDashpot { stiffness: n(1.0e3), damping: n(0.5) };
    let mut memory = HeapMemory::<I32F32, 2>::with_capacity(4);
    let mut world = World::builder(&mut memory)
        .walls([[n(0.0), n(20.0)]; 2])
        .rule(Soft::linear_dashpot(law, Outside::HardSphere))
        .grains((0..4).map(|i| {
            let x = 4.0 * f64::from(i + 1);
            Grain::with_mass(n(1.0), n(1.0)).at([n(x), n(5.0)]).moving([n(1.0 - 0.1 * x), n(0.5)])
        }))?
        .start()?;
    world.advance_to(n(200.0))?;
    println!("{:016x} {:e}", world.digest(), table.certificate.largest.tau);
    Ok(())
}
"#;

fn write_crate(workspace: &Path, name: &str, features: &str, main: &str) {
    let carom = env!("CARGO_MANIFEST_DIR");
    let folder = workspace.join(name);
    fs::create_dir_all(folder.join("src")).unwrap();
    let manifest = format!(
        "[package]\nname = \"{name}\"\nversion = \"0.1.0\"\nedition = \"2024\"\n\
         [dependencies]\ncarom = {{ path = {carom:?}, default-features = false, features = [{features}] }}\n"
    );
    fs::write(folder.join("Cargo.toml"), manifest).unwrap();
    fs::write(folder.join("src/main.rs"), main).unwrap();
}

/// What cargo, called so in the workspace, prints.
fn cargo(workspace: &Path, arguments: &[&str]) -> String {
    let done = Command::new(env!("CARGO"))
        .current_dir(workspace)
        .env("CARGO_TARGET_DIR", workspace.join("target"))
        .env_remove("RUSTC_WORKSPACE_WRAPPER")
        .args(arguments)
        .output()
        .unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    String::from_utf8(done.stdout).unwrap()
}

#[test]
#[ignore = "builds carom three times"]
fn a_feature_switched_on_elsewhere_changes_nothing() {
    let workspace = Path::new(env!("CARGO_TARGET_TMPDIR")).join("features");
    write_crate(&workspace, "one", "\"compact\"", ONE);
    let all =
        "\"alloc\", \"standard\", \"plates\", \"f64-tables\", \"fixed\", \"serde\", \"micromath\"";
    write_crate(&workspace, "other", all, OTHER);
    let manifest = "[workspace]\nmembers = [\"one\", \"other\"]\nresolver = \"3\"\n\
                    [profile.dev.package.carom-tables]\nopt-level = 3\n";
    fs::write(workspace.join("Cargo.toml"), manifest).unwrap();
    fs::copy(concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.lock"), workspace.join("Cargo.lock"))
        .unwrap();

    let alone = ["one", "other"].map(|name| cargo(&workspace, &["run", "--quiet", "-p", name]));
    cargo(&workspace, &["build", "--quiet", "--workspace"]);
    let together = ["one", "other"].map(|name| {
        let program = workspace.join("target/debug").join(name);
        let done = Command::new(program).output().unwrap();
        String::from_utf8(done.stdout).unwrap()
    });
    assert_eq!(alone, together);
    assert!(alone[0].len() > 20 && alone[0] != alone[1]);
}

/// Tables that take a build script long.
const LARGE: [&str; 2] = ["wide", "fine"];
const FEATURES: [&str; 11] = [
    "standard",
    "compact",
    "f64-tables",
    "plates",
    "shear",
    "obstacles",
    "alloc",
    "fixed",
    "micromath",
    "serde",
    "defmt",
];

/// Six sets of features. Each feature is left out of two of them, no two features of the same two: so of any two features
/// there is a set with the one and without the other, whichever they are, and one with both.
fn sets() -> [Vec<&'static str>; 6] {
    let pairs = (0..6).flat_map(|a| (0..a).map(move |b| [a, b]));
    let left_out: Vec<(&str, [usize; 2])> = FEATURES.into_iter().zip(pairs).collect();
    assert_eq!(left_out.len(), FEATURES.len(), "fifteen features at most: then seven sets");
    std::array::from_fn(|set| {
        let has = |(_, without): &&(&str, [usize; 2])| !without.contains(&set);
        left_out.iter().filter(has).map(|(feature, _)| *feature).collect()
    })
}

#[test]
fn of_any_two_features_a_set_has_one_and_not_the_other() {
    let sets = sets();
    for (a, b) in FEATURES.iter().flat_map(|a| FEATURES.iter().map(move |b| (a, b))) {
        let has = |set: &Vec<&str>, one: &str| set.contains(&one);
        assert!(sets.iter().any(|set| has(set, a) && has(set, b)), "{a} and {b}");
        assert!(a == b || sets.iter().any(|set| has(set, a) && !has(set, b)), "{a} without {b}");
    }
}

/// No combination is forbidden: carom compiles without features, with each alone, with all, and with each of any two without
/// the other (the large tables, which are made as the others, alone).
#[test]
#[ignore = "checks carom two dozen times"]
fn every_feature_compiles_with_and_without_each_other() {
    let mut sets = sets().map(|set| set.join(",")).to_vec();
    sets.extend([String::new(), [&LARGE[..], &FEATURES].concat().join(",")]);
    sets.extend(LARGE.into_iter().chain(FEATURES).map(String::from));
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("features");
    fs::create_dir_all(&folder).unwrap();
    let manifest = concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml");
    for features in sets {
        let arguments = ["check", "--quiet", "--lib", "--no-default-features", "--features"];
        let more = [&features[..], "--manifest-path", manifest, "--package", "carom"];
        cargo(&folder, &[&arguments[..], &more[..]].concat());
    }
}

/// A feature that is not in the list above is not tried.
#[test]
fn all_features_are_known_here() {
    let manifest = fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml")).unwrap();
    let features = manifest.split("\n[").find(|table| table.starts_with("features]")).unwrap();
    let names = features.lines().filter_map(|line| Some(line.split_once(" = ")?.0.trim()));
    let mut known = [&["default"], &LARGE[..], &FEATURES].concat();
    let mut there: Vec<&str> = names.filter(|name| !name.starts_with('#')).collect();
    known.sort_unstable();
    there.sort_unstable();
    assert_eq!(known, there);
}
