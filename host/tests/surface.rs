//! Are the waves on a layer found? Makes layers with a known surface, and shakes one; compares amplitude, wavelength and rhythm.

use carom_host::columns::Cell;
use carom_host::measure;
use carom_host::observe::Recorder;
use carom_host::scenario::{MethodName, Placed, Scenario, Start};
use std::f64::consts::TAU;

/// A layer on a plate that vibrates once in a second, looked at four times.
const LAYER: &str = r#"
dimension = 2
gravity = [0.0, -1.0]
duration = 100.0
sample = 100.0
methods = ["emd"]
[box]
x = { kind = "periodic", from = 2.0, to = 34.0 }
y = { kind = "plate", at = -1.0, amplitude = 0.1, frequency = 1.0, surface = "hard", restitution = 0.7 }
[law]
kind = "constant"
restitution = 0.7
[[grain]]
radius = 0.001
mass = 1.0
at = [8.0, 8.0]
[observe]
every = 0.25
[observe.surface]
place = 0.5
"#;

/// Centres that fill everything from the plate to this height evenly, 40 at each of 640 places (in three dimensions of 64
/// by 16), and a few that fly high above.
fn fill(start: &mut Start, height: impl Fn(f64, f64) -> f64) {
    let grain = |position| Placed { radius: 0.001, mass: 1.0, position, velocity: [0.0; 3] };
    start.grains.clear();
    let columns = if start.dimension == 2 { [640, 1] } else { [64, 16] };
    for column in 0..columns[0] * columns[1] {
        let x = 2.0 + 32.0 * ((column % columns[0]) as f64 + 0.5) / columns[0] as f64;
        let z = 8.0 * ((column / columns[0]) as f64 + 0.5) / columns[1] as f64;
        let top = height(x - 2.0, z) + 1.0;
        let (up, across) = if start.dimension == 2 { (1, 2) } else { (2, 1) };
        let mut place = [0.0; 3];
        (place[0], place[across]) = (x, if start.dimension == 2 { 0.0 } else { z });
        // Columns do not have the same heights: ten of them fill a place evenly.
        let shift = ((column % 10) as f64 + 0.5) / 10.0;
        for k in 0..40 {
            place[up] = -1.0 + top * (f64::from(k) + shift) / 40.0;
            start.grains.push(grain(place));
        }
        if column % 10 == 0 {
            place[up] = 90.0;
            start.grains.push(grain(place));
        }
    }
    start.species = vec![0; start.grains.len()];
}

/// What is measured where the surface goes on as a list of heights over the places.
fn seen(text: &str, surfaces: &[&dyn Fn(f64, f64) -> f64]) -> Recorder {
    let scenario = Scenario::parse(text).unwrap();
    let mut start = Start::new(&scenario).unwrap();
    fill(&mut start, |_, _| 3.0);
    let mut recorder = Recorder::new(&scenario, &start, None).unwrap().unwrap();
    for (look, surface) in surfaces.iter().enumerate() {
        fill(&mut start, surface);
        recorder.look(0.25 * look as f64, &[], &start.grains);
    }
    recorder
}

fn value(recorder: &Recorder, name: &str) -> f64 {
    let means = recorder.means();
    let found = means.iter().find(|(quantity, _)| quantity.name == name);
    found.unwrap_or_else(|| panic!("no {name}")).1.value
}

fn is_near(value: f64, wanted: f64, tolerance: f64) {
    assert!((value / wanted - 1.0).abs() < tolerance, "{value}, not {wanted}");
}

