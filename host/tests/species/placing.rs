//! Do lattices, layers and piles stand where they should? Reads scenarios as text; writes nothing.

use super::{refused, smallest_gap, started};

const BOX_ON_A_FLOOR: &str = "dimension = 2\ngravity = [0.0, -9.81]\nduration = 1.0\nsample = 0.1\n[box]\n\
    x = { kind = \"walls\", from = 0.0, to = 1.0, surface = \"soft\" }\n\
    y = { kind = \"plate\", at = 0.0, surface = \"soft\" }\n\
    [law]\nkind = \"constant\"\nrestitution = 0.9\n";

/// As many sites as grains, all different, as far apart as the lattice is: a closed form for each.
#[test]
fn lattices_have_the_spacing_of_their_density() {
    // Cells of the close lattices hold 2 and 4; so many fill the box exactly.
    for (dimension, kind, count, spacing) in [
        (1, "close", 10, 0.1),
        (2, "cubic", 100, 0.1),
        (3, "cubic", 125, 0.2),
        (3, "close", 108, 1.0 / 3.0 / 2f64.sqrt()),
    ] {
        let side = "{ kind = \"periodic\", from = 0.0, to = 1.0 }";
        let axes: String =
            ["x", "y", "z"][..dimension].iter().map(|x| format!("{x} = {side}\n")).collect();
        let text = format!(
            "dimension = {dimension}\nduration = 1.0\nsample = 0.1\n[box]\n{axes}\
             [law]\nkind = \"constant\"\nrestitution = 1.0\n[[species]]\ndensity = 1.0\ncount = {count}\n\
             radius = 0.01\nplace = {{ kind = \"lattice\", lattice = \"{kind}\" }}\n"
        );
        let start = started(&text);
        assert_eq!(start.grains.len(), count);
        for a in &start.grains {
            let mut apart: Vec<f64> = start
                .grains
                .iter()
                .map(|b| {
                    start
                        .nearest(&a.position, &b.position)
                        .iter()
                        .map(|x| x * x)
                        .sum::<f64>()
                        .sqrt()
                })
                .collect();
            apart.sort_by(f64::total_cmp);
            assert!((apart[1] / spacing - 1.0).abs() < 1e-9, "{dimension} D {kind}: {}", apart[1]);
        }
        // One grain less leaves one site empty, and the others where they are.
        let one_less =
            started(&text.replace(&format!("count = {count}"), &format!("count = {}", count - 1)));
        assert_eq!(one_less.grains.len(), count - 1);
        assert!(smallest_gap(&one_less) >= 0.0);
    }
}

/// Rows from the floor up, mixed, none overlapping, all within the walls; what was there is left in peace.
#[test]
fn a_layer_lies_on_its_floor() {
    let text = format!(
        "{BOX_ON_A_FLOOR}[[grain]]\nradius = 0.1\ndensity = 1.0\nat = [0.5, 0.1]\n\
         [[species]]\nname = \"large\"\ndensity = 1.0\ncount = 150\nradius = 0.01\nplace = {{ kind = \"layer\" }}\n\
         [[species]]\nname = \"small\"\ndensity = 1.0\ncount = 150\nradius = 0.006\nplace = {{ kind = \"layer\" }}\n"
    );
    let start = started(&text);
    assert_eq!(start.grains.len(), 301);
    assert!(smallest_gap(&start) >= 0.0, "{}", smallest_gap(&start));
    let height = |species: u16| {
        let of = start.grains.iter().zip(&start.species).filter(|(_, s)| **s == species);
        let heights: Vec<f64> = of.map(|(grain, _)| grain.position[1]).collect();
        heights.iter().sum::<f64>() / heights.len() as f64
    };
    // Mixed: both lie equally high on average, within four standard errors of places drawn without order.
    let spread = start.grains.iter().map(|g| g.position[1]).fold(0.0, f64::max) / 12f64.sqrt();
    assert!((height(1) - height(2)).abs() < 4.0 * spread * (2.0 / 150f64).sqrt());
    let lowest = start.grains[1..].iter().map(|g| g.position[1]).fold(f64::INFINITY, f64::min);
    assert!(lowest < 0.011, "the lowest is at {lowest}");
}

/// A heap of touching grains on the floor: its middle is where it should be, and its height that of its rows.
#[test]
fn a_pile_is_a_heap_on_the_floor() {
    let text = format!(
        "{BOX_ON_A_FLOOR}[[species]]\ndensity = 1.0\ncount = 55\nradius = 0.01\nplace = {{ kind = \"pile\", at = [0.3, 0.0] }}\n"
    );
    let start = started(&text);
    let top = start.grains.iter().map(|g| g.position[1]).fold(0.0, f64::max);
    assert!((top - (0.01 + 9.0 * 0.01 * 3f64.sqrt())).abs() < 1e-8, "{top}");
    let middle = start.grains.iter().map(|g| g.position[0]).sum::<f64>() / 55.0;
    assert!((middle - 0.3).abs() < 1e-12, "{middle}");
    let gap = smallest_gap(&start);
    assert!((0.0..1e-8).contains(&gap), "{gap}");
    let wide = refused(&text.replace("count = 55", "count = 5000"));
    assert!(wide.contains("do not fit along x"), "{wide}");
}
