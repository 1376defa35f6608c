//! Does a scenario shear its box as it says? Runs sheared gases; compares what they measure with identities, and refusals with words.

use carom_host::columns::Cell;
use carom_host::measure;
use carom_host::observe::Recorder;
use carom_host::scenario::{MethodName, Scenario, Start};

const SHEARED: &str = r#"
dimension = 3
duration = 40.0
sample = 40.0
methods = ["emd"]
[box]
x = { kind = "periodic" }
y = { kind = "periodic", from = -4.0, to = 4.0 }
z = { kind = "periodic" }
shear = { flow = "x", gradient = "y", rate = 1.0 }
[law]
kind = "constant"
restitution = 0.9
[gas]
count = 250
radius = 0.5
density = 1.909859317102744
packing_fraction = 0.26
thermal_speed = 2.0
seed = 3
[observe]
from = 10.0
every = 0.02
"#;

/// What was measured of a scenario.
fn measured(text: &str, name: MethodName) -> Recorder {
    let scenario = Scenario::parse(text).unwrap();
    let start = Start::new(&scenario).unwrap();
    measure::run(name, &scenario, &start).unwrap()
}

fn value(recorder: &Recorder, name: &str) -> f64 {
    let means = recorder.means();
    let found = means.iter().find(|(quantity, _)| quantity.name == name && quantity.of == "all");
    found.unwrap_or_else(|| panic!("no {name}")).1.value
}

/// In the steady state collisions take what the stress gives: loss = −γ̇ V P_xy. All of these are measured apart.
fn assert_loss_is_work_of_stress(text: &str, name: MethodName, tolerance: f64) {
    let recorder = measured(text, name);
    let volume = 250.0 * std::f64::consts::PI / 6.0 / 0.26;
    let work = -volume * value(&recorder, "stress xy");
    let loss = value(&recorder, "energy lost in contacts");
    assert!(work > 0.0 && (loss / work - 1.0).abs() < tolerance, "{loss} of {work}");
    // A flow along x that grows along y is no heat, and pushes nobody along z.
    let temperature = value(&recorder, "temperature");
    assert!(temperature < 5.0 && value(&recorder, "stress xz").abs() < 0.1 * work / volume);
    // Shear heats along the flow first.
    assert!(value(&recorder, "temperature x") > value(&recorder, "temperature z"));
}

#[test]
fn collisions_take_what_the_stress_gives() {
    assert_loss_is_work_of_stress(SHEARED, MethodName::Emd, 0.02);
}

/// The velocity grows along the gradient by the rate; what it does within a part of a profile is no heat.
#[test]
fn the_profile_is_a_straight_line() {
    let text = format!("{SHEARED}profile = {{ axis = \"y\", bins = 4 }}\n");
    let recorder = measured(&text.replace("duration = 40.0", "duration = 30.0"), MethodName::Emd);
    let tables = recorder.tables();
    let profile = tables.iter().find(|table| table.name == "profile").unwrap();
    let column = |head: &str| {
        let found = profile.columns.iter().position(|column| column.name.starts_with(head));
        let place = found.unwrap_or_else(|| panic!("{head} of {:?}", profile.columns));
        let number = |row: &Vec<Cell>| match row[place] {
            Cell::Number(x) => x,
            ref other => panic!("{other:?}"),
        };
        profile.rows.iter().map(number).collect::<Vec<f64>>()
    };
    let (place, velocity, heat) = (column("y"), column("velocity x"), column("temperature"));
    for ((y, v), t) in place.iter().zip(&velocity).zip(&heat) {
        assert!((v - y).abs() < 0.25, "{v} at {y}");
        assert!((t / value(&recorder, "temperature") - 1.0).abs() < 0.1, "{t} at {y}");
    }
}

#[test]
fn what_cannot_be_sheared_is_refused_and_named() {
    let said = |from: &str, to: &str| {
        assert!(SHEARED.contains(from));
        format!("{:#}", Scenario::parse(&SHEARED.replace(from, to)).unwrap_err())
    };
    let periodic = "x = { kind = \"periodic\" }";
    for (from, to, wanted) in [
        (periodic, "x = { kind = \"walls\", from = 0.0, to = 9.0 }", "box.x is not periodic"),
        ("gradient = \"y\"", "gradient = \"x\"", "box.shear.gradient is the axis of the flow"),
        ("rate = 1.0", "rate = inf", "box.shear.rate"),
        ("duration", "gravity = [0.0, -9.81, 0.0]\nduration", "gravity: a sheared box has none"),
        (
            "[observe]",
            "[[drive]]\nkind = \"turning-gravity\"\nmagnitude = 1.0\naxes = [\"x\", \"z\"]\nperiod = 1.0\n[observe]",
            "drive 0: a sheared box has no gravity",
        ),
    ] {
        let said = said(from, to);
        assert!(said.contains(wanted), "{said:?} for {wanted:?}");
    }
}

