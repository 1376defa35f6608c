//! Is everything that cannot be named, with its place? Reads scenarios as text; writes nothing.

use super::{TWO_MATERIALS, filled_box, refused};
use carom_host::scenario::examine;
use std::path::Path;

#[test]
fn what_cannot_be_is_named() {
    let materials = |from: &str, to: &str| {
        TWO_MATERIALS
            .replace("\"A\"", "\"steel\"")
            .replace("\"B\"", "\"clay\"")
            .replacen(from, to, 1)
    };
    let species = |from: &str, to: &str| {
        filled_box(3, 0.5, "count = 50\nradius = 0.01").replacen(from, to, 1)
    };
    for (text, wanted) in [
        (
            materials("material = \"clay\"", "material = \"glass\""),
            "grain 1: material is \"glass\", which no [[material]] defines",
        ),
        (
            materials("[\"clay\", \"steel\"]", "[\"clay\", \"steal\"]"),
            "pair 0: between is \"steal\", which no [[material]] defines; the nearest is `steel`",
        ),
        (
            materials("[[pair]]\nbetween = [\"clay\", \"steel\"]\nrestitution = 0.5\n", ""),
            "\"steel\" and \"clay\" can touch, but have no law",
        ),
        (materials("density = 2000.0\nrestitution = 0.1", ""), "material \"clay\" has no law"),
        (
            materials("restitution = 0.9", "restitution = 1.9"),
            "line 8: material 0: restitution is 1.9, must be from 0 to 1",
        ),
        (
            materials("name = \"clay\"", "name = \"steel\""),
            "material 1: name is \"steel\", which another material is called too",
        ),
        (
            materials("material = \"clay\"", ""),
            "grain 1: material is missing, must be steel or clay",
        ),
        (
            species("packing_fraction = 0.5", "packing_fraction = 0.75"),
            "species 0: a packing fraction of 0.7500 cannot be reached, at most 0.7405",
        ),
        (
            species("packing_fraction = 0.5", "packing_fraction = 0.71"),
            "cannot be reached: compressed at random, these grains jam at 0.6",
        ),
        (
            species("count = 50", "count = 3000000000"),
            "species 0: count is 3000000000: so many grains need",
        ),
        (
            species("count = 50", "cuont = 50"),
            "species 0: unknown field `cuont`; the nearest is `count`",
        ),
        (
            species("radius = 0.01", "radius = { mean = 0.01, deviation = 0.004 }"),
            "species 0: radius.deviation is 0.004, must be at least 0 and less than a third of mean",
        ),
        (species("radius = 0.01", "radius = { list = [0.01, -1.0] }"), "radius.list 1 is -1"),
        (species("density = 1.0", ""), "species 0: density is missing, and its material has none"),
        (
            species("count = 50", "count = 50\npacking_fraction = 0.2"),
            "species 0: packing_fraction is given, and so is count",
        ),
        (
            species("restitution = 1.0", "restitution = 1.0\nrestitution = 1.0"),
            "duplicate key `restitution`",
        ),
    ] {
        let error = refused(&text);
        assert!(error.contains(wanted), "{wanted:?}: {error:?}");
        assert_eq!(error.lines().count(), 1, "{error}");
    }
}

/// Everything at once, each with line and column.
#[test]
fn all_that_is_wrong_is_said_at_once() {
    let text = "dimension = 2\nduration = 1.0\nsample = -1.0\ngravity = [0.0]\n\
                [law]\nkind = \"lsd\"\nstiffness = 0.0\ndamping = nan\n\
                [[grain]]\nradius = 0.1\nmass = 1.0\nat = [0.0, inf]\n";
    let (scenario, found) = examine(text, Path::new(""));
    assert!(scenario.is_none());
    let places: Vec<(usize, usize)> = found.iter().map(|(place, _)| *place).collect();
    assert_eq!(places, [(3, 1), (4, 1), (7, 1), (8, 1), (12, 1)], "{found:?}");
    let (_, found) = examine("a = 1\nb = \nc = 3\na = 2\n", Path::new(""));
    assert!(
        found
            .iter()
            .any(|((line, _), problem)| *line == 4 && problem.message == "duplicate key `a`"),
        "{found:?}"
    );
    assert!(found.iter().any(|((line, _), _)| *line == 2), "{found:?}");
}
