//! Are grains placed clear of obstacles, and outside of solid ones? Scenarios from text; distances and solid angles computed in `geometry.rs`.

mod geometry;
mod rays;

use carom_host::method;
use carom_host::scenario::{MethodName, Placed, Scenario, Start};
use geometry::{Point, distance, dot, minus, winding};
use proptest::prelude::*;
use std::fmt::Write;
use std::path::Path;

fn facets(start: &Start) -> impl Iterator<Item = &[Point]> {
    start.walls.iter().map(|wall| &wall.corners[..])
}

/// The smallest gap of a grain and a facet, over its radius.
fn smallest_gap(start: &Start) -> f64 {
    let gap = |grain: &Placed| {
        let nearest = facets(start).map(|facet| distance(facet, grain.position));
        nearest.fold(f64::INFINITY, f64::min) / grain.radius - 1.0
    };
    start.grains.iter().map(gap).fold(f64::INFINITY, f64::min)
}

/// The smallest gap of two grains, over the radius of one.
fn smallest_gap_of_two(start: &Start) -> f64 {
    let mut smallest = f64::INFINITY;
    for (i, a) in start.grains.iter().enumerate() {
        for b in &start.grains[..i] {
            let way = minus(a.position, b.position);
            smallest = smallest.min((dot(way, way).sqrt() - a.radius - b.radius) / a.radius);
        }
    }
    smallest
}

fn started(text: &str, folder: &Path) -> (Scenario, Start) {
    let scenario = Scenario::parse_in(text, folder).expect("a good scenario");
    let start = Start::new(&scenario).unwrap_or_else(|why| panic!("{why:#}\n{text}"));
    (scenario, start)
}

/// It begins and runs for a short time; returns the start.
fn runs(text: &str, folder: &Path) -> Start {
    let (scenario, start) = started(text, folder);
    let ran = method::with(MethodName::Emd, &scenario, &start, |method| method.advance_to(1e-3));
    ran.unwrap_or_else(|why| panic!("{why:#}\n{text}"));
    start
}

fn refused(text: &str) -> String {
    let scenario = Scenario::parse(text).expect("a good scenario");
    format!("{:#}", Start::new(&scenario).expect_err("it cannot be placed"))
}

/// A box of side 1 with walls.
fn boxed(dimension: usize, more: &str) -> String {
    let mut text = format!(
        "dimension = {dimension}\nduration = 1e-3\nsample = 1e-3\ngravity = [{}-9.81]\n\
         [law]\nkind = \"constant\"\nrestitution = 0.9\n[box]\n",
        "0.0, ".repeat(dimension - 1)
    );
    for axis in ["x", "y", "z"].iter().take(dimension) {
        writeln!(text, "{axis} = {{ kind = \"walls\", from = 0.0, to = 1.0 }}").unwrap();
    }
    text + more
}

fn species(count: usize, radius: f64, more: &str) -> String {
    format!(
        "\n[[species]]\ncount = {count}\nradius = {radius}\ndensity = 2500.0\nthermal_speed = 0.1\n{more}\n"
    )
}

/// A star of five points whose sides cross each other: its middle is wound round twice.
const STAR: &str = "\n[[obstacle]]\npolygon = [[0.5, 0.9], [0.735, 0.176], [0.12, 0.624], [0.88, 0.624], [0.265, 0.176]]\n";

/// A sphere of triangles as OBJ says it, its triangles turned as said, and a cube inside of it, turned the other way.
fn ball(name: &Path, turned: impl Fn(usize) -> bool) {
    let (rows, columns) = (12, 24);
    let mut text = String::from("v 0 0 1\nv 0 0 -1\n");
    for row in 1..rows {
        let polar = std::f64::consts::PI * f64::from(row) / f64::from(rows);
        for column in 0..columns {
            let angle = std::f64::consts::TAU * f64::from(column) / f64::from(columns);
            let (x, y) = (polar.sin() * angle.cos(), polar.sin() * angle.sin());
            writeln!(text, "v {x} {y} {}", polar.cos()).unwrap();
        }
    }
    let at = |row: i32, column: i32| 3 + (row - 1) * columns + column.rem_euclid(columns);
    let mut faces = Vec::new();
    for column in 0..columns {
        faces.push([1, at(1, column), at(1, column + 1)]);
        faces.push([2, at(rows - 1, column + 1), at(rows - 1, column)]);
        for row in 1..rows - 1 {
            faces.push([at(row, column), at(row + 1, column), at(row + 1, column + 1)]);
            faces.push([at(row, column), at(row + 1, column + 1), at(row, column + 1)]);
        }
    }
    for (number, [a, b, c]) in faces.into_iter().enumerate() {
        let [b, c] = if turned(number) { [c, b] } else { [b, c] };
        writeln!(text, "f {a} {b} {c}").unwrap();
    }
    std::fs::write(name, text).unwrap();
}