/// The numbers of a column of a table.
fn numbers(recorder: &Recorder, table: &str, head: &str) -> Vec<f64> {
    let tables = recorder.tables();
    let table = tables.iter().find(|found| found.name == table).unwrap();
    let place = table.columns.iter().position(|column| column.name == head).unwrap();
    let number = |row: &Vec<Cell>| match row[place] {
        Cell::Number(x) => x,
        ref other => panic!("{other:?}"),
    };
    table.rows.iter().map(number).collect()
}

/// No pair is nearer than a diameter, in whatever image: had images stood still, some across the sheared faces would be.
/// The virial says how many touch: for hard spheres P of contacts is 2π n² g(σ) σ³ T/3 (1 + ε)/2, here to 20 %, as g falls within
/// its first part and what touches is faster than the mean. Cells of neighbours give what all pairs give.
#[test]
fn pairs_across_sheared_faces_are_where_they_are() {
    let text = SHEARED.replace("duration = 40.0", "duration = 30.0");
    let with = |to: f64| {
        format!(
            "{text}correlations = {{ to = 2.0, points = 10 }}\n[observe.pair_distribution]\nto = {to}\nbins = 34\none_in = 5\n"
        )
    };
    // A third of the box or less is in cells.
    let [cells, pairs] = [1.7, 3.4].map(|to| measured(&with(to), MethodName::Emd));
    let near = numbers(&cells, "pair-distribution", "g");
    // 20 parts of 1 to a diameter.
    assert!(near[..20].iter().all(|g| *g == 0.0), "{near:?}");
    let volume = 250.0 * std::f64::consts::PI / 6.0 / 0.26;
    let density = 250.0 / volume;
    let temperature = value(&cells, "temperature");
    let contacts = value(&cells, "pressure") - density * temperature;
    let touching =
        contacts / (2.0 / 3.0 * std::f64::consts::PI * density.powi(2) * temperature * 0.95);
    assert!((near[20] / touching - 1.0).abs() < 0.2, "{} and {touching}", near[20]);
    let far = numbers(&pairs, "pair-distribution", "g");
    assert!(far[..10].iter().all(|g| *g == 0.0));
    for k in 10..17 {
        // Parts of twice the width have the mean of two.
        let shells = [2 * k, 2 * k + 1].map(|k| f64::from(3 * k * k + 3 * k + 1));
        let k = k as usize;
        let mean =
            (shells[0] * near[2 * k] + shells[1] * near[2 * k + 1]) / (shells[0] + shells[1]);
        assert!((far[k] / mean - 1.0).abs() < 1e-9, "{} and {mean}", far[k]);
    }
    // Across the flow grains diffuse nearly as in a gas at rest: Enskog's D is 3 T τ/(2 m), τ the mean free time.
    let diffusion = value(&cells, "diffusion coefficient");
    let free = value(&cells, "mean free time");
    let enskog = 1.5 * temperature * free;
    assert!((diffusion / enskog - 1.0).abs() < 0.35, "{diffusion} and {enskog}");
    let decays = numbers(&cells, "correlations", "velocity autocorrelation [m2/s2]");
    assert!(decays[0] > 0.0 && decays[10].abs() < 0.1 * decays[0], "{decays:?}");
}

#[test]
fn soft_grains_take_it_too() {
    let soft = SHEARED
        .replace(
            "kind = \"constant\"\nrestitution = 0.9",
            "kind = \"lsd\"\nstiffness = 2e4\ndamping = 8.0",
        )
        .replace("methods = [\"emd\"]", "methods = [\"emd*\"]\noptions = { enduring = \"paper\" }")
        .replace("duration = 40.0", "duration = 20.0");
    assert_loss_is_work_of_stress(&soft, MethodName::EmdStar, 0.03);
}
