//! Does a sweep give the same file however it is split, killed and taken up again? Runs small sweeps; writes to temporary folders.

use carom_host::scenario::Start;
use carom_host::sweep::{Cell, Plan, Rows, merge, sweep};
use serde_json::json;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};
use tempfile::TempDir;

const SCENARIO: &str = r#"
dimension = 2
duration = 0.2
sample = 0.05
methods = ["emd"]
[box]
x = { kind = "periodic" }
y = { kind = "periodic" }
[law]
kind = "viscoelastic"
young = 1.0e9
poisson = 0.4
dissipation = 4.0e-5
[gas]
count = 12
packing_fraction = 0.1
radius = 0.1
density = 1140.0
thermal_speed = 2.0
seed = 1
"#;

const SWEEP: &str = r#"
scenario = "gas.toml"
methods = ["emd", "emd*"]
seeds = { from = 1, count = 5 }
[grid]
gas.packing_fraction = [0.05, 0.2]
"#;

/// A folder with a scenario and a sweep.
fn folder(scenario: &str, sweep: &str) -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("gas.toml"), scenario).unwrap();
    let file = folder.path().join("sweep.toml");
    fs::write(&file, sweep).unwrap();
    (folder, file)
}

fn carom() -> Command {
    Command::new(env!("CARGO_BIN_EXE_carom"))
}

fn output_of(command: &mut Command) -> (bool, String) {
    let output = command.output().unwrap();
    let text = [output.stdout, output.stderr].concat();
    (output.status.success(), String::from_utf8(text).unwrap())
}

/// Seeds set every seed that a scenario draws from: that of a gas, and that of species and of what drives them.
#[test]
fn seeds_are_those_of_all_that_is_drawn() {
    const SPECIES: &str =
        "[[species]]\ncount = 5\nradius = 0.05\ndensity = 1140.0\ntemperature = 1.0\n";
    let energies = |scenario: &str, paths: &[&str]| {
        let (_folder, file) = folder(scenario, SWEEP);
        let plan = Plan::read(&file).unwrap();
        let names: Vec<String> = plan.columns().into_iter().map(|column| column.name).collect();
        assert_eq!(names[2..], *paths, "after the method and the grid's field");
        let place = |number: usize| {
            let run = plan.run(2 * number).unwrap();
            Start::new(&run.scenario).unwrap().grains.iter().map(|g| g.position).collect::<Vec<_>>()
        };
        (place(0), place(1), place(0))
    };
    let (gas, rest) = SCENARIO.split_once("[gas]").map(|(rest, gas)| (gas, rest)).unwrap();
    let sized = rest.replace("[box]", "[box]\npacking_fraction = 0.1");
    let alone = format!("{sized}{SPECIES}");
    let both = format!("{SCENARIO}{SPECIES}");
    assert!(gas.contains("seed"));
    for (scenario, paths) in [(SCENARIO, &["gas.seed"][..]), (&both, &["gas.seed", "seed"])] {
        let (one, two, again) = energies(scenario, paths);
        assert!(one != two && one == again, "{paths:?}");
    }
    let sweep = SWEEP.replace("gas.packing_fraction", "box.packing_fraction");
    let (_folder, file) = folder(&alone, &sweep);
    assert_eq!(Plan::read(&file).unwrap().columns()[2].name, "seed");
    let listed = format!("{sized}[[grain]]\nradius = 0.05\nmass = 1.0\nat = [0.5, 0.5]\n");
    let (_folder, file) = folder(&listed, &sweep);
    let refused = format!("{:#}", Plan::read(&file).unwrap_err());
    assert!(
        refused.ends_with(
            "seeds: the scenario draws nothing at random: it has no gas, species or drive"
        )
    );
}

/// The cell of a row under this name.
fn cell<'r>(rows: &'r Rows, row: usize, name: &str) -> &'r Cell {
    let place = rows.columns.iter().position(|column| column.name == name).unwrap();
    &rows.rows[row][place]
}

#[test]
fn every_combination_is_one_row_in_order() {
    let (_folder, file) = folder(SCENARIO, SWEEP);
    let plan = Plan::read(&file).unwrap();
    let out = file.with_extension("parquet");
    let report = sweep(&plan, [1, 1], &out).unwrap();
    assert_eq!((report.runs, report.fresh, report.failed), (20, 20, 0));
    let rows = Rows::read(&out).unwrap();
    for row in 0..20 {
        assert_eq!(cell(&rows, row, "run"), &Cell::Whole(row as i64));
        let method = ["emd", "emd-star"][row % 2];
        assert_eq!(cell(&rows, row, "method"), &Cell::Text(method.to_owned()));
        assert_eq!(cell(&rows, row, "gas.seed"), &Cell::Whole(1 + (row as i64 / 2) % 5));
        let packing = [0.05, 0.2][row / 10];
        assert_eq!(cell(&rows, row, "gas.packing_fraction"), &Cell::Number(packing));
        assert_eq!(cell(&rows, row, "time"), &Cell::Number(0.2));
    }
}