/// Three waves of 0.5 on 4, and a shorter one of 0.2. Those that fly above, one of 401, are worth 0.25 % of the height.
#[test]
fn a_standing_wave_has_its_amplitude_and_length() {
    let wave = |x: f64, _: f64| {
        3.0 + 0.5 * libm::cos(TAU * 3.0 * x / 32.0 + 0.7) + 0.2 * libm::sin(TAU * 5.0 * x / 32.0)
    };
    let recorder = seen(LAYER, &[&wave, &wave, &wave]);
    is_near(value(&recorder, "surface mode wavelength"), 32.0 / 3.0, 1e-12);
    is_near(value(&recorder, "surface mode amplitude"), 0.5, 0.01);
    is_near(value(&recorder, "surface height"), 3.0, 0.01);
    // The mean of centres is in the middle.
    let mean = LAYER.replace("place = 0.5", "place = 0.5\nheight = \"mean\"");
    let recorder = seen(&mean, &[&wave, &wave]);
    // One in 401 is at 90.
    let thrown = 400.0 / 401.0;
    is_near(value(&recorder, "surface mode amplitude"), 0.25 * thrown, 0.005);
    let table = &recorder.tables().into_iter().find(|table| table.name == "surface").unwrap();
    let column = |name: &str| table.columns.iter().position(|column| column.name == name).unwrap();
    let (waves, amplitude) = (column("waves along x"), column("amplitude [m]"));
    let number = |cell: &Cell| match cell {
        Cell::Number(number) => *number,
        _ => f64::NAN,
    };
    let fifth = table.rows.iter().find(|row| number(&row[waves]) == 5.0).unwrap();
    is_near(number(&fifth[amplitude]), 0.1 * thrown, 0.01);
    assert_eq!(table.rows.len(), 16);
}

/// What is upside down after each cycle of four looks is told apart from what stays.
#[test]
fn waves_of_half_the_frequency_are_told_apart() {
    let still = |x: f64, z: f64| 3.0 + 0.4 * libm::cos(TAU * x / 32.0) + 0.0 * z;
    let up = |x: f64, z: f64| still(x, z) + 0.3 * libm::cos(TAU * 2.0 * x / 32.0);
    let down = |x: f64, z: f64| still(x, z) - 0.3 * libm::cos(TAU * 2.0 * x / 32.0);
    let course: Vec<&dyn Fn(f64, f64) -> f64> = (0..17)
        .map(|look| if look / 4 % 2 == 0 { &up as &dyn Fn(f64, f64) -> f64 } else { &down })
        .collect();
    let recorder = seen(LAYER, &course);
    is_near(value(&recorder, "surface mode wavelength"), 32.0, 1e-12);
    is_near(value(&recorder, "surface mode amplitude"), 0.4, 0.005);
    is_near(value(&recorder, "surface mode wavelength, half frequency"), 16.0, 1e-12);
    is_near(value(&recorder, "surface mode amplitude, half frequency"), 0.3, 0.005);
    // Between two looks that do not come a whole number of times in a cycle there is no such thing.
    let recorder = seen(&LAYER.replace("every = 0.25", "every = 0.3"), &course);
    assert!(!recorder.means().iter().any(|(quantity, _)| quantity.name.contains("half")));
}

/// Between walls a crest may stand at the wall: half waves, too. In three dimensions waves run in any direction.
#[test]
fn walls_and_three_dimensions() {
    let walled = LAYER.replace("kind = \"periodic\"", "kind = \"walls\"");
    let slosh = |x: f64, _: f64| 3.0 + 0.5 * libm::cos(TAU * 1.5 * x / 32.0);
    let recorder = seen(&walled, &[&slosh, &slosh]);
    is_near(value(&recorder, "surface mode wavelength"), 64.0 / 3.0, 1e-12);
    is_near(value(&recorder, "surface mode amplitude"), 0.5, 0.005);
    let solid = LAYER
        .replace("dimension = 2", "dimension = 3")
        .replace("[0.0, -1.0]", "[0.0, 0.0, -1.0]")
        .replace("[8.0, 8.0]", "[8.0, 4.0, 8.0]")
        .replace("y = {", "y = { kind = \"periodic\", from = 0.0, to = 8.0 }\nz = {");
    let oblique = |x: f64, y: f64| 3.0 + 0.5 * libm::cos(TAU * (3.0 * x / 32.0 - y / 8.0) + 0.3);
    let recorder = seen(&solid, &[&oblique, &oblique]);
    let wavelength = 1.0 / libm::hypot(3.0 / 32.0, 1.0 / 8.0);
    is_near(value(&recorder, "surface mode wavelength"), wavelength, 1e-12);
    is_near(value(&recorder, "surface mode amplitude"), 0.5, 0.005);
    let edge = solid.replace("y = { kind = \"periodic\"", "y = { kind = \"walls\"");
    let corner = |x: f64, y: f64| {
        3.0 + 0.5 * libm::cos(TAU * 2.0 * x / 32.0 + 0.4) * libm::cos(TAU * 0.5 * y / 8.0)
    };
    let recorder = seen(&edge, &[&corner, &corner]);
    is_near(
        value(&recorder, "surface mode wavelength"),
        1.0 / libm::hypot(1.0 / 16.0, 1.0 / 16.0),
        1e-12,
    );
    is_near(value(&recorder, "surface mode amplitude"), 0.5, 0.005);
}

