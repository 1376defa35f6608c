//! Does a run leave its files whole, together and where they belong, whatever goes wrong? Runs `carom`; writes into temporary directories.
#![cfg(unix)]

use std::fs::{self, File};
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::{Duration, SystemTime};
use tempfile::TempDir;

/// Two soft grains that meet, and a third that passes by.
const PAIR: &str = r#"
dimension = 2
duration = 0.4
sample = 0.02
methods = ["md", "emd*"]
[law]
kind = "lsd"
stiffness = 1.0e6
damping = 0.0
[[grain]]
radius = 0.1
mass = 1.0
at = [0.0, 0.0]
moving = [1.0, 0.0]
[[grain]]
radius = 0.1
mass = 1.0
at = [0.5, 0.0]
"#;

fn carom(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_carom"));
    command.args(arguments).output().expect("carom starts")
}

/// A folder with a scenario in it.
fn folder(scenario: &str) -> (TempDir, String, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("scenario.toml");
    fs::write(&file, scenario).unwrap();
    let (file, out) = (file.to_str().unwrap().to_owned(), folder.path().join("out"));
    (folder, file, out)
}

fn run(scenario: &str, out: &Path) -> Output {
    carom(&["run", scenario, "--out", out.to_str().unwrap()])
}

/// The one line of a run that failed.
fn refusal(output: &Output) -> String {
    assert!(!output.status.success());
    let error = String::from_utf8(output.stderr.clone()).unwrap();
    assert_eq!(error.lines().count(), 1, "not one line: {error}");
    error
}

/// The names in a folder.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn samples_without_end_are_refused() {
    let (_folder, file, out) = folder(&PAIR.replace("sample = 0.02", "sample = 1e-300"));
    let error = refusal(&run(&file, &out));
    assert!(error.contains("sample is 1e-300, must be at least 4e-8"), "{error}");
    assert!(!out.exists());
}

/// No duration to compare with: time stands still until it is noticed.
#[test]
fn a_run_that_waits_for_collisions_in_vain_ends() {
    let text = PAIR.replace("duration = 0.4", "collisions = 3").replace("\"md\", ", "");
    let (_folder, file, out) = folder(&text.replace("0.02", "1e-300"));
    let error = refusal(&run(&file, &out));
    assert!(error.contains("no collision in the last 100000 samples"), "{error}");
}

/// The second method breaks off at the collision; what it wrote until then is kept, and is not taken for
/// a whole result.
#[test]
fn a_fault_loses_nothing_and_mixes_nothing() {
    let (_folder, file, out) = folder(PAIR);
    assert!(run(&file, &out).status.success());
    let whole = names(&out);
    assert_eq!(whole, ["emd-star.csv", "emd-star.xyz", "md.csv", "md.xyz", "summary.json"]);
    let before: Vec<Vec<u8>> = whole.iter().map(|name| fs::read(out.join(name)).unwrap()).collect();
    let soft =
        PAIR.replace("1.0e6", "1.0e2").replace("[law]", "[options]\noutside = \"reject\"\n[law]");
    fs::write(&file, soft).unwrap();
    let error = refusal(&run(&file, &out));
    assert!(
        error.contains("outside the table's domain") && error.contains("unfinished"),
        "{error}"
    );
    for (name, before) in whole.iter().zip(&before) {
        assert_eq!(&fs::read(out.join(name)).unwrap(), before, "{name} of the older run");
    }
    let left = out.join("unfinished");
    let rows = |name: &str| fs::read_to_string(left.join(name)).unwrap().lines().count();
    assert_eq!(rows("md.csv"), 1 + 21);
    // They touch at t = 0.3: 15 samples before.
    assert_eq!(rows("emd-star.csv"), 1 + 15);
    assert_eq!(fs::read_to_string(left.join("emd-star.xyz")).unwrap().lines().count(), 4 * 15);
    let summary: serde_json::Value =
        serde_json::from_slice(&fs::read(left.join("summary.json")).unwrap()).unwrap();
    assert!(summary["broken_off"].as_str().unwrap().contains("outside the table's domain"));
    assert_eq!(summary["runs"].as_array().unwrap().len(), 2);
    assert!((summary["runs"][1]["time"].as_f64().unwrap() - 0.28).abs() < 1e-12);
    // The next run that is whole leaves nothing of it.
    fs::write(&file, PAIR).unwrap();
    assert!(run(&file, &out).status.success());
    assert_eq!(names(&out), whole);
}