/// The row holds what `carom run` prints for the same scenario.
#[test]
fn a_row_equals_the_output_of_carom_run() {
    let (folder, file) = folder(SCENARIO, SWEEP);
    let plan = Plan::read(&file).unwrap();
    let out = file.with_extension("parquet");
    sweep(&plan, [1, 1], &out).unwrap();
    let rows = Rows::read(&out).unwrap();
    let text = SCENARIO.replace("seed = 1", "seed = 3").replace("= 0.1\nradius", "= 0.2\nradius");
    let scenario = folder.path().join("one.toml");
    fs::write(&scenario, text).unwrap();
    let mut run = carom();
    run.args(["run", "--json", "--method", "emd*", "--out"]).arg(folder.path().join("run"));
    let (success, output) = output_of(run.arg(&scenario));
    assert!(success, "{output}");
    let summary: serde_json::Value = serde_json::from_str(&output).unwrap();
    let run = &summary["runs"][0];
    // Packing 0.2 is the second of the grid, seed 3 the third of five, eMD* the second of two methods.
    let row = 10 + 2 * 2 + 1;
    let energy = run["kinetic_energy"].as_f64().unwrap();
    assert_eq!(cell(&rows, row, "kinetic_energy"), &Cell::Number(energy));
    let contacts = run["collisions"].as_i64().unwrap();
    assert!(contacts > 0);
    assert_eq!(cell(&rows, row, "contacts"), &Cell::Whole(contacts));
}

#[test]
fn shards_merge_to_the_same_bytes() {
    let (folder, file) = folder(SCENARIO, SWEEP);
    let plan = Plan::read(&file).unwrap();
    let whole = folder.path().join("whole.parquet");
    sweep(&plan, [1, 1], &whole).unwrap();
    for n in [1, 3, 20, 25] {
        let out = folder.path().join(format!("in-{n}.parquet"));
        // Backwards, to show that the order does not matter.
        let shards = (1..=n).rev().map(|i| sweep(&plan, [i, n], &out).unwrap().file);
        let shards: Vec<PathBuf> = shards.collect();
        let merged = folder.path().join(format!("merged-{n}.parquet"));
        merge(&shards).unwrap().write(&merged).unwrap();
        assert_eq!(fs::read(&merged).unwrap(), fs::read(&whole).unwrap(), "{n} shards");
    }
}

/// Means and errors stand in the rows, the same as `carom run` writes, and survive shards and journals.
#[test]
fn what_is_measured_is_in_the_rows() {
    let observed = format!("{SCENARIO}[observe]\nevery = 0.01\n");
    let (folder, file) = folder(&observed, SWEEP);
    let plan = Plan::read(&file).unwrap();
    let whole = folder.path().join("whole.parquet");
    sweep(&plan, [1, 1], &whole).unwrap();
    let out = folder.path().join("parts.parquet");
    let shards = [1, 2, 3].map(|i| sweep(&plan, [i, 3], &out).unwrap().file);
    let merged = folder.path().join("merged.parquet");
    merge(&shards).unwrap().write(&merged).unwrap();
    assert_eq!(fs::read(&merged).unwrap(), fs::read(&whole).unwrap());
    let scenario = folder.path().join("one.toml");
    fs::write(&scenario, observed.replace("packing_fraction = 0.1", "packing_fraction = 0.05"))
        .unwrap();
    let run = folder.path().join("run");
    let (success, output) =
        output_of(carom().args(["run", "--method", "emd", "--out"]).arg(&run).arg(&scenario));
    assert!(success, "{output}");
    let averages = fs::read_to_string(run.join("emd-averages.csv")).unwrap();
    let row = averages.lines().find(|line| line.starts_with("temperature,all,J,")).unwrap();
    let numbers: Vec<f64> = row.split(',').skip(3).map(|text| text.parse().unwrap()).collect();
    let rows = Rows::read(&whole).unwrap();
    assert_eq!(cell(&rows, 0, "observed.temperature [J]"), &Cell::Number(numbers[0]));
    assert_eq!(cell(&rows, 0, "observed.temperature error [J]"), &Cell::Number(numbers[1]));
}

