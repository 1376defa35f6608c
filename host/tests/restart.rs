//! Does a run that was stopped go on to the same bits? Kills and interrupts `carom run`; writes into temporary directories.
#![cfg(unix)]

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use std::collections::BTreeMap;
use std::fs;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::Duration;
use tempfile::TempDir;

/// Grains that fall onto a vibrating plate: collisions, contacts that last, clusters, and an event log.
const SHAKEN: &str = r#"
title = "shaken"
dimension = 2
gravity = [0.0, -9.81]
duration = 0.15
sample = 0.05
methods = ["emd", "emd*"]
[box]
x = { kind = "periodic", from = 0.0, to = 0.06 }
y = { kind = "plate", at = 0.0, amplitude = 1e-3, frequency = 30.0, surface = "soft" }
[law]
kind = "viscoelastic"
young = 1.0e7
poisson = 0.4
dissipation = 1.0e-4
[options]
events = true
[observe]
from = 0.01
every = 0.003
"#;

fn shaken() -> String {
    let mut text = SHAKEN.to_owned();
    for k in 0..24 {
        let (x, y) = (0.01 * f64::from(k % 6) + 0.005, 0.004 + 0.011 * f64::from(k / 6));
        let speed = 0.1 * f64::from(k % 5) - 0.2;
        text += &format!(
            "[[grain]]\nradius = 0.004\ndensity = 1100.0\nat = [{x}, {y}]\nmoving = [{speed}, 0.0]\n"
        );
    }
    text
}

struct Case {
    _folder: TempDir,
    scenario: PathBuf,
    out: PathBuf,
}

impl Case {
    fn new(text: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let (scenario, out) = (folder.path().join("scenario.toml"), folder.path().join("out"));
        fs::write(&scenario, text).unwrap();
        Self { _folder: folder, scenario, out }
    }

    fn command(&self, more: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_carom"));
        command.arg("run").arg(&self.scenario).arg("--out").arg(&self.out).args(more);
        command
    }

    fn run(&self, more: &[&str]) -> Output {
        self.command(more).output().unwrap()
    }

    fn start(&self, more: &[&str]) -> Child {
        let mut command = self.command(more);
        command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap()
    }

    fn checkpoint(&self) -> PathBuf {
        self.out.join("unfinished/checkpoint")
    }
}

/// All files of a folder, without how long computing took.
fn results(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = fs::read_dir(folder).unwrap().map(Result::unwrap);
    let mut files: BTreeMap<String, Vec<u8>> = entries
        .map(|entry| {
            (entry.file_name().into_string().unwrap(), fs::read(entry.path()).unwrap_or_default())
        })
        .collect();
    let summary = String::from_utf8(files.remove("summary.json").unwrap()).unwrap();
    let lines = summary.lines().filter(|line| !line.contains("wall_seconds"));
    let lines = lines.map(|line| line.rsplit('/').next().unwrap_or(line));
    files.insert("summary.json".to_owned(), lines.collect::<Vec<_>>().join("\n").into_bytes());
    files
}

