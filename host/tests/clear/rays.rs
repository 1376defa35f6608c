//! Does a ray that meets corners and edges say rightly what is inside? Scenarios of one grain in and beside solid obstacles.

use super::started;
use carom_host::method;
use carom_host::scenario::MethodName;
use std::path::Path;

/// A ray from a grain leads along x: it meets corners, or edges, or comes along a side.
#[test]
fn rays_that_meet_corners_and_edges_count_them_once() {
    let begins = |dimension: usize, obstacle: &str, at: [f64; 3]| {
        let grain =
            format!("\n[[grain]]\nradius = 0.01\nmass = 1.0\nat = {:?}\n", &at[..dimension]);
        let text = format!(
            "dimension = {dimension}\nduration = 1.0\nsample = 1.0\n[law]\nkind = \"constant\"\nrestitution = 1.0\n\
             [[obstacle]]\n{obstacle}\nsolid = true\n{grain}"
        );
        let (scenario, start) = started(&text, Path::new(""));
        method::begin(MethodName::Emd, &scenario, &start, None).is_ok()
    };
    let flat =
        "polygon = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0], [0.5, -1.0], [0.5, -0.5]]";
    for (x, y, is_free) in [
        (0.0, 0.0, false),
        (-2.0, 0.0, true),
        (-2.0, 1.0, true),
        (-2.0, -1.0, true),
        (2.0, 0.0, true),
        (-2.0, -0.5, true),
        (0.0, -0.5, false),
    ] {
        assert_eq!(begins(2, flat, [x, y, 0.0]), is_free, "{x}, {y}");
    }
    let mut faces = Vec::new();
    for [x, y, z] in
        [[1, 1, 1], [-1, 1, -1], [-1, -1, 1], [1, -1, -1]].map(|signs| signs.map(f64::from))
    {
        faces.push([[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]]);
        faces.push([[x, 0.0, 0.0], [0.0, 0.0, -z], [0.0, y, 0.0]]);
    }
    let octahedron = format!("triangles = {faces:?}");
    for (at, is_free) in [
        ([0.0, 0.0, 0.0], false),
        ([-2.0, 0.0, 0.0], true),
        ([2.0, 0.0, 0.0], true),
        ([-2.0, 0.5, 0.0], true),
        ([-0.25, 0.5, 0.0], false),
        ([-2.0, 1.0, 0.0], true),
        ([-2.0, 0.25, 0.25], true),
        ([0.0, 0.25, 0.25], false),
        ([-2.0, 0.0, -1.0], true),
    ] {
        assert_eq!(begins(3, &octahedron, at), is_free, "{at:?}");
    }
    // One of its triangles turned inwards: rays that cross it are counted, not signed.
    faces[0].swap(1, 2);
    let unlike = format!("triangles = {faces:?}");
    for (at, is_free) in [([-2.0, 0.25, 0.125], true), ([0.0, 0.25, 0.125], false)] {
        assert_eq!(begins(3, &unlike, at), is_free, "{at:?}");
    }
}
