//! Which obstacles are refused, and with which words? Scenarios from text, meshes from files; writes into folders of its own.

mod meshes;

use carom_host::method;
use carom_host::scenario::{MethodName, Scenario, Start};
use meshes::{FACES, OBJ, in_room, stl_binary, stl_text};
use std::fs;
use std::path::Path;

/// Why a scenario does not begin.
fn refused(text: &str, folder: &Path) -> String {
    let begun = Scenario::parse_in(text, folder).and_then(|scenario| {
        let start = Start::new(&scenario)?;
        method::begin(MethodName::Emd, &scenario, &start, None).map(drop)
    });
    begun.err().map_or_else(|| "it begins".to_owned(), |why| format!("{why:#}"))
}

#[test]
fn what_is_wrong_with_a_mesh_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let of_file = |name: &str, bytes: &[u8]| {
        fs::write(at.join(name), bytes).unwrap();
        let text = in_room(name, "at = [0.0, 0.0, 0.5]");
        let closed = refused(&text, at);
        assert_eq!(refused(&text.replace("closed", "solid"), at), closed);
        closed
    };
    let hole = of_file("hole.stl", stl_text(&FACES[..3]).as_bytes());
    let words = "obstacle 0: hole.stl: must be closed, but edge 0 of triangle 0, \
                 from [0.0, 0.0, 0.5] to [0.0, 1.0, 0.5], belongs to no other: there is a hole";
    assert_eq!(hole, words);
    let twice: Vec<_> = FACES.iter().chain(&FACES[..1]).copied().collect();
    let twice = of_file("twice.stl", stl_text(&twice).as_bytes());
    assert!(twice.contains("twice.stl: must be closed, but edge 0 of triangle 0"), "{twice}");
    assert!(twice.ends_with("belongs to 3 triangles"), "{twice}");
    let mut flat = FACES;
    flat[1][2] = flat[1][0];
    let flat = of_file("flat.stl", stl_text(&flat).as_bytes());
    let words = "obstacle 0: flat.stl: triangle 1 has no area: \
                 its corners are [[0.0, 0.0, 0.5], [1.0, 0.0, 0.5], [0.0, 0.0, 0.5]]";
    assert_eq!(flat, words);
    let mut nan = FACES;
    nan[2][0][1] = f64::NAN;
    let nan = of_file("nan.stl", &stl_binary(&nan));
    let words = "obstacle 0: nan.stl: triangle 2 has a corner at [1.0, NaN, 0.5], must be finite";
    assert_eq!(nan, words);
    let nan = of_file("nan.obj", OBJ.replace("v 0 0 1000", "v 0 0 nan").as_bytes());
    let words = "obstacle 0: nan.obj: triangle 1 has a corner at [0.0, 0.0, NaN], must be finite";
    assert_eq!(nan, words);
    let noise = of_file("noise.stl", b"solid nothing here");
    assert!(noise.starts_with("obstacle 0: noise.stl: is no STL file"), "{noise}");
    let other = of_file("room.step", b"");
    assert_eq!(other, "obstacle 0: room.step: its name must end in .stl or .obj");
    let missing = refused(&in_room("missing.stl", ""), at);
    assert!(missing.starts_with("obstacle 0: missing.stl: cannot read"), "{missing}");
}

fn flat(obstacle: &str, more: &str) -> String {
    format!(
        "dimension = 2\nduration = 1.0\nsample = 1.0\n{more}\n[law]\nkind = \"constant\"\nrestitution = 1.0\n\
         [[obstacle]]\n{obstacle}\n\
         [[grain]]\nradius = 0.1\nmass = 1.0\nat = [0.5, 0.5]\n"
    )
}

#[test]
fn what_is_wrong_with_the_fields_is_named() {
    let cases = [
        ("", "", "give one of polygon, chain, triangles and file"),
        ("chain = [[0.0, 0.0]]", "", "must have at least 2"),
        ("polygon = [[0.0, 0.0], [1.0, 0.0], [1.0]]", "", "has 1 numbers, must have 2"),
        ("file = \"room.stl\"", "", "needs dimension 3, but it is 2"),
        ("chain = [[0.0, 0.0], [1.0, 0.0]]\nrestitution = 1.5", "", "must be from 0 to 1"),
        ("chain = [[0.0, 0.0], [1.0, 0.0]]\nclosed = true", "", "only meshes have holes"),
        (
            "chain = [[0.0, 0.0], [1.0, 0.0]]\nsolid = true",
            "",
            "obstacle 0: solid is given, but a chain has no inside: give a polygon",
        ),
        ("chain = [[0.0, 0.0], [1.0, 0.0]]\nmaterial = \"tin\"", "", "tin"),
        ("chain = [[0.0, 0.0], [1.0, 0.0]]", "methods = [\"emd*\", \"md\"]", "md"),
        (
            "chain = [[0.0, 0.0], [1.0, 0.0]]",
            "box = { x = { kind = \"periodic\", from = 0.0, to = 9.0 } }",
            "box.x is periodic, but there is [[obstacle]]",
        ),
        (
            "chain = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.0]]",
            "",
            "obstacle 0: piece 1 has no length: its corners are [[1.0, 0.0, 0.0], [1.0, 0.0, 0.0]]",
        ),
    ];
    for (obstacle, more, wanted) in cases {
        let said = refused(&flat(obstacle, more), Path::new(""));
        assert!(said.to_lowercase().contains(wanted), "{said}, not {wanted}");
    }
}

