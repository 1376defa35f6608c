//! Are grains filled in as densely, as large and as fast as a scenario says? Reads scenarios as text; writes nothing.

use super::{filled_box, packing, smallest_gap, started, temperature};
use carom_host::scenario::touching;
use std::f64::consts::PI;

/// Both ways of filling, in all dimensions: the packing fraction is what was asked, and nothing overlaps.
#[test]
fn a_box_is_filled_to_its_packing_fraction_without_overlap() {
    for (dimension, phi) in
        [(1, 0.4), (1, 0.9), (2, 0.4), (2, 0.6), (2, 0.8), (3, 0.25), (3, 0.5), (3, 0.6)]
    {
        let start = started(&filled_box(dimension, phi, "count = 300\nradius = 0.01"));
        assert_eq!(start.grains.len(), 300);
        assert!((packing(&start) - phi).abs() < 1e-9, "{dimension} D: {}", packing(&start));
        let gap = smallest_gap(&start);
        assert!(gap >= 0.0, "{dimension} D at {phi}: {gap}");
        // At random, not on a lattice: x of the grains takes no value twice.
        let mut x: Vec<f64> = start.grains.iter().map(|grain| grain.position[0]).collect();
        x.sort_by(f64::total_cmp);
        assert!(x.windows(2).all(|pair| pair[0] < pair[1]));
    }
}

/// Sizes that differ by ten, walls all round, and a grain in the middle that stays where it was put.
#[test]
fn grains_of_two_sizes_are_pressed_between_walls_around_another() {
    let wall = "{ kind = \"walls\", from = 0.0, to = 1.0, surface = \"soft\" }";
    let text = format!(
        "dimension = 2\nduration = 1.0\nsample = 0.1\n[box]\nx = {wall}\ny = {wall}\n\
         [law]\nkind = \"lsd\"\nstiffness = 1e4\ndamping = 0.0\n\
         [[grain]]\nradius = 0.1\ndensity = 1.0\nat = [0.5, 0.5]\n\
         [[species]]\nname = \"large\"\npacking_fraction = 0.3\nradius = 0.05\ndensity = 1.0\n\
         [[species]]\nname = \"small\"\npacking_fraction = 0.4\nradius = {{ uniform = [0.01, 0.02] }}\ndensity = 1.0\n"
    );
    let start = started(&text);
    assert!(smallest_gap(&start) >= 0.0, "{}", smallest_gap(&start));
    assert_eq!(start.grains[0].position, [0.5, 0.5, 0.0]);
    assert_eq!(start.species_names, ["grain", "large", "small"]);
    for (species, wanted, radius) in [(1, 0.3, 0.05), (2, 0.4, 0.02)] {
        let of = start.grains.iter().zip(&start.species).filter(|(_, s)| **s == species);
        let area: f64 = of.map(|(grain, _)| PI * grain.radius.powi(2)).sum();
        assert!((area - wanted).abs() <= PI * radius * radius, "species {species} fills {area}");
    }
}

/// The mean of a Gaussian is met within four standard errors, a list is kept in its proportions.
#[test]
fn radii_are_distributed_as_said() {
    let start =
        started(&filled_box(3, 0.1, "count = 2000\nradius = { mean = 0.01, deviation = 0.001 }"));
    let radii: Vec<f64> = start.grains.iter().map(|grain| grain.radius).collect();
    let mean = radii.iter().sum::<f64>() / 2000.0;
    let variance = radii.iter().map(|r| (r - mean).powi(2)).sum::<f64>() / 2000.0;
    assert!((mean - 0.01).abs() < 4.0 * 0.001 / 2000f64.sqrt(), "mean {mean}");
    // A normal variable cut at three standard deviations has 0.9733 of the variance.
    assert!((variance / 0.9733e-6 - 1.0).abs() < 4.0 * (2f64 / 2000.0).sqrt(), "{variance}");
    assert!(radii.iter().all(|r| (0.007..=0.013).contains(r)));

    let start = started(&filled_box(2, 0.1, "count = 9\nradius = { list = [0.01, 0.02, 0.03] }"));
    for wanted in [0.01, 0.02, 0.03] {
        assert_eq!(start.grains.iter().filter(|grain| grain.radius == wanted).count(), 3);
    }
}

/// T, drift and momentum are exact, by species, whatever the masses are.
#[test]
fn temperatures_are_exact() {
    let text = filled_box(
        3,
        0.1,
        "count = 50\nradius = { uniform = [0.01, 0.02] }\ntemperature = 3.5\nmoving = [1.0, 0.0, 0.0]\n\
         [[species]]\ncount = 40\nradius = 0.01\ndensity = 7.0\nthermal_speed = 2.0\n\
         [[species]]\ncount = 3\nradius = 0.01\ndensity = 7.0",
    );
    let mut start = started(&text);
    for grain in &mut start.grains[..50] {
        grain.velocity[0] -= 1.0;
    }
    assert!((temperature(&start, 0) / 3.5 - 1.0).abs() < 1e-12);
    let mass = start.grains[50].mass;
    assert!((temperature(&start, 1) / (0.5 * mass * 4.0) - 1.0).abs() < 1e-12);
    assert_eq!(temperature(&start, 2), 0.0);
    for range in [0..50, 50..90] {
        for axis in 0..3 {
            let momentum: f64 =
                start.grains[range.clone()].iter().map(|g| g.mass * g.velocity[axis]).sum();
            assert!(momentum.abs() < 1e-12, "momentum {momentum}");
        }
    }
}

/// A plate leaves the height open: the grains lie between it and where the packing fraction says.
#[test]
fn a_gas_over_a_plate_has_a_place() {
    let text = |packing: &str| {
        format!(
            "dimension = 2\ngravity = [0.0, -9.81]\nduration = 1.0\nsample = 0.1\n[box]\n\
             x = {{ kind = \"periodic\", from = 0.0, to = 1.0 }}\n\
             y = {{ kind = \"plate\", at = 0.5, amplitude = 0.1, frequency = 1.0, surface = \"soft\" }}\n\
             [law]\nkind = \"constant\"\nrestitution = 0.9\n\
             [gas]\ncount = 100\nradius = 0.01\ndensity = 1.0\nthermal_speed = 1.0\nseed = 1\n{packing}\n"
        )
    };
    for (packing, phi) in [("", 0.2), ("packing_fraction = 0.05", 0.05)] {
        let start = started(&text(packing));
        assert!(smallest_gap(&start) >= 0.0);
        let top = 0.6 + 100.0 * PI * 1e-4 / phi;
        assert!(start.grains.iter().all(|grain| grain.position[1] + 0.01 <= top));
        // Of 100 grains one is in the uppermost tenth but for one case in 37,000.
        assert!(start.grains.iter().any(|grain| grain.position[1] > 0.6 + 0.9 * (top - 0.6)));
    }
}

/// 10,000 equal spheres at 0.62. In release under a minute on one core:
/// `cargo test --release -p carom-host --test species -- --ignored`
#[test]
#[ignore = "takes a minute without optimisation"]
fn ten_thousand_spheres_are_packed_to_0_62() {
    let start = started(&filled_box(3, 0.62, "count = 10000\nradius = 0.01"));
    assert!((packing(&start) - 0.62).abs() < 1e-9);
    assert!(!touching(&start, &start.grains).contains(&true));
}