#[test]
fn shards_that_are_missing_twice_there_or_foreign_are_refused() {
    let (folder, file) = folder(SCENARIO, SWEEP);
    let plan = Plan::read(&file).unwrap();
    let out = folder.path().join("out.parquet");
    let shards = [1, 2, 3].map(|i| sweep(&plan, [i, 3], &out).unwrap().file);
    let [one, two, three] = shards;
    let why = |files: &[&PathBuf]| {
        let files: Vec<PathBuf> = files.iter().map(|file| (*file).clone()).collect();
        merge(&files).unwrap_err().to_string()
    };
    assert_eq!(why(&[&one, &three]), "run 1 is missing; name all shards");
    assert_eq!(why(&[&one, &two]), "run 2 is missing; name all shards");
    assert_eq!(why(&[&one, &two, &two, &three]), "run 1 is there twice; name each shard once");
    let (_other, file) = self::folder(SCENARIO, &SWEEP.replace("count = 5", "count = 6"));
    let foreign = sweep(&Plan::read(&file).unwrap(), [3, 3], &file.with_extension("parquet"));
    let foreign = foreign.unwrap().file;
    assert!(why(&[&one, &two, &foreign]).contains("is of another sweep than"));
    assert!(why(&[&one, &file]).contains("sweep.toml"));
}

/// Runs the program until some runs are done, kills it, and so on until it is through.
fn kill_until_done(file: &Path, out: &Path) -> usize {
    let journal = out.with_extension("parquet.journal");
    let lines = || fs::read(&journal).map_or(0, |t| t.iter().filter(|&&b| b == b'\n').count());
    let mut kills = 0;
    loop {
        let before = lines();
        let mut child = carom();
        let child = child.args(["sweep", "--threads", "1"]).arg(file).arg("--out").arg(out);
        let mut child = child.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
        let begin = Instant::now();
        while lines() < before + 20 && child.try_wait().unwrap().is_none() {
            assert!(begin.elapsed() < Duration::from_secs(60), "no progress");
        }
        if child.try_wait().unwrap().is_some() {
            return kills;
        }
        child.kill().unwrap();
        child.wait().unwrap();
        kills += 1;
    }
}

#[test]
fn a_killed_sweep_goes_on_where_it_stopped() {
    let (folder, file) = folder(SCENARIO, &SWEEP.replace("count = 5", "count = 200"));
    let [whole, killed] = ["whole.parquet", "killed.parquet"].map(|name| folder.path().join(name));
    sweep(&Plan::read(&file).unwrap(), [1, 1], &whole).unwrap();
    assert!(kill_until_done(&file, &killed) >= 1, "it was never killed");
    assert_eq!(fs::read(&killed).unwrap(), fs::read(&whole).unwrap());
    assert!(!killed.with_added_extension("journal").exists());
}

/// A journal whose last line was cut short: what is whole is kept, the rest is done again.
#[test]
fn no_run_is_lost_or_done_twice() {
    let (folder, file) = folder(SCENARIO, SWEEP);
    let plan = Plan::read(&file).unwrap();
    let [whole, cut] = ["whole.parquet", "cut.parquet"].map(|name| folder.path().join(name));
    sweep(&plan, [1, 1], &whole).unwrap();
    let journal = cut.with_added_extension("journal");
    let text = a_journal(&plan, &Rows::read(&whole).unwrap());
    for length in [0, 1, 900, text.len() / 2, text.len() - 1, text.len()] {
        fs::write(&journal, &text[..length]).unwrap();
        let kept = text[..length].iter().filter(|&&byte| byte == b'\n').count().saturating_sub(1);
        let report = sweep(&plan, [1, 1], &cut).unwrap();
        assert_eq!((report.runs, report.fresh), (20, 20 - kept), "cut at {length}");
        assert_eq!(fs::read(&cut).unwrap(), fs::read(&whole).unwrap(), "cut at {length}");
        assert_eq!(sweep(&plan, [1, 1], &cut).unwrap().fresh, 0, "it was done already");
        fs::remove_file(&cut).unwrap();
    }
}

/// The journal that an interrupted sweep leaves: a line that says of what it is, then a line for each
/// run that was done, in the order in which several threads may have ended them.
fn a_journal(plan: &Plan, rows: &Rows) -> Vec<u8> {
    let place = |name: &str| rows.columns.iter().position(|column| column.name == name).unwrap();
    let result = place("grains")..=place("error");
    let line = |number: usize| {
        let row = &rows.rows[number];
        let named = rows.columns.iter().zip(row).filter(|(_, cell)| **cell != Cell::Nothing);
        let statistics: Vec<(&str, &Cell)> = named
            .filter_map(|(column, cell)| Some((column.name.strip_prefix("statistics.")?, cell)))
            .collect();
        json!({ "run": number, "cells": row[result.clone()], "statistics": statistics })
    };
    let head = json!({ "source": plan.source, "shard": [1, 1] });
    let lines = std::iter::once(head).chain((0..15).map(|k| line(7 * k % 20)));
    lines.flat_map(|line| format!("{line}\n").into_bytes()).collect()
}

