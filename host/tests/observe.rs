//! Is what a run measures right? Runs small systems; compares with identities that hold exactly, and with what is published.

use carom_host::columns::Cell;
use carom_host::observe::Recorder;
use carom_host::scenario::{MethodName, Scenario, Start};
use carom_host::{measure, method};

/// Disks in a walled box.
const BOX: &str = r#"
dimension = 2
duration = 40.0
sample = 40.0
methods = ["emd*"]
[box]
x = { kind = "walls", from = 0.0, to = 8.0, surface = "hard", restitution = 1.0 }
y = { kind = "walls", from = 0.0, to = 6.0, surface = "hard", restitution = 1.0 }
[law]
kind = "lsd"
stiffness = 1.0e4
damping = 0.0
[options]
enduring = "paper"
[gas]
count = 20
radius = 0.5
density = 1.909859317102744
thermal_speed = 1.4142135623730951
seed = 3
[observe]
every = 0.01
"#;

/// What was measured, by name and of what, and the energy at the beginning and the end.
struct Measured {
    recorder: Recorder,
    energy: [f64; 2],
}

impl Measured {
    fn of(text: &str, name: MethodName) -> Self {
        let scenario = Scenario::parse(text).unwrap();
        let start = Start::new(&scenario).unwrap();
        method::with(name, &scenario, &start, |method| {
            let before = method.kinetic_energy();
            let recorder = measure::attend(method, &scenario, &start)?;
            Ok(Self { recorder, energy: [before, method.kinetic_energy()] })
        })
        .unwrap()
    }

    fn value(&self, name: &str, of: &str) -> f64 {
        let means = self.recorder.means();
        let found = means.iter().find(|(quantity, _)| quantity.name == name && quantity.of == of);
        found.unwrap_or_else(|| panic!("no {name} of {of}")).1.value
    }
}

/// d/dt Σ m x v = Σ m v² + Σ r·F − F (L − 2 R), F the force on a wall: on average the stress of motion and
/// contacts is what the walls feel, but for the left-hand side, which falls as 1/t.
fn assert_stress_is_felt_by_walls(text: &str, method: MethodName, tolerance: f64) {
    let found = Measured::of(text, method);
    for (axis, length) in [("x", 8.0), ("y", 6.0)] {
        let stress = found.value(&format!("stress {axis}{axis}"), "all") * 48.0;
        let force = |end| found.value("force", &format!("wall {axis} {end}"));
        let felt = 0.5 * (force("from") + force("to")) * (length - 1.0);
        assert!((stress / felt - 1.0).abs() < tolerance, "{axis}: {stress} and {felt}");
        assert!((force("from") / force("to") - 1.0).abs() < 0.2);
    }
    assert!(found.value("compressibility factor", "all") > 1.5);
}

#[test]
fn hard_disks_press_on_walls_as_their_stress_says() {
    assert_stress_is_felt_by_walls(&BOX.replace("40.0", "200.0"), MethodName::Emd, 0.01);
}

/// Contacts that take a third of the time between them: what they transfer is all there.
#[test]
fn soft_disks_do_so_too() {
    let soft = BOX.replace("1.0e4", "1.0e3").replace("40.0", "80.0");
    let found = Measured::of(&soft, MethodName::EmdStar);
    assert!(found.value("lasting contacts", "all") > 0.5);
    assert!(found.value("contact duration", "all") > 0.02);
    assert_stress_is_felt_by_walls(&soft, MethodName::EmdStar, 0.02);
}

/// The box with walls that are as soft as the disks.
fn soft_box() -> String {
    BOX.replace(", surface = \"hard\", restitution = 1.0", "").replace("1.0e4", "1.0e3")
}