fn uninterrupted(text: &str) -> BTreeMap<String, Vec<u8>> {
    let case = Case::new(text);
    let output = case.run(&[]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    results(&case.out)
}

fn assert_same(case: &Case, wanted: &BTreeMap<String, Vec<u8>>) {
    let found = results(&case.out);
    assert_eq!(found.keys().collect::<Vec<_>>(), wanted.keys().collect::<Vec<_>>());
    for (name, bytes) in wanted {
        assert!(found[name] == *bytes, "{name} differs");
    }
}

/// Which file the checkpoint is now: each is a new one.
fn inode(case: &Case) -> Option<u64> {
    fs::metadata(case.checkpoint()).ok().map(|data| data.ino())
}

/// Killed again and again until it is through: after so many checkpoints and so much time as are drawn.
fn kill_until_done(case: &Case, seed: u64) -> usize {
    let mut rng = Pcg64::seed_from_u64(seed);
    let mut kills = 0;
    loop {
        let mut child = case.start(&["--restart", "--checkpoint", "0"]);
        let (mut left, mut known) = (rng.random_range(1..4), inode(case));
        while left > 0 && child.try_wait().unwrap().is_none() {
            let now = inode(case);
            left -= i32::from(now != known);
            known = now;
        }
        std::thread::sleep(Duration::from_micros(rng.random_range(0..5_000)));
        if let Some(status) = child.try_wait().unwrap() {
            assert!(status.success());
            return kills;
        }
        child.kill().unwrap();
        child.wait().unwrap();
        kills += 1;
    }
}

#[test]
fn a_run_killed_at_any_instant_continues_to_the_same_bits() {
    let text = shaken();
    let wanted = uninterrupted(&text);
    assert!(wanted.contains_key("emd-star-events.csv"));
    assert!(wanted["emd-blocks.csv"].iter().filter(|&&byte| byte == b'\n').count() > 40);
    let mut kills = 0;
    for seed in 1..=2 {
        let case = Case::new(&text);
        kills += kill_until_done(&case, seed);
        assert_same(&case, &wanted);
    }
    assert!(kills > 0, "it was never killed");
}

/// Runs by forces, too, between two of their steps.
#[test]
fn so_does_one_by_forces() {
    let text = shaken()
        .replace("[\"emd\", \"emd*\"]", "[\"md\", \"md-exact\"]")
        .replace("events = true", "")
        .replace("duration = 0.15", "duration = 0.06")
        .replace("sample = 0.05", "sample = 0.03");
    let wanted = uninterrupted(&text);
    assert!(String::from_utf8_lossy(&wanted["md-averages.csv"]).contains("pressure"));
    let case = Case::new(&text);
    assert!(kill_until_done(&case, 3) > 3);
    assert_same(&case, &wanted);
}

/// Interrupted as soon as there is a checkpoint; the second time it goes on, the third there is nothing to do.
#[test]
fn an_interrupt_leaves_a_checkpoint() {
    let text = shaken().replace("duration = 0.15", "duration = 60.0");
    for signal in ["INT", "TERM"] {
        let case = Case::new(&text);
        let child = case.start(&["--checkpoint", "0"]);
        while !case.checkpoint().exists() {
            std::thread::sleep(Duration::from_millis(2));
        }
        let id = child.id().to_string();
        Command::new("kill").args(["-s", signal, &id]).status().unwrap();
        let output = child.wait_with_output().unwrap();
        let error = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(130), "{error}");
        assert!(error.contains("stopped at t = ") && error.contains("--restart"), "{error}");
        assert_eq!(error.lines().count(), 1, "{error}");
        assert!(case.checkpoint().exists());
    }
}

#[test]
fn a_whole_run_is_not_done_again() {
    let case = Case::new(&shaken());
    assert!(case.run(&[]).status.success());
    let wanted = results(&case.out);
    let file = case.out.join("emd.csv");
    let written = fs::metadata(&file).unwrap().modified().unwrap();
    let output = case.run(&["--restart"]);
    assert!(output.status.success());
    assert_eq!(fs::metadata(&file).unwrap().modified().unwrap(), written);
    assert_same(&case, &wanted);
}

/// Another scenario, another version, other methods, a damaged file: one line each, and the checkpoint stays.
#[test]
fn a_restart_of_something_else_is_refused() {
    let text = shaken();
    let case = Case::new(&text);
    let mut child = case.start(&["--checkpoint", "0"]);
    while !case.checkpoint().exists() {
        std::thread::sleep(Duration::from_millis(1));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    let good = fs::read(case.checkpoint()).unwrap();
    let refusal = |more: &[&str]| {
        let output = case.run(&[&["--restart"], more].concat());
        let error = String::from_utf8(output.stderr).unwrap();
        assert!(!output.status.success() && error.lines().count() == 1, "{error}");
        error
    };
    assert!(refusal(&["--method", "emd"]).contains("of another scenario (or other methods)"));
    fs::write(&case.scenario, text.replace("9.81", "9.80")).unwrap();
    assert!(refusal(&[]).contains("of another scenario (or other methods)"));
    fs::write(&case.scenario, &text).unwrap();
    // The version stands in plain text; a checksum of it before it.
    let version = env!("CARGO_PKG_VERSION").as_bytes();
    let at = good.windows(version.len()).position(|part| part == version).unwrap();
    let mut damaged = good.clone();
    damaged[at] = b'9';
    fs::write(case.checkpoint(), &damaged).unwrap();
    assert!(refusal(&[]).contains("damaged"));
    for (bytes, wanted) in [(&good[..good.len() / 2], "damaged"), (b"", "not a checkpoint")] {
        fs::write(case.checkpoint(), bytes).unwrap();
        assert!(refusal(&[]).contains(wanted));
    }
    let mut other = good.clone();
    other[at] = b'9';
    let length = u64::from_le_bytes(good[19..27].try_into().unwrap()) as usize;
    let checksum = crc32fast::hash(&other[31..31 + length]);
    other[27..31].copy_from_slice(&checksum.to_le_bytes());
    fs::write(case.checkpoint(), &other).unwrap();
    let error = refusal(&[]);
    assert!(error.contains("written by carom 9") && error.contains("this is 0"), "{error}");
    // None of this has touched what there is.
    fs::write(case.checkpoint(), &good).unwrap();
    assert!(case.run(&["--restart"]).status.success());
    assert_same(&case, &uninterrupted(&text));
}