#[test]
fn grains_fill_the_room_around_a_polygon() {
    for (solid, inside) in [("", true), ("solid = true\n", false)] {
        let start =
            runs(&boxed(2, &format!("{STAR}{solid}{}", species(150, 0.012, ""))), Path::new(""));
        assert_eq!(start.grains.len(), 150);
        assert!(smallest_gap(&start) >= 0.0 && smallest_gap_of_two(&start) >= 0.0);
        let within =
            start.grains.iter().filter(|g| winding(facets(&start), g.position).abs() > 0.5);
        assert_eq!(within.count() > 0, inside, "solid: {solid:?}");
    }
}

#[test]
fn grains_fill_the_room_around_a_solid_mesh() {
    let folder = tempfile::tempdir().unwrap();
    ball(&folder.path().join("ball.obj"), |_| false);
    ball(&folder.path().join("inwards.obj"), |_| true);
    ball(&folder.path().join("unlike.obj"), |number| number % 3 == 1);
    let inside = |file: &str, solid: bool| {
        let mesh = format!(
            "\n[[obstacle]]\nfile = {file:?}\nunit = 0.42\nat = [0.5, 0.5, 0.5]\nsolid = {solid}\n"
        );
        let start = runs(&boxed(3, &(mesh + &species(250, 0.025, ""))), folder.path());
        assert_eq!(start.grains.len(), 250);
        assert!(smallest_gap(&start) >= 0.0 && smallest_gap_of_two(&start) >= 0.0);
        let of_centre = |grain: &&Placed| {
            let from = minus(grain.position, [0.5; 3]);
            dot(from, from).sqrt() < 0.4
        };
        start.grains.iter().filter(of_centre).count()
    };
    for file in ["ball.obj", "inwards.obj", "unlike.obj"] {
        assert_eq!(inside(file, true), 0, "{file}");
    }
    assert!(inside("ball.obj", false) > 0);
}