/// Force-based MD sums up the forces of its steps.
#[test]
fn forces_press_on_walls_as_their_stress_says() {
    let text = soft_box().replace("40.0", "80.0");
    assert_stress_is_felt_by_walls(&text, MethodName::Md, 0.02);
    let [md, events] =
        [MethodName::Md, MethodName::EmdStar].map(|method| Measured::of(&text, method));
    for (name, of, tolerance) in [
        ("pressure", "all", 0.02),
        ("speed of approach", "all", 0.03),
        // Contacts that a third disk breaks off are two in the papers' mode.
        ("mean free time", "all", 0.08),
        ("force", "wall x from", 0.05),
    ] {
        let [a, b] = [&md, &events].map(|found| found.value(name, of));
        assert!((a / b - 1.0).abs() < tolerance, "{name}: {a} by forces, {b} by events");
    }
    // π √(m/(2 k)), but for those that a third disk disturbs.
    let duration = md.value("contact duration", "all") / (std::f64::consts::PI * 0.5e-3_f64.sqrt());
    assert!((duration - 1.0).abs() < 0.02, "{duration}");
}

/// In contacts between grains and with walls goes what is missing in the end.
#[test]
fn the_energy_lost_is_what_is_missing() {
    let lossy = BOX
        .replace("damping = 0.0", "damping = 5.0")
        .replace("restitution = 1.0", "restitution = 0.9");
    for method in [MethodName::Emd, MethodName::EmdStar] {
        let found = Measured::of(&lossy, method);
        let walls = ["x from", "x to", "y from", "y to"].map(|wall| format!("wall {wall}"));
        let walls: f64 = walls.iter().map(|of| found.value("energy lost in contacts", of)).sum();
        let lost = 40.0 * (found.value("energy lost in contacts", "all") + walls);
        let missing = found.energy[0] - found.energy[1];
        assert!(walls > 0.0 && missing > 0.3 * found.energy[0]);
        assert!((lost / missing - 1.0).abs() < 1e-3, "{method:?}: {lost} of {missing}");
    }
    let lossy = soft_box().replace("damping = 0.0", "damping = 2.0");
    let found = Measured::of(&lossy, MethodName::Md);
    let walls = ["x from", "x to", "y from", "y to"].map(|wall| format!("wall {wall}"));
    let walls: f64 = walls.iter().map(|of| found.value("energy lost in contacts", of)).sum();
    let lost = 40.0 * (found.value("energy lost in contacts", "all") + walls);
    let missing = found.energy[0] - found.energy[1];
    assert!(walls > 0.0 && missing > 0.3 * found.energy[0]);
    assert!((lost / missing - 1.0).abs() < 1e-3, "by forces: {lost} of {missing}");
}

/// Equipartition: two kinds of elastic disks, one eight times as heavy, have one temperature.
#[test]
fn species_are_told_apart() {
    let mut text = BOX.replace("count = 20", "count = 12").replace("40.0", "200.0");
    let at = text.find("[gas]").unwrap();
    let grains = "[[grain]]\nradius = 0.4\nmass = 8.0\nat = [1.0, 1.0]\nmoving = [0.5, 0.2]\n";
    text.insert_str(at, &[grains, &grains.replace("1.0, 1.0", "3.0, 1.0")].concat());
    let found = Measured::of(&text, MethodName::Emd);
    let [heavy, light] = ["grain", "gas"].map(|s| found.value("temperature", s));
    let all = found.value("temperature", "all");
    assert!(((2.0 * heavy + 12.0 * light) / 14.0 / all - 1.0).abs() < 1e-9);
    assert!((heavy / light - 1.0).abs() < 0.15, "{heavy} and {light}");
    assert!(found.value("contacts", "grain - gas") > 0.0);
}

/// A mean free time of elastic hard spheres at density 0.5, N = 256, two thousand collisions a grain:
/// Lue 2005 has 0.1303 for larger systems.
#[test]
fn spheres_fly_as_long_as_is_known() {
    let text = r#"
dimension = 3
duration = 12.0
sample = 12.0
methods = ["emd"]
[box]
x = { kind = "periodic" }
y = { kind = "periodic" }
z = { kind = "periodic" }
[law]
kind = "constant"
restitution = 1.0
[gas]
count = 256
packing_fraction = 0.261799388
radius = 0.5
density = 1.909859317102744
thermal_speed = 1.4142135623730951
seed = 1
[observe]
from = 2.0
every = 0.1
"#;
    let found = Measured::of(text, MethodName::Emd);
    let temperature = found.value("temperature", "all");
    let free = found.value("mean free time", "all") * temperature.sqrt();
    assert!((free / 0.13031 - 1.0).abs() < 0.03, "{free}");
    let z = found.value("compressibility factor", "all");
    assert!((z / 3.2616 - 1.0).abs() < 0.03, "{z}");
    // ⟨v⟩ of approach at contact: √(π T/m).
    let approach = found.value("speed of approach", "all") / temperature.sqrt();
    assert!((approach / 1.77245 - 1.0).abs() < 0.02, "{approach}");
}

