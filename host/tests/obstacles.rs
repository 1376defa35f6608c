//! Do scenarios have obstacles? Polygons and chains, triangles and files; how they move; pictures.

mod meshes;

use carom_host::scenario::{MethodName, Scenario, Start};
use carom_host::{method, plot};
use meshes::{FACES, OBJ, in_room, stl_binary, stl_text};
use std::fs;
use std::path::Path;

/// The positions of all grains at the end.
fn end(text: &str, folder: &Path) -> Vec<[f64; 3]> {
    let scenario = Scenario::parse_in(text, folder).unwrap();
    let start = Start::new(&scenario).unwrap();
    method::with(MethodName::Emd, &scenario, &start, |method| {
        method.advance_to(scenario.duration.unwrap())?;
        Ok(method.grains().iter().map(|grain| grain.position).collect())
    })
    .unwrap()
}

#[test]
fn a_mesh_is_the_same_from_text_and_bytes_and_obj() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    fs::write(at.join("text.stl"), stl_text(&FACES)).unwrap();
    fs::write(at.join("bytes.stl"), stl_binary(&FACES)).unwrap();
    fs::write(at.join("room.obj"), OBJ).unwrap();
    let ends = ["text.stl", "bytes.stl", "room.obj"].map(|file| end(&in_room(file, ""), at));
    assert_eq!(ends[0], ends[1]);
    assert_eq!(ends[0], ends[2]);
    let [x, y, z] = ends[0][0];
    assert!(x > 0.0 && y > 0.0 && z > 0.0 && x + y + z < 1.0, "{ends:?}");
    // Displaced by a metre, with the grain outside, nothing is met.
    let free = end(&in_room("text.stl", "at = [5.0, 5.0, 5.0]"), at);
    assert!((free[0][0] - 2.2).abs() < 1e-12, "{free:?}");
}

#[test]
fn the_hourglass_runs_down() {
    let scenario = Scenario::parse(include_str!("../scenarios/hourglass.toml")).unwrap();
    let start = Start::new(&scenario).unwrap();
    assert_eq!(start.walls.len(), 10);
    assert!(start.grains.iter().all(|grain| grain.position[1] > 0.0));
    let below = method::with(MethodName::Emd, &scenario, &start, |method| {
        method.advance_to(0.3)?;
        Ok(method.grains().iter().filter(|grain| grain.position[1] < 0.0).count())
    });
    assert_eq!(below.unwrap(), 64);
}

/// How many lines of the colour of obstacles there are in an SVG document.
fn walls_in(svg: &str) -> usize {
    svg.lines().filter(|line| line.contains("stroke=\"#554a40\"")).count()
}

#[test]
fn pictures_show_obstacles() {
    let scenario = Scenario::parse(include_str!("../scenarios/hourglass.toml")).unwrap();
    let start = Start::new(&scenario).unwrap();
    let svg = plot::svg(&plot::grains(&start, &start.grains, "")).unwrap();
    assert_eq!(walls_in(&svg), 10);
    // Its lower left corner is at 3 % of what is seen, from the left and from below.
    let first = svg.lines().find(|line| line.contains("#554a40")).unwrap();
    let [x, y] = [start.walls[0].corners[0], start.walls[0].corners[1]].map(|c| c[0]);
    let drawn = |x: f64| 58.0 + 420.0 * (x + 9e-3 * 1.06) / (48e-3 * 1.06);
    assert!(first.contains(&format!("M{:.2} ", drawn(x))), "{first}, not {}", drawn(x));
    assert!(first.contains(&format!("L{:.2} ", drawn(y))), "{first}, not {}", drawn(y));
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("room.obj"), OBJ).unwrap();
    let scenario = Scenario::parse_in(&in_room("room.obj", ""), folder.path()).unwrap();
    let start = Start::new(&scenario).unwrap();
    let svg = plot::svg(&plot::grains(&start, &start.grains, "")).unwrap();
    assert_eq!(walls_in(&svg), 4);
}

#[test]
fn pictures_show_a_frame_of_a_trajectory() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("emd.xyz");
    let frame =
        |x: f64| format!("1\nProperties=species:S:1:pos:R:3:radius:R:1\nsand {x} 0.004 0.0 5e-4\n");
    fs::write(&file, frame(0.0) + &frame(1e-3)).unwrap();
    let scenario = Scenario::parse(include_str!("../scenarios/hourglass.toml")).unwrap();
    let start = Start::new(&scenario).unwrap();
    let of =
        |frame| start.clone().with_grains_of(&file, frame).map(|start| start.grains[0].position[0]);
    assert_eq!((of(None).unwrap(), of(Some(0)).unwrap()), (1e-3, 0.0));
    assert!(
        format!("{:#}", of(Some(2)).unwrap_err())
            .contains("there is no frame 2, the last one is 1")
    );
    fs::write(&file, "1\n\nsand 0.0 0.0 0.0\n").unwrap();
    let error = format!("{:#}", of(None).unwrap_err());
    assert!(error.contains("emd.xyz: the radius of grain 0 is none, must be above 0"), "{error}");
}

#[test]
fn a_room_turns_as_a_scenario_says() {
    let room = "dimension = 2\nduration = 50.0\nsample = 1.0\n[law]\nkind = \"constant\"\nrestitution = 1.0\n\
        [[obstacle]]\npolygon = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]\nrestitution = 1.0\n\
        rotation = { centre = [0.1, 0.2], angular_velocity = [0.7] }\n\
        [[grain]]\nradius = 0.1\nmass = 1.0\nat = [0.2, 0.1]\nmoving = [0.8, 0.3]\n";
    let scenario = Scenario::parse_in(room, Path::new(".")).unwrap();
    let start = Start::new(&scenario).unwrap();
    // E − ω L is what such a room keeps (Jacobi's integral).
    let jacobi = |[x, y]: [f64; 2], [u, v]: [f64; 2]| {
        0.5 * (u * u + v * v) - 0.7 * ((x - 0.1) * v - (y - 0.2) * u)
    };
    let end = method::with(MethodName::Emd, &scenario, &start, |method| {
        method.advance_to(50.0)?;
        Ok(method.grains()[0])
    })
    .unwrap();
    let [x, y, _] = end.position;
    let [u, v, _] = end.velocity;
    assert!((jacobi([x, y], [u, v]) - jacobi([0.2, 0.1], [0.8, 0.3])).abs() < 1e-11);
    assert!((u - 0.8).abs() > 1e-3);
}
