//! Does the program keep its promises to a user? Runs `carom` with good and bad input; writes into temporary directories.

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

fn carom() -> Command {
    Command::new(env!("CARGO_BIN_EXE_carom"))
}

fn run(arguments: &[&str]) -> Output {
    carom().args(arguments).output().expect("carom starts")
}

fn scenario(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios").join(name)
}

fn text(path: &Path) -> &str {
    path.to_str().expect("a path in UTF-8")
}

/// The one line that a refused command writes.
fn refusal(arguments: &[&str]) -> String {
    let output = run(arguments);
    assert!(!output.status.success(), "{arguments:?} was accepted");
    assert!(output.stdout.is_empty(), "{arguments:?} wrote to standard output");
    let error = String::from_utf8(output.stderr).expect("UTF-8");
    assert_eq!(error.lines().count(), 1, "not one line: {error}");
    error
}

fn written(folder: &Path, name: &str, content: &str) -> PathBuf {
    let file = folder.join(name);
    std::fs::write(&file, content).expect("a temporary file");
    file
}

#[test]
fn bad_flags_and_files_are_refused_in_one_line() {
    for (arguments, wanted) in [
        (&["fly"][..], "fly"),
        (&["collide"], "<CASES>"),
        (&["collide", "no-such-file.csv"], "no-such-file.csv"),
        (&["collide", "cases.csv", "--with", "guess"], "possible values: table, integrate"),
        (&["run", "no-such-file.toml"], "no-such-file.toml"),
        (&["compare"], "<SCENARIO>"),
        (&["table", "--plot", "picture.gif"], ".png, .svg or .pdf"),
        (&["table", "--plot", "picture.png", "--figure", "7"], "7 is not in 3..=5"),
        (&["table", "--figure", "3"], "--plot"),
    ] {
        let error = refusal(arguments);
        assert!(error.contains(wanted), "{arguments:?}: {error}");
    }
}

#[test]
fn help_and_version_are_not_errors() {
    for flag in ["--help", "--version", "help"] {
        let output = run(&[flag]);
        assert!(output.status.success() && !output.stdout.is_empty(), "{flag}");
    }
}

const HEAD: &str = "id,law,k,gamma,Y,nu,A,R1,R2,m1,m2,v,e";