#[test]
fn what_cannot_be_measured_is_refused() {
    let profile = "[observe.profile]\naxis = ";
    for (old, new, wanted) in [
        ("every = 0.01", &*format!("{profile}\"w\""), "unknown variant `w`"),
        ("every = 0.01", &*format!("{profile}\"x\"\nbins = 0"), "observe.profile.bins is 0"),
        ("every = 0.01", "every = 0.0", "observe.every is 0, must be above 0"),
        ("every = 0.01", "every = 1e-9", "observe.every is 1e-9: more than"),
        ("every = 0.01", "every = 41.0", "observe.every is 41, must be at most duration - from"),
        ("every = 0.01", "from = -1.0", "observe.from is -1, must be at least 0"),
        ("every = 0.01", "from = 40.0", "observe.from is 40, must be less than duration"),
        ("every = 0.01", "ever = 1.0", "unknown field `ever`"),
    ] {
        let error = format!("{:#}", Scenario::parse(&BOX.replace(old, new)).unwrap_err());
        assert!(error.contains(wanted), "{new}: {error}");
    }
}

/// What fits the file but not the system.
#[test]
fn what_does_not_fit_the_system_is_refused() {
    let open = BOX.replacen(
        "x = { kind = \"walls\", from = 0.0, to = 8.0, surface = \"hard\", restitution = 1.0 }\n",
        "",
        1,
    );
    let open = open.split("[gas]").next().unwrap().to_owned()
        + "[[grain]]\nradius = 0.5\nmass = 1.0\nat = [1.0, 1.0]\n[observe]\n";
    for (text, more, wanted) in [
        (BOX, "[observe.profile]\naxis = \"z\"", "observe.profile.axis is z, but dimension is 2"),
        (&open, "[observe.profile]\naxis = \"x\"", "observe.profile.from: box.x has no such end"),
        (BOX, "[observe.profile]\naxis = \"x\"\nfrom = 9.0", "from must be the smaller"),
        (&open, "[observe.pair_distribution]", "box.x is open, must be periodic or walled"),
        (BOX, "[observe.pair_distribution]\nto = 4.0", "at most 3, half of box.y"),
    ] {
        let scenario = Scenario::parse(&format!("{text}{more}")).unwrap();
        let start = Start::new(&scenario).unwrap();
        let error = format!("{:#}", Recorder::new(&scenario, &start, None).unwrap_err());
        assert!(error.contains(wanted), "{more}: {error}");
    }
}

/// Points under gravity, between a floor and a roof that they leave as fast as they came: all of them are
/// somewhere, they are denser below, and what they have across gravity is the same at all heights.
#[test]
fn the_profile_of_points_under_gravity() {
    let text = BOX
        .replace("dimension = 2", "dimension = 2\ngravity = [0.0, -0.5]")
        .replace("count = 20", "count = 200")
        .replace("radius = 0.5", "radius = 1e-4")
        .replace("density = 1.909859317102744", "density = 2.387e11")
        .replace(
            "x = { kind = \"walls\", from = 0.0, to = 8.0, surface = \"hard\", restitution = 1.0 }",
            "x = { kind = \"periodic\", from = 0.0, to = 8.0 }",
        )
        .replace("every = 0.01", "every = 0.1\n[observe.profile]\naxis = \"y\"\nbins = 6");
    let found = Measured::of(&text, MethodName::Emd);
    let tables = found.recorder.tables();
    let profile = tables.iter().find(|table| table.name == "profile").unwrap();
    let column = |name: &str| {
        let place = profile.columns.iter().position(|column| column.name == name).unwrap();
        let cell = |row: &Vec<Cell>| match row[place] {
            Cell::Number(number) => number,
            _ => f64::NAN,
        };
        profile.rows.iter().map(cell).collect::<Vec<f64>>()
    };
    let density = column("number density [1/m2]");
    let sum: f64 = density.iter().sum::<f64>() * 8.0;
    assert!((sum - 200.0).abs() < 1e-9, "{sum}");
    assert!(density.windows(2).all(|pair| pair[1] < pair[0]), "{density:?}");
    let horizontal = column("temperature x [J]");
    let mean = horizontal.iter().sum::<f64>() / 6.0;
    assert!(horizontal.iter().all(|t| (t / mean - 1.0).abs() < 0.35), "{horizontal:?}");
}