#[test]
fn where_there_is_no_surface_it_is_said() {
    for (old, new, wanted) in [
        ("place = 0.5", "up = \"z\"", "observe.surface.up is z, but dimension is 2"),
        (
            "place = 0.5",
            "up = \"x\"",
            "observe.surface.up is x, but box.x has no plate or lower wall",
        ),
        ("place = 0.5", "place = 0.0", "observe.surface.place is 0, must be above 0"),
        ("place = 0.5", "place = 1e-9", "observe.surface.place is 1e-9, must be at least 0.032"),
        ("place = 0.5", "place = 20.0", "observe.surface.place: no axis has four places"),
        (
            "x = { kind = \"periodic\", from = 2.0, to = 34.0 }",
            "",
            "box.x is open, must be periodic",
        ),
        ("place = 0.5", "height = \"low\"", "unknown variant `low`"),
        ("y = {", "z = {", "dimension is 2"),
    ] {
        assert!(LAYER.contains(old));
        let said = Scenario::parse(&LAYER.replace(old, new)).and_then(|scenario| {
            let start = Start::new(&scenario)?;
            Recorder::new(&scenario, &start, None)
        });
        let said = format!("{:#}", said.unwrap_err());
        assert!(said.contains(wanted), "{new}: {said}");
    }
}

/// The layer of `carom figure faraday`, whose stripes are 64/3 diameters long and 3.39 high from trough to crest, by a
/// scenario: the root mean square of a wave that swings evenly is its amplitude over √2.
#[test]
#[ignore = "minutes in release"]
fn faradays_waves_are_seen_in_a_scenario() {
    let frequency = 0.4174 / 5.4_f64.sqrt();
    let text = {
        let amplitude = 2.5 / (TAU * frequency).powi(2);
        format!(
            "dimension = 3\ngravity = [0.0, 0.0, -1.0]\nduration = {:?}\nsample = 1000.0\nseed = 1\nmethods = [\"emd\"]\n\
             law = {{ kind = \"constant\", restitution = 0.7 }}\n\
             [box]\nx = {{ kind = \"periodic\", from = 0.0, to = 64.0 }}\n\
             y = {{ kind = \"periodic\", from = 0.0, to = 5.0 }}\n\
             z = {{ kind = \"plate\", at = 0.0, amplitude = {amplitude:?}, frequency = {frequency:?}, restitution = 0.7 }}\n\
             [[species]]\ncount = 1920\nradius = 0.5\ndensity = 1.909859317102744\nthermal_speed = 0.08\n\
             place = {{ kind = \"layer\" }}\n\
             [observe]\nfrom = {:?}\nevery = {:?}\n[observe.surface]\nplace = 2.0\nheight = \"mean\"\n",
            32.0 / frequency,
            23.0 / frequency,
            0.125 / frequency
        )
    };
    let scenario = Scenario::parse(&text).unwrap();
    let start = Start::new(&scenario).unwrap();
    let recorder = measure::run(MethodName::Emd, &scenario, &start).unwrap();
    let [wavelength, amplitude] = ["wavelength", "amplitude"]
        .map(|what| value(&recorder, &format!("surface mode {what}, half frequency")));
    println!("wavelength {wavelength} d, amplitude {amplitude} d");
    is_near(wavelength, 64.0 / 3.0, 1e-9);
    is_near(2.0 * 2.0_f64.sqrt() * amplitude, 3.39, 0.15);
}