#[test]
fn a_hollow_that_is_turned_the_other_way_is_room() {
    let cube = |low: f64, high: f64, hollow: bool| {
        let mut text = String::new();
        let corner =
            |k: usize| [k & 1, k >> 1 & 1, k >> 2].map(|bit| if bit == 0 { low } else { high });
        let sides =
            [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        for [a, b, c, d] in sides {
            for [a, b, c] in [[a, b, c], [a, c, d]] {
                let [b, c] = if hollow { [c, b] } else { [b, c] };
                write!(text, "{:?}, ", [a, b, c].map(corner)).unwrap();
            }
        }
        text
    };
    let text = |hollow| {
        let both = format!("{}{}", cube(0.1, 0.9, false), cube(0.2, 0.8, hollow));
        let obstacle = format!("\n[[obstacle]]\ntriangles = [{both}]\nsolid = true\n");
        let place =
            "place = { kind = \"fill\", from = [0.15, 0.15, 0.15], to = [0.85, 0.85, 0.85] }";
        boxed(3, &(obstacle + &species(20, 0.03, place)))
    };
    let start = runs(&text(true), Path::new(""));
    assert!(
        start.grains.iter().all(|grain| grain.position.iter().all(|x| (0.23..=0.77).contains(x)))
    );
    assert!(refused(&text(false)).contains("no place clear of obstacles found for grain 0"));
}

#[test]
fn dense_grains_grow_around_obstacles() {
    // A third of the square is taken, and grains are to fill 45 % of it.
    let wedge = "\n[[obstacle]]\npolygon = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.66]]\nsolid = true\n";
    let start = runs(&boxed(2, &format!("{wedge}{}", species(360, 0.02, ""))), Path::new(""));
    assert!(smallest_gap(&start) >= 0.0 && smallest_gap_of_two(&start) >= 0.0);
    assert!(start.grains.iter().all(|g| winding(facets(&start), g.position).abs() < 0.5));
    let folder = tempfile::tempdir().unwrap();
    ball(&folder.path().join("ball.obj"), |_| false);
    let mesh =
        "\n[[obstacle]]\nfile = \"ball.obj\"\nunit = 0.4\nat = [0.5, 0.5, 0.5]\nsolid = true\n";
    // 0.27 of the cube is taken, and grains are to fill 36 % of it.
    let start = runs(&boxed(3, &format!("{mesh}{}", species(400, 0.06, ""))), folder.path());
    assert!(smallest_gap(&start) >= 0.0 && smallest_gap_of_two(&start) >= 0.0);
    assert!(start.grains.iter().all(|g| winding(facets(&start), g.position).abs() < 0.5));
}

#[test]
fn lattice_layer_and_pile_leave_out_what_is_not_clear() {
    let bar = "\n[[obstacle]]\npolygon = [[0.3, 0.02], [0.7, 0.02], [0.6, 0.1], [0.4, 0.1]]\nsolid = true\n";
    for place in [
        "place = { kind = \"lattice\" }",
        "place = { kind = \"lattice\", lattice = \"cubic\" }",
        "place = { kind = \"layer\" }",
        "place = { kind = \"pile\" }",
    ] {
        let start = runs(&boxed(2, &format!("{bar}{}", species(120, 0.02, place))), Path::new(""));
        assert_eq!(start.grains.len(), 120);
        assert!(smallest_gap(&start) >= 0.0, "{place}: {}", smallest_gap(&start));
        assert!(start.grains.iter().all(|g| winding(facets(&start), g.position).abs() < 0.5));
    }
    let all = "\n[[obstacle]]\npolygon = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]\nsolid = true\n";
    let why =
        refused(&boxed(2, &format!("{all}{}", species(9, 0.02, "place = { kind = \"lattice\" }"))));
    assert_eq!(why, "species 0: 9 grains do not fit, found 0 places clear of obstacles");
    let why = refused(&boxed(2, &format!("{all}{}", species(9, 0.02, ""))));
    assert_eq!(why, "species 0: no place clear of obstacles found for grain 0 in 20000 tries");
}

#[test]
fn an_hourglass_is_filled_down_its_slopes() {
    let text = include_str!("../../scenarios/hourglass.toml");
    let region = "from = [-8e-3, 10e-3], to = [8e-3, 23e-3]";
    assert!(text.contains(region));
    let text = text.replace(region, "from = [-9e-3, 0.0], to = [9e-3, 24e-3]");
    let start = runs(&text, Path::new(""));
    assert!(smallest_gap(&start) >= 0.0);
    assert!(start.grains.iter().any(|grain| grain.position[1] < 10e-3));
}

#[test]
fn what_moves_is_where_it_begins() {
    // It swings from 0.5, and begins a quarter of a turn later at 0.75.
    let bar = "\n[[obstacle]]\nchain = [[0.0, 0.5], [1.0, 0.5]]\nvibration = { amplitude = [0.0, 0.25], frequency = 1.0, phase = 0.25 }\n";
    let start = runs(&boxed(2, &format!("{bar}{}", species(200, 0.012, ""))), Path::new(""));
    let gap = |height: f64| {
        let away = |grain: &Placed| (grain.position[1] - height).abs() - grain.radius;
        start.grains.iter().map(away).fold(f64::INFINITY, f64::min)
    };
    assert!(gap(0.75) >= 0.0 && gap(0.5) < 0.0);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    /// Whatever is placed starts, and is clear of obstacles.
    #[test]
    fn what_is_placed_starts(
        seed in 0_u32..1_000_000,
        corners in prop::collection::vec((0.05..0.95, 0.05..0.95), 3..8),
        kind in 0_usize..5,
        solid: bool,
        count in 1_usize..360,
        shift in prop::sample::select(vec![0.0_f64, 1e3, -1e6]),
    ) {
        let place = ["fill", "lattice", "layer", "pile", "gas"][kind];
        let polygon: Vec<[f64; 2]> = corners.into_iter().map(|(x, y)| [x + shift, y]).collect();
        let text = boxed(2, &format!("\n[[obstacle]]\npolygon = {polygon:?}\nsolid = {solid}\n"))
            .replace("x = { kind = \"walls\", from = 0.0, to = 1.0 }",
                &format!("x = {{ kind = \"walls\", from = {shift:?}, to = {:?} }}", shift + 1.0));
        let grains = match place {
            "gas" => format!("\n[gas]\ncount = {count}\nradius = [0.01, 0.02]\ndensity = 1.0\nthermal_speed = 0.1\nseed = {seed}\n"),
            _ => species(count, 0.02, &format!("place = {{ kind = {place:?} }}")),
        };
        let text = format!("seed = {seed}\n{text}{grains}");
        let scenario = Scenario::parse(&text).unwrap();
        if let Ok(start) = Start::new(&scenario) {
            runs(&text, Path::new(""));
            prop_assert!(smallest_gap(&start) >= -1e-6 * shift.abs().max(1e-6));
        } else {
            // Fill finds a place for so few grains wherever they fit.
            prop_assert!(place != "fill" && place != "gas" || count > 60, "{}", text);
        }
    }
}