#[test]
fn a_grain_in_a_wall_is_named_with_the_facet() {
    let said = |obstacle: &str| refused(&flat(obstacle, ""), Path::new(""));
    let words = |facet: &str, gap: &str| {
        format!(
            "eMD: grain 0 overlaps {facet}; it is at [0.5, 0.5] m, its gap is {gap} m, must be at least 0"
        )
    };
    let gap = "-0.037500000000000006";
    let chain = "chain = [[9.0, 9.0], [0.4375, 9.0], [0.4375, 0.0]]";
    assert_eq!(said(chain), words("piece 1 of obstacle 0", gap));
    let polygon = "polygon = [[9.0, 9.0], [0.4375, 9.0], [0.4375, 0.0]]";
    assert_eq!(said(polygon), words("side 1 of obstacle 0", gap));
    let second = format!("chain = [[0.0, 8.0], [1.0, 8.0]]\n[[obstacle]]\n{chain}");
    assert_eq!(said(&second), words("piece 1 of obstacle 1", gap));
    let between = format!("{chain}\n[[obstacle]]\nchain = [[0.5625, 0.0], [0.5625, 1.0]]");
    let both = "piece 1 of obstacle 0 and, on its other side, piece 0 of obstacle 1: between them is no room for it";
    assert_eq!(said(&between), words(both, gap));
}

#[test]
fn a_grain_in_a_mesh_is_named_with_file_and_triangle() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("room.stl"), stl_text(&FACES)).unwrap();
    let text = in_room("room.stl", "");
    let words = "eMD: grain 0 overlaps triangle 1 of \"room.stl\"; it is at [0.2, 0.03125, 0.2] m, \
                 its gap is -0.018750000000000003 m, must be at least 0";
    let near = text.replace("0.2, 0.2, 0.2", "0.2, 0.03125, 0.2");
    assert_eq!(refused(&near, folder.path()), words);
    // In the middle of what is solid.
    let words = "eMD: grain 0 is inside of \"room.stl\", which is solid: it is at [0.2, 0.2, 0.2]";
    assert_eq!(refused(&text.replace("closed", "solid"), folder.path()), words);
    let solid = "polygon = [[-9.0, -9.0], [9.0, -9.0], [0.0, 9.0]]\nsolid = true";
    let words = "eMD: grain 0 is inside of obstacle 0, which is solid: it is at [0.5, 0.5]";
    assert_eq!(refused(&flat(solid, ""), folder.path()), words);
}

#[test]
fn an_obstacle_outside_the_box_is_named_with_its_place() {
    let walls = "box = { x = { kind = \"walls\", from = 0.0, to = 1.0 }, y = { kind = \"plate\", at = -1.0 } }";
    let said = |obstacle: &str| refused(&flat(obstacle, walls), Path::new(""));
    let words = "obstacle 0: it is outside the box: it reaches from [1.5, 0.0] to [2.0, 1.0] m, \
                 the box from [0.0, -1.0] to [1.0, inf] m";
    assert_eq!(said("chain = [[1.5, 0.0], [2.0, 1.0]]"), words);
    // Around a corner of the box, and below the plate.
    assert!(said("chain = [[-0.2, -0.9], [0.1, -1.3]]").contains("is outside the box"));
    assert!(said("chain = [[0.0, -1.25], [1.0, -1.25]]").contains("is outside the box"));
    for inside in [
        "chain = [[0.5, 0.0], [2.0, 0.0]]",
        "chain = [[-1.0, 0.0], [2.0, 0.0]]",
        "chain = [[1.0, 0.0], [1.0, 1.0]]",
        "polygon = [[-5.0, -5.0], [5.0, -5.0], [0.0, 0.25]]",
        "chain = [[1.5, 0.0], [2.0, 1.0]]\nvelocity = [-1.0, 0.0]",
    ] {
        assert_eq!(said(inside), "it begins", "{inside}");
    }
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("room.stl"), stl_text(&FACES)).unwrap();
    let text = "box = { z = { kind = \"walls\", from = -1.0, to = 1.0 } }\n";
    let text = text.to_owned() + &in_room("room.stl", "at = [0.0, 0.0, 1.5]");
    let words = "obstacle 0: \"room.stl\" is outside the box: it reaches from [0.0, 0.0, 1.5] to [1.0, 1.0, 2.5] m, \
                 the box from [-inf, -inf, -1.0] to [inf, inf, 1.0] m";
    assert_eq!(refused(&text, folder.path()), words);
}

#[test]
fn how_an_obstacle_cannot_move_is_said() {
    let said = |motion: &str| {
        let text = format!(
            "dimension = 2\nduration = 1.0\nsample = 1.0\n[law]\nkind = \"constant\"\nrestitution = 1.0\n\
             [[obstacle]]\nchain = [[-1.0, 0.0], [1.0, 0.0]]\nrestitution = 1.0\n{motion}\n\
             [[grain]]\nradius = 0.1\nmass = 1.0\nat = [0.0, 1.0]\n"
        );
        refused(&text, Path::new("."))
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