/// A bad row is named on standard error, the others are answered, and the exit status is 1.
#[test]
fn bad_rows_are_named_and_the_others_answered() {
    let folder = tempfile::tempdir().expect("a temporary directory");
    let good = "a,lsd,2000,0,,,,0.1,0.1,1,1,5,0.3";
    for (row, wanted) in [
        ("b,spring,2000,0,,,,0.1,0.1,1,1,5,0.3", "column `law`: `spring` is not `lsd`"),
        ("b,lsd,,0,,,,0.1,0.1,1,1,5,0.3", "column `k`: `` is not a spring constant"),
        ("b,lsd,2000,-1,,,,0.1,0.1,1,1,5,0.3", "column `gamma`: `-1`"),
        ("b,lsd,2000,0,,,,nan,0.1,1,1,5,0.3", "column `R1`: `nan`"),
        ("b,lsd,2000,0,,,,0.1,0.1,0,1,5,0.3", "column `m1`: `0`"),
        ("b,lsd,2000,0,,,,0.1,0.1,1,1,5,1", "column `e`: `1` is not an eccentricity"),
        ("b,lsd,2000,0,,,,0.1,0.1,1,1,inf,0", "column `v`: `inf`"),
        ("b,viscoelastic,,,1e9,0.6,0,0.1,0.1,1,1,5,0.3", "column `nu`: `0.6`"),
        ("b,lsd,2000", "row 2"),
        ("b,lsd,1e-300,0,,,,1e-300,1e-300,1e300,1e300,1e300,0", "row 2"),
    ] {
        let file = written(folder.path(), "cases.csv", &format!("{HEAD}\n{good}\n{row}\n"));
        let output = run(&["collide", text(&file), "--with", "integrate"]);
        assert_eq!(output.status.code(), Some(1), "{row}");
        let [answers, errors] =
            [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
        let lines: Vec<&str> = errors.lines().collect();
        assert!(
            lines[0].contains(wanted) && lines[0].contains("row 2 (line 3)"),
            "{row}: {errors}"
        );
        assert!(lines[1].contains("1 of 2 rows") && lines.len() == 2, "{row}: {errors}");
        let answers: Vec<&str> = answers.lines().skip(1).collect();
        assert!(
            answers[0].starts_with("a,0.0") && answers[0].ends_with(",ok"),
            "{row}: {answers:?}"
        );
        assert_eq!(answers[1..], ["b,,,,,,bad"], "{row}");
    }
    let file = written(folder.path(), "cases.csv", "id,law,k\na,lsd,1\n");
    assert!(refusal(&["collide", text(&file)]).contains("column `gamma` is missing"));
}

#[test]
fn bad_scenarios_are_named() {
    let good = "dimension = 2\nduration = 1.0\nsample = 0.5\n[law]\nkind = \"lsd\"\n\
                stiffness = 1e4\ndamping = 0.1\n[[grain]]\nradius = 0.1\nmass = 1.0\nat = [0.5, 0.5]\n";
    let folder = tempfile::tempdir().expect("a temporary directory");
    for (from, to, wanted) in [
        ("dimension = 2", "dimension = 4", "dimension is 4, must be 1, 2 or 3"),
        ("duration = 1.0", "duration = -1.0", "duration is -1, must be finite and above 0"),
        ("duration = 1.0", "", "duration [s] and collisions"),
        ("sample = 0.5", "sample = nan", "sample is NaN"),
        ("sample = 0.5", "sample = 0.5\ngravity = [1.0]", "gravity has 1 numbers, must have 2"),
        (
            "sample = 0.5",
            "sample = 0.5\ncolour = 1",
            "line 4: unknown field `colour`; there is box, collisions",
        ),
        ("stiffness = 1e4", "stiffness = 0.0", "law.stiffness is 0"),
        (
            "kind = \"lsd\"",
            "kind = \"glue\"",
            "law: unknown variant `glue`; there is lsd, viscoelastic, l94 or constant",
        ),
        ("mass = 1.0", "mass = 0.0", "grain 0: mass is 0"),
        ("mass = 1.0", "", "grain 0: give one of mass"),
        ("at = [0.5, 0.5]", "at = [0.5]", "grain 0: at has 1 numbers, must have 2"),
        ("radius = 0.1", "radius = \"wide\"", "grain 0: radius is a text, must be a number"),
        ("[law]", "[box]\nz = { kind = \"periodic\" }\n[law]", "box.z is given"),
        ("[law]", "[box]\nx = { kind = \"periodic\" }\n[law]", "box.x: give from and to"),
        (
            "[law]",
            "[box]\nx = { kind = \"walls\", from = 0.0, to = 1.0, surface = \"hard\" }\n[law]",
            "box.x.restitution",
        ),
    ] {
        assert!(good.contains(from), "{from}");
        let file = written(folder.path(), "scenario.toml", &good.replacen(from, to, 1));
        let error = refusal(&["run", text(&file), "--out", text(folder.path())]);
        assert!(error.contains(wanted), "{to}: {error}");
        assert!(error.contains("scenario.toml"), "{error}");
    }
}

/// All at once, with line and column; of a good file the number of grains.
#[test]
fn a_scenario_is_checked() {
    let folder = tempfile::tempdir().expect("a temporary directory");
    let bad = "dimension = 2\nsample = 0.5\nduration = -1.0\n[law]\n  kind = \"constant\"\n  restitution = 2.0\n";
    let file = written(folder.path(), "bad.toml", bad);
    let output = carom().args(["scenario", "check", text(&file)]).output().expect("carom runs");
    assert!(!output.status.success());
    let found = String::from_utf8(output.stdout).expect("text");
    let name = text(&file);
    assert_eq!(
        found,
        format!(
            "{name}:1:1: no grains: add [[grain]] entries, [[species]] or a [gas]\n\
             {name}:3:1: duration is -1, must be finite and above 0\n\
             {name}:6:3: law.restitution is 2, must be from 0 to 1\n"
        )
    );
    let why = String::from_utf8(output.stderr).expect("text");
    assert!(why.contains("bad.toml: 3 things are wrong"), "{why}");
    // What does not fit the box, though every field is right.
    let gas = "dimension = 1\nsample = 0.5\nduration = 1.0\nlaw = { kind = \"constant\", restitution = 1.0 }\n\
        [box]\nx = { kind = \"periodic\", from = 0.0, to = 9.0 }\n\
        [[grain]]\nradius = 0.5\nmass = 1.0\nat = [1.0]\n[observe.profile]\naxis = \"z\"\n";
    let file = written(folder.path(), "misfit.toml", gas);
    let output = carom().args(["scenario", "check", text(&file)]).output().expect("carom runs");
    let found = String::from_utf8(output.stdout).expect("text");
    let wanted = ":12:1: observe.profile.axis is z, but dimension is 1\n";
    assert!(!output.status.success() && found.ends_with(wanted), "{found}");
    // A grain in a wall.
    let wall = "dimension = 2\nsample = 0.5\nduration = 1.0\nlaw = { kind = \"constant\", restitution = 1.0 }\n\
        [[obstacle]]\nchain = [[0.0, 0.0], [9.0, 0.0]]\n[[grain]]\nradius = 0.5\nmass = 1.0\nat = [1.0, 0.25]\n";
    let file = written(folder.path(), "wall.toml", wall);
    let output = carom().args(["scenario", "check", text(&file)]).output().expect("carom runs");
    let found = String::from_utf8(output.stdout).expect("text");
    let wanted = ":10:1: eMD: grain 0 overlaps piece 0 of obstacle 0; it is at [1.0, 0.25] m, its gap is -0.25 m, must be at least 0\n";
    assert!(!output.status.success() && found.ends_with(wanted), "{found}");
    for name in ["beads", "column", "fig6", "gas", "hourglass", "layer", "mixture"] {
        let good = run(&["scenario", "check", text(&scenario(&format!("{name}.toml")))]);
        assert!(String::from_utf8_lossy(&good.stdout).contains("good, "));
    }
}

/// The schema is one that knows every field of a shipped scenario.
#[test]
fn the_schema_is_json() {
    let output = run(&["scenario", "--schema"]);
    let schema: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
    assert_eq!(schema["properties"]["sample"]["type"], "number");
    assert!(schema["$defs"]["SpeciesSpec"]["properties"]["packing_fraction"].is_object());
    assert_eq!(schema["$defs"]["SpeciesSpec"]["additionalProperties"], false);
}

#[test]
fn grains_that_overlap_are_named() {
    let text_of = "dimension = 1\nduration = 1.0\nsample = 0.5\nmethods = [\"emd*\"]\n[law]\n\
                   kind = \"lsd\"\nstiffness = 1e4\ndamping = 0.1\n\
                   [[grain]]\nradius = 0.1\nmass = 1.0\nat = [0.0]\n\
                   [[grain]]\nradius = 0.1\nmass = 1.0\nat = [0.1]\n";
    let folder = tempfile::tempdir().expect("a temporary directory");
    let file = written(folder.path(), "scenario.toml", text_of);
    let error = refusal(&["run", text(&file), "--out", text(folder.path())]);
    assert!(error.contains("grain 1") && error.contains("overlap"), "{error}");
}

/// `carom collide … | head` is no error and no panic.
#[test]
fn a_closed_pipe_is_not_an_error() {
    let data = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/data/collisions.csv");
    let mut child = carom()
        .args(["collide", data, "--with", "integrate"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("carom starts");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("carom ends");
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    assert!(output.status.success());
}

#[test]
fn certificates_are_json() {
    let output = run(&["table", "--json"]);
    let tables: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let tables = tables.as_array().expect("a list");
    assert!(!tables.is_empty());
    for table in tables {
        assert!(table["bytes"].as_u64().expect("bytes") > 0, "{table}");
        assert!(table["max"]["eps_phi"].as_f64().expect("an error") < 0.1, "{table}");
        assert!(table["domain"]["c_dis_max"].as_f64().expect("a limit") > 0.0, "{table}");
    }
}

#[test]
fn a_run_leaves_whole_files_only() {
    let folder = tempfile::tempdir().expect("a temporary directory");
    let output =
        run(&["run", text(&scenario("fig6.toml")), "--out", text(folder.path()), "--json"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let summary: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    for run in summary["runs"].as_array().expect("a list") {
        assert_eq!(run["collisions"], 1, "{run}");
    }
    let mut names: Vec<String> = std::fs::read_dir(folder.path())
        .expect("the directory")
        .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    let wanted =
        ["emd-star.csv", "emd-star.xyz", "emd.csv", "emd.xyz", "md.csv", "md.xyz", "summary.json"];
    assert_eq!(names, wanted);
}

/// Whatever ends a run, no file of its final name is left half-written.
#[cfg(unix)]
#[test]
fn an_interrupted_run_leaves_no_half_written_file() {
    for signal in ["INT", "TERM", "KILL"] {
        let folder = tempfile::tempdir().expect("a temporary directory");
        let mut child = carom()
            .args(["run", text(&scenario("gas.toml")), "--out", text(folder.path())])
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("carom starts");
        while !folder.path().join("unfinished/md.xyz").exists() {
            assert!(child.try_wait().expect("a child").is_none(), "ended before it wrote");
            std::thread::sleep(std::time::Duration::from_millis(5));
        }
        let id = child.id().to_string();
        Command::new("kill").args(["-s", signal, &id]).status().expect("kill");
        assert!(!child.wait().expect("a child").success());
        let entries = std::fs::read_dir(folder.path()).expect("the directory");
        let left: Vec<_> = entries.map(|entry| entry.expect("an entry").file_name()).collect();
        assert_eq!(left, ["unfinished"], "{signal}");
    }
}

/// A page with the size of the picture, its content packed, its table of objects where the end says.
#[test]
fn a_figure_is_drawn_as_pdf() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("path.pdf");
    let output = run(&["figure", "mp13-3", "--out", text(&file)]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let bytes = std::fs::read(&file).unwrap();
    assert!(bytes.starts_with(b"%PDF-1."), "{:?}", &bytes[..8]);
    let all = String::from_utf8_lossy(&bytes);
    for part in ["/Type/Page", "/MediaBox", "/FlateDecode", "/XObject"] {
        assert!(
            all.replace("/ ", "/").contains(part) || all.replace(' ', "").contains(part),
            "{part}"
        );
    }
    let end = all.rsplit("startxref").next().unwrap();
    let table: usize = end.split_whitespace().next().unwrap().parse().unwrap();
    assert!(bytes[table..].starts_with(b"xref"), "no table of objects at {table}");
    assert!(end.trim_end().ends_with("%%EOF"));
}