/// Nothing is written before all methods have accepted the scenario.
#[test]
fn a_method_that_refuses_leaves_an_older_run_alone() {
    let (_folder, file, out) = folder(PAIR);
    assert!(run(&file, &out).status.success());
    let before = fs::read(out.join("md.csv")).unwrap();
    // Two on one another: forces say what happens, event-driven methods refuse.
    fs::write(&file, PAIR.replace("0.5, 0.0", "0.0, 0.0")).unwrap();
    refusal(&run(&file, &out));
    assert_eq!(fs::read(out.join("md.csv")).unwrap(), before);
    assert!(!out.join("unfinished").exists());
}

/// A file-size limit stands for a full disk.
#[test]
fn a_full_disk_names_the_file() {
    let (_folder, file, out) = folder(&PAIR.replace("0.02", "0.00002"));
    let script = "trap '' XFSZ; ulimit -f 64; exec \"$0\" run \"$1\" --out \"$2\"";
    let mut shell = Command::new("sh");
    let shell = shell.args(["-c", script, env!("CARGO_BIN_EXE_carom"), &file]).arg(&out);
    let error = refusal(&shell.output().unwrap());
    assert!(error.contains("cannot write") && error.contains("md.xyz"), "{error}");
}

#[test]
fn a_symbolic_link_stays_one() {
    let (folder, file, out) = folder(PAIR);
    let elsewhere = folder.path().join("elsewhere");
    fs::create_dir_all(&out).unwrap();
    fs::create_dir_all(&elsewhere).unwrap();
    // One leads to a file, one to nothing yet.
    fs::write(elsewhere.join("rows.csv"), "old").unwrap();
    symlink("../elsewhere/rows.csv", out.join("md.csv")).unwrap();
    symlink("../elsewhere/summary.json", out.join("summary.json")).unwrap();
    assert!(run(&file, &out).status.success());
    for (link, target) in [("md.csv", "rows.csv"), ("summary.json", "summary.json")] {
        assert!(out.join(link).is_symlink(), "{link} is no link any more");
        assert!(fs::metadata(elsewhere.join(target)).unwrap().len() > 100);
    }
    let picture = folder.path().join("picture.svg");
    symlink("elsewhere/real.svg", &picture).unwrap();
    let drawn = carom(&["table", "--figure", "3", "--plot", picture.to_str().unwrap()]);
    assert!(drawn.status.success(), "{}", String::from_utf8_lossy(&drawn.stderr));
    assert!(picture.is_symlink() && elsewhere.join("real.svg").is_file());
    let round = folder.path().join("round.svg");
    symlink("round.svg", &round).unwrap();
    let error = refusal(&carom(&["table", "--figure", "3", "--plot", round.to_str().unwrap()]));
    assert!(error.contains("round.svg") && error.contains("circle"), "{error}");
}

/// What a killed program left goes with the next one that writes there; what somebody is at stays.
#[test]
fn drafts_of_killed_programs_are_cleared() {
    let folder = tempfile::tempdir().unwrap();
    let hour = SystemTime::now() - Duration::from_secs(3600);
    let draft = |name: &str| {
        let file = File::create(folder.path().join(name)).unwrap();
        file.set_modified(hour).unwrap();
        file
    };
    drop(draft(".carom-killed.part"));
    let busy = draft(".carom-busy.part");
    busy.lock().unwrap();
    drop(draft("mine.part"));
    File::create(folder.path().join(".carom-young.part")).unwrap();
    let picture = folder.path().join("picture.svg");
    carom(&["table", "--figure", "3", "--plot", picture.to_str().unwrap()]);
    let wanted = [".carom-busy.part", ".carom-young.part", "mine.part", "picture.svg"];
    assert_eq!(names(folder.path()), wanted);
}

/// Two programs never write into one folder.
#[test]
fn a_folder_is_for_one_run_at_a_time() {
    let (_folder, file, out) = folder(PAIR);
    let left = out.join("unfinished");
    fs::create_dir_all(&left).unwrap();
    let lock = File::create(left.join("lock")).unwrap();
    lock.lock().unwrap();
    let error = refusal(&run(&file, &out));
    assert!(error.contains("another process is at this run"), "{error}");
}