#[test]
fn a_run_that_fails_is_a_row_that_says_why() {
    let scenario = SCENARIO.replace("[law]", "[options]\noutside = \"reject\"\n[law]");
    let sweep_text = SWEEP.replace("[grid]", "[grid]\nlaw.young = [1.0e3, 1.0e9]");
    let (_folder, file) = folder(&scenario, &sweep_text);
    let (success, output) = output_of(carom().arg("sweep").arg(&file));
    assert!(success && output.contains("of them failed: column error says why"), "{output}");
    let rows = Rows::read(&file.with_extension("parquet")).unwrap();
    assert_eq!(rows.rows.len(), 40);
    assert!(rows.failed() > 0 && rows.failed() < 40);
    let failed = (0..40).find(|&row| cell(&rows, row, "error") != &Cell::Nothing).unwrap();
    let Cell::Text(why) = cell(&rows, failed, "error") else { panic!() };
    assert!(why.contains("outside the table's domain"), "{why}");
    assert_eq!(cell(&rows, failed, "kinetic_energy"), &Cell::Nothing);
}

#[test]
fn bad_sweeps_are_refused_in_one_line() {
    let cases = [
        ("scenario = \"gas.toml\"", "scenario = \"none.toml\"", "cannot read"),
        ("seeds = {", "seed = {", "line 4: unknown field `seed`"),
        ("count = 5", "count = 0", "seeds has no values, must have at least 1"),
        ("count = 5", "count = 1000000000", "seeds: count is 1000000000, must be at most 10000000"),
        (
            "from = 1,",
            "from = 9223372036854775805,",
            "seeds: from is 9223372036854775805, must be at most 9223372036854775802 with 5 values",
        ),
        (
            "[0.05, 0.2]",
            "[0.05, -0.2]",
            "gas.packing_fraction is -0.2, must be above 0 and below 1",
        ),
        ("packing_fraction", "packing", "unknown field `packing`"),
        ("[0.05, 0.2]", "0.1", "must be a list or { from, to, count, scale }"),
        (
            "[0.05, 0.2]",
            "{ from = 0, to = 1, count = 3, scale = \"log\" }",
            "must be above 0 for scale",
        ),
        ("[grid]", "[grid]\ngas.seed = [1]", "gas.seed is set twice"),
        ("[grid]", "[grid]\ngrain.0.radius = [1.0]", "grain"),
        ("[grid]", "[grid]\nmethods.7 = [\"emd\"]", "methods.7: 7 must be from 0 to 0"),
        ("[\"emd\", \"emd*\"]", "[]", "methods is empty"),
        ("[grid]", "[[list]]\nduration = 1.0\n[[list]]\nsample = 1.0\n[grid]", "list: row 1 sets"),
    ];
    for (old, new, wanted) in cases {
        let text = SWEEP.replace(old, new);
        assert_ne!(text, SWEEP, "{old}");
        let (_folder, file) = folder(SCENARIO, &text);
        let (success, output) = output_of(carom().arg("sweep").arg(&file));
        assert!(!success && output.contains(wanted), "{new}: {output}");
        assert_eq!(output.lines().count(), 1, "{output}");
        assert!(!file.with_extension("parquet").exists());
    }
}

#[test]
fn a_result_of_another_sweep_is_not_overwritten() {
    let (folder, file) = folder(SCENARIO, SWEEP);
    let out = folder.path().join("out.parquet");
    sweep(&Plan::read(&file).unwrap(), [1, 1], &out).unwrap();
    fs::write(&file, SWEEP.replace("count = 5", "count = 4")).unwrap();
    let why = sweep(&Plan::read(&file).unwrap(), [1, 1], &out).unwrap_err().to_string();
    assert!(why.contains("is the result of another sweep"), "{why}");
}

#[test]
fn lists_and_ranges_are_what_they_say() {
    let text = r#"
scenario = "gas.toml"
[grid]
law.dissipation = { from = 1e-6, to = 1e-4, count = 3, scale = "log" }
[[list]]
gas.count = 3
duration = 0.1
[[list]]
gas.count = 4
duration = 0.2
"#;
    let (_folder, file) = folder(SCENARIO, text);
    let plan = Plan::read(&file).unwrap();
    assert_eq!(plan.source.runs, 6);
    for (number, dissipation) in [1e-6, 1e-5, 1e-4, 1e-6, 1e-5, 1e-4].into_iter().enumerate() {
        let run = plan.run(number).unwrap();
        let Some(carom_host::scenario::LawSpec::Viscoelastic { dissipation: found, .. }) =
            run.scenario.law
        else {
            panic!()
        };
        assert!((found / dissipation - 1.0).abs() < 1e-14);
        assert_eq!(run.scenario.gas.unwrap().count, 3 + number / 3);
        assert_eq!(run.scenario.duration, Some([0.1, 0.2][number / 3]));
    }
}
