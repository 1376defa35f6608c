//! Are materials, species and their placement what a scenario says? Reads scenarios as text; writes nothing.

mod files;
mod filling;
mod materials;
mod placing;
mod refused;

use carom_host::scenario::{Placed, Scenario, Side, Start};
use std::f64::consts::PI;

/// The start of a scenario that is good.
pub fn started(text: &str) -> Start {
    let scenario = Scenario::parse(text).expect("a good scenario");
    Start::new(&scenario).expect("a place for every grain")
}

/// Why a scenario is refused.
pub fn refused(text: &str) -> String {
    let scenario = match Scenario::parse(text) {
        Err(error) => return format!("{error:#}"),
        Ok(scenario) => scenario,
    };
    format!("{:#}", Start::new(&scenario).expect_err("it cannot be placed"))
}

/// The smallest gap of any two grains and of any grain and wall, over the radius: each pair is looked at.
pub fn smallest_gap(start: &Start) -> f64 {
    let mut smallest = f64::INFINITY;
    for (i, a) in start.grains.iter().enumerate() {
        for b in &start.grains[..i] {
            let apart = start.nearest(&a.position, &b.position);
            let distance = apart.iter().map(|x| x * x).sum::<f64>().sqrt();
            smallest = smallest.min((distance - a.radius - b.radius) / a.radius);
        }
        for (side, x) in start.sides.iter().zip(a.position) {
            let gap = match *side {
                Side::Walls([from, to], ..) => (x - from).min(to - x),
                Side::Plate(plate, _) => x - plate.at - plate.amplitude,
                _ => continue,
            };
            smallest = smallest.min(gap / a.radius - 1.0);
        }
    }
    smallest
}

/// The part of the box that grains fill.
pub fn packing(start: &Start) -> f64 {
    let d = start.dimension;
    let volume: f64 =
        start.sides[..d].iter().filter_map(Side::range).map(|[from, to]| to - from).product();
    let filled = |grain: &Placed| match d {
        1 => 2.0 * grain.radius,
        2 => PI * grain.radius.powi(2),
        _ => 4.0 / 3.0 * PI * grain.radius.powi(3),
    };
    start.grains.iter().map(filled).sum::<f64>() / volume
}

/// T = ⟨m v²⟩/D of the grains of a species.
pub fn temperature(start: &Start, species: u16) -> f64 {
    let of = start.grains.iter().zip(&start.species).filter(|(_, s)| **s == species);
    let squares: Vec<f64> =
        of.map(|(g, _)| g.mass * g.velocity.iter().map(|v| v * v).sum::<f64>()).collect();
    squares.iter().sum::<f64>() / (squares.len() * start.dimension) as f64
}

/// Periodic boxes of one, two and three dimensions.
pub const PERIODIC: [&str; 3] = [
    "dimension = 1\n[box]\nx = { kind = \"periodic\" }\n",
    "dimension = 2\n[box]\nx = { kind = \"periodic\" }\ny = { kind = \"periodic\" }\n",
    "dimension = 3\n[box]\nx = { kind = \"periodic\" }\ny = { kind = \"periodic\" }\nz = { kind = \"periodic\" }\n",
];

/// A periodic box of one species at a packing fraction.
pub fn filled_box(dimension: usize, packing: f64, species: &str) -> String {
    format!(
        "duration = 1.0\nsample = 0.1\n{}packing_fraction = {packing}\n\
         [law]\nkind = \"constant\"\nrestitution = 1.0\n[[species]]\ndensity = 1.0\n{species}\n",
        PERIODIC[dimension - 1]
    )
}

/// Two materials and what they do.
pub const TWO_MATERIALS: &str = "dimension = 1\nduration = 1.0\nsample = 1.0\nmethods = [\"emd\"]\n\
    [[material]]\nname = \"steel\"\ndensity = 7800.0\nrestitution = 0.9\n\
    [[material]]\nname = \"clay\"\ndensity = 2000.0\nrestitution = 0.1\n\
    [[pair]]\nbetween = [\"clay\", \"steel\"]\nrestitution = 0.5\n\
    [[grain]]\nradius = 0.1\nmass = 1.0\nat = [0.0]\nmoving = [1.0]\nmaterial = \"A\"\n\
    [[grain]]\nradius = 0.1\nmass = 1.0\nat = [0.5]\nmaterial = \"B\"\n";