/// What a run wrote becomes a picture; what is no table of numbers is refused in one line.
#[cfg(feature = "cli")]
#[test]
fn tables_are_drawn() {
    use std::process::Command;
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let text =
        BOX.replace("duration = 40.0", "duration = 2.0").replace("sample = 40.0", "sample = 1.0");
    let more = "[observe.profile]\naxis = \"x\"\nbins = 8\n[observe.pair_distribution]\nto = 2.0\nbins = 20\n\
        [observe.correlations]\nto = 0.5\npoints = 10\n";
    std::fs::write(path("box.toml"), text + more).unwrap();
    let carom = |arguments: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_carom"));
        let output = command.args(arguments).current_dir(folder.path()).output().unwrap();
        (output.status.success(), String::from_utf8(output.stderr).unwrap())
    };
    let (success, error) = carom(&["run", "box.toml", "--out", "out"]);
    assert!(success, "{error}");
    for (name, words) in [
        ("profile", "temperature [J]"),
        ("pair-distribution", "r [m]"),
        ("correlations", "mean square displacement [m2]"),
        ("blocks", "pressure [N/m]"),
    ] {
        let tables = ["csv", "parquet"].map(|end| path(&format!("out/emd-star-{name}.{end}")));
        let pictures = tables.map(|table| {
            let svg = table.with_extension("svg");
            let (table, svg) = (table.to_str().unwrap(), svg.to_str().unwrap());
            let (success, error) = carom(&["plot", table, "--out", svg]);
            assert!(success, "{error}");
            std::fs::read_to_string(svg).unwrap()
        });
        assert_eq!(pictures[0], pictures[1], "{name}: CSV and Parquet differ");
        let letters: String =
            pictures[0].split('<').map(|part| part.rsplit('>').next().unwrap()).collect();
        let bare = |text: &str| text.replace(char::is_whitespace, "");
        assert!(bare(&letters).contains(&bare(words)), "{name}: {letters}");
    }
    assert!(carom(&["plot", "out/emd-star-profile.csv", "--show", "density", "--log", "y"]).0);
    assert!(path("out/emd-star-profile.png").exists());
    assert!(carom(&["plot", "box.toml", "--grains", "out/emd-star.xyz", "--frame", "0"]).0);
    assert!(path("out/emd-star.png").exists());
    for (arguments, wanted) in [
        (&["plot", "out/emd-star-averages.csv"][..], "holds words"),
        (&["plot", "box.toml", "--log", "x"], "--show and --log are for tables"),
        (&["plot", "none.csv", "--grains", "out/emd-star.xyz"], "--grains is for a scenario"),
        (
            &["plot", "out/emd-star-profile.csv", "--show", "colour"],
            "no column is called colour; there are: number density",
        ),
        (&["plot", "none.csv"], "cannot read none.csv"),
        (&["plot", "box.toml", "--out", "picture.gif"], ".png, .svg or .pdf"),
    ] {
        let (success, error) = carom(arguments);
        assert!(!success && error.contains(wanted) && error.lines().count() == 1, "{error}");
    }
}

