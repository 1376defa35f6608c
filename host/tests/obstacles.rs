//! Do scenarios have obstacles? Polygons and chains, triangles and files; what is refused, and with which words; pictures.

use carom_host::scenario::{MethodName, Scenario, Start};
use carom_host::{method, plot};
use std::fs;
use std::path::Path;

/// A tetrahedron of edges about one long, as STL says it.
const FACES: [[[f64; 3]; 3]; 4] = {
    const A: [f64; 3] = [0.0, 0.0, 0.0];
    const B: [f64; 3] = [1000.0, 0.0, 0.0];
    const C: [f64; 3] = [0.0, 1000.0, 0.0];
    const D: [f64; 3] = [0.0, 0.0, 1000.0];
    [[A, C, B], [A, B, D], [B, C, D], [C, A, D]]
};

fn stl_text(faces: &[[[f64; 3]; 3]]) -> String {
    let mut text = "solid test\n".to_owned();
    for face in faces {
        text += "facet normal 0 0 0\nouter loop\n";
        for [x, y, z] in face {
            text += &format!("vertex {x} {y} {z}\n");
        }
        text += "endloop\nendfacet\n";
    }
    text + "endsolid test\n"
}

fn stl_binary(faces: &[[[f64; 3]; 3]]) -> Vec<u8> {
    let mut bytes = vec![0; 80];
    bytes.extend((faces.len() as u32).to_le_bytes());
    for face in faces {
        bytes.extend([0; 12]);
        bytes.extend(face.iter().flatten().flat_map(|x| (*x as f32).to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

const OBJ: &str =
    "v 0 0 0\nv 1000 0 0\nv 0 1000 0\nv 0 0 1000\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

/// A ball in a room that a file says, in millimetres.
fn in_room(file: &str, more: &str) -> String {
    format!(
        "dimension = 3\nduration = 2.0\nsample = 1.0\n[law]\nkind = \"constant\"\nrestitution = 1.0\n\
         [[obstacle]]\nfile = {file:?}\nunit = 1e-3\nclosed = true\nrestitution = 1.0\n{more}\n\
         [[grain]]\nradius = 0.05\nmass = 1.0\nat = [0.2, 0.2, 0.2]\nmoving = [1.0, 0.3, -0.7]\n"
    )
}

fn started(text: &str, folder: &Path) -> Result<Start, String> {
    let scenario = Scenario::parse_in(text, folder).map_err(|why| format!("{why:#}"))?;
    Start::new(&scenario).map_err(|why| format!("{why:#}"))
}

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
fn what_is_wrong_with_a_mesh_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let refused = |name: &str, bytes: &[u8]| {
        fs::write(at.join(name), bytes).unwrap();
        started(&in_room(name, ""), at).unwrap_err()
    };
    let hole = refused("hole.stl", stl_text(&FACES[..3]).as_bytes());
    assert!(hole.contains("hole.stl") && hole.contains("there is a hole"), "{hole}");
    let mut flat = FACES;
    flat[1][2] = flat[1][0];
    let flat = refused("flat.stl", stl_text(&flat).as_bytes());
    assert!(flat.contains("flat.stl: facet 1 of 4 has no length or area"), "{flat}");
    let mut nan = FACES;
    nan[2][0][1] = f64::NAN;
    let nan = refused("nan.stl", &stl_binary(&nan));
    assert!(nan.contains("nan.stl: triangle 2 has a corner at NaN"), "{nan}");
    let noise = refused("noise.stl", b"solid nothing here");
    assert!(noise.contains("noise.stl"), "{noise}");
    let other = refused("room.step", b"");
    assert!(other.contains("its name must end in .stl or .obj"), "{other}");
    let missing = started(&in_room("missing.stl", ""), at).unwrap_err();
    assert!(missing.contains("cannot read") && missing.contains("missing.stl"), "{missing}");
}

#[test]
fn what_is_wrong_with_the_fields_is_named() {
    let text = |obstacle: &str, more: &str| {
        format!(
            "dimension = 2\nduration = 1.0\nsample = 1.0\n{more}\n[law]\nkind = \"constant\"\nrestitution = 1.0\n\
             [[obstacle]]\n{obstacle}\n\
             [[grain]]\nradius = 0.1\nmass = 1.0\nat = [0.5, 0.5]\n"
        )
    };
    let refused = |obstacle: &str, more: &str| {
        Scenario::parse(&text(obstacle, more)).unwrap_err().to_string()
    };
    let cases = [
        ("", "", "give one of polygon, chain, triangles and file"),
        ("chain = [[0.0, 0.0]]", "", "must have at least 2"),
        ("polygon = [[0.0, 0.0], [1.0, 0.0], [1.0]]", "", "has 1 numbers, must have 2"),
        ("file = \"room.stl\"", "", "needs dimension 3, but it is 2"),
        ("chain = [[0.0, 0.0], [1.0, 0.0]]\nrestitution = 1.5", "", "must be from 0 to 1"),
        ("chain = [[0.0, 0.0], [1.0, 0.0]]\nclosed = true", "", "only meshes have holes"),
        ("chain = [[0.0, 0.0], [1.0, 0.0]]\nmaterial = \"tin\"", "", "tin"),
        ("chain = [[0.0, 0.0], [1.0, 0.0]]", "methods = [\"emd*\", \"md\"]", "md"),
        (
            "chain = [[0.0, 0.0], [1.0, 0.0]]",
            "box = { x = { kind = \"periodic\", from = 0.0, to = 9.0 } }",
            "box.x is periodic, but there is [[obstacle]]",
        ),
    ];
    for (obstacle, more, wanted) in cases {
        let said = refused(obstacle, more);
        assert!(said.to_lowercase().contains(wanted), "{said}, not {wanted}");
    }
    // A grain in a wall: grain and facet are named.
    let scenario = Scenario::parse(&text("chain = [[0.45, 0.0], [0.45, 1.0]]", "")).unwrap();
    let start = Start::new(&scenario).unwrap();
    let begun = method::begin(MethodName::Emd, &scenario, &start, None).err().unwrap();
    assert!(format!("{begun:#}").contains("grain 0 and facet 0 overlap"), "{begun:#}");
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

#[test]
fn how_an_obstacle_cannot_move_is_said() {
    let said = |motion: &str| {
        let text = format!(
            "dimension = 2\nduration = 1.0\nsample = 1.0\n[law]\nkind = \"constant\"\nrestitution = 1.0\n\
             [[obstacle]]\nchain = [[-1.0, 0.0], [1.0, 0.0]]\nrestitution = 1.0\n{motion}\n\
             [[grain]]\nradius = 0.1\nmass = 1.0\nat = [0.0, 1.0]\n"
        );
        started(&text, Path::new(".")).unwrap_err()
    };
    for (motion, words) in [
        ("velocity = [1.0]", "velocity has 1 numbers"),
        ("vibration = { amplitude = [0.0, 0.1], frequency = 0.0 }", "vibration.frequency"),
        ("rotation = { centre = [0.0, 0.0], angular_velocity = [0.0] }", "then it stands"),
        ("rotation = { centre = [0.0, 0.0], angular_velocity = [1.0, 2.0, 3.0] }", "has 3 numbers"),
        (
            "velocity = [1.0, 0.0]\nvibration = { amplitude = [0.0, 0.1], frequency = 1.0 }",
            "it moves in one way",
        ),
    ] {
        let why = said(motion);
        assert!(why.contains(words), "{motion}: {why}");
    }
}