/// Grains that crowd are clustered, and their forces are told step by step: walls feel the stress, and energy is all there.
#[test]
fn clusters_press_on_walls_as_their_stress_says() {
    let clustered = BOX.replace("enduring = \"paper\"", "enduring = \"integrated\"");
    let soft = clustered.replace("1.0e4", "1.0e3").replace("40.0", "80.0");
    assert_stress_is_felt_by_walls(&soft, MethodName::EmdStar, 0.02);
    let lossy = clustered.replace("damping = 0.0", "damping = 5.0");
    let found = Measured::of(&lossy, MethodName::EmdStar);
    let lost = 40.0 * found.value("energy lost in contacts", "all");
    let missing = found.energy[0] - found.energy[1];
    assert!(missing > 0.2 * found.energy[0]);
    assert!((lost / missing - 1.0).abs() < 0.02, "{lost} of {missing}");
    // Which contact of a cluster is which is not known.
    let says = |name: &str| found.recorder.means().iter().any(|(q, _)| q.name == name);
    assert!(says("pressure") && says("speed of approach"));
    assert!(!says("coefficient of restitution") && !says("contact duration"));
}

/// Disks fall onto a floor and come to rest: from then on the floor bears their weight, and the walls no more than the
/// stress along them; no grain moves any more.
#[test]
fn a_settled_heap_weighs_what_it_weighs() {
    for (law, method) in [
        ("kind = \"lsd\"\nstiffness = 1.0e5\ndamping = 40.0", MethodName::EmdStar),
        ("kind = \"constant\"\nrestitution = 0.5", MethodName::Emd),
    ] {
        let text = BOX
            .replace("kind = \"lsd\"\nstiffness = 1.0e4\ndamping = 0.0", law)
            .replace("enduring = \"paper\"", "enduring = \"integrated\"")
            .replace("sample = 40.0", "sample = 40.0\ngravity = [0.0, -10.0]")
            .replace(", surface = \"hard\", restitution = 1.0", "")
            .replace(
                "\"emd*\"",
                &format!("{:?}", if method == MethodName::Emd { "emd" } else { "emd*" }),
            )
            .replace("every = 0.01", "from = 30.0\nevery = 0.5");
        let found = Measured::of(&text, method);
        let weight: f64 = 20.0 * 10.0;
        let floor = found.value("force", "wall y from");
        assert!((floor / weight - 1.0).abs() < 1e-3, "{law}: {floor}");
        let [left, right] = ["wall x from", "wall x to"].map(|of| found.value("force", of));
        assert!((left - right).abs() < 1e-3 * weight, "{left} and {right}");
        // Σ r·F of all contacts: Σ m g y of the centres, the floor's distance to them being its R.
        let found = found.value("stress xx", "all") * 48.0;
        assert!((found - right * 7.0).abs() < 0.01 * weight, "{found} and {right}");
    }
}

/// One above the other: what each bears is the weight of all that lie above it (Σ y F over the contacts).
#[test]
fn a_column_bears_what_lies_above() {
    let n = 6;
    let mut text = "dimension = 2\nduration = 60.0\nsample = 60.0\ngravity = [0.0, -10.0]\n\
        methods = [\"emd*\"]\n[box]\nx = { kind = \"walls\", from = -0.5, to = 1.5 }\n\
        y = { kind = \"walls\", from = 0.0, to = 10.0 }\n\
        [law]\nkind = \"lsd\"\nstiffness = 1e5\ndamping = 60.0\n[observe]\nfrom = 50.0\nevery = 1.0\n"
        .to_owned();
    for k in 0..n {
        let y = 0.5 + 1.01 * f64::from(k);
        text.push_str(&format!("[[grain]]\nradius = 0.5\nmass = 1.0\nat = [0.5, {y}]\n"));
    }
    let found = Measured::of(&text, MethodName::EmdStar);
    assert!((found.value("force", "wall y from") / 60.0 - 1.0).abs() < 1e-3);
    // Between grains k and k + 1 weighs what is above: 5 + 4 + 3 + 2 + 1 grains, at a distance of 1 less the overlap.
    let virial = found.value("stress yy", "all") * 20.0;
    let overlap = |above: f64| 10.0 * above / 1e5;
    let wanted: f64 =
        (1..n).map(f64::from).map(|above| 10.0 * above * (1.0 - overlap(above))).sum();
    assert!((virial / wanted - 1.0).abs() < 1e-3, "{virial} of {wanted}");
}
