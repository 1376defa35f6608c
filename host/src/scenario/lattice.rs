//! Where are the sites of a lattice? Reads a region and a number; writes nothing, returns as many places.

use super::grains::LatticeName;
use super::region::Region;

/// The sites of a cell, as parts of it, and how its edges are to each other.
fn cell(name: LatticeName, dimension: usize) -> (&'static [[f64; 3]], [f64; 3]) {
    const MIDDLE: [[f64; 3]; 1] = [[0.5; 3]];
    const HEXAGONAL: [[f64; 3]; 2] = [[0.25, 0.25, 0.5], [0.75, 0.75, 0.5]];
    const FACES: [[f64; 3]; 4] =
        [[0.25; 3], [0.75, 0.75, 0.25], [0.75, 0.25, 0.75], [0.25, 0.75, 0.75]];
    match (name, dimension) {
        (LatticeName::Cubic, _) | (LatticeName::Close, 1) => (&MIDDLE, [1.0; 3]),
        (LatticeName::Close, 2) => (&HEXAGONAL, [1.0, 3f64.sqrt(), 1.0]),
        (LatticeName::Close, _) => (&FACES, [1.0; 3]),
    }
}

/// So many sites of a lattice that fills the region as widely as it can; those that are too many are left out
/// evenly.
pub fn sites(name: LatticeName, region: &Region, count: usize) -> Vec<[f64; 3]> {
    let dimension = region.dimension;
    let (basis, proportions) = cell(name, dimension);
    let cells = |edge: f64| -> [usize; 3] {
        std::array::from_fn(|axis| match axis < dimension {
            // Rounding must not lose a row.
            true => (region.length(axis) / (edge * proportions[axis]) * (1.0 + 1e-12)) as usize,
            false => 1,
        })
    };
    let holds = |edge: f64| cells(edge).iter().product::<usize>().saturating_mul(basis.len());
    let (mut wide, mut narrow) = (f64::MAX, f64::MAX);
    (0..dimension).for_each(|axis| narrow = narrow.min(region.length(axis)));
    while holds(narrow) < count {
        (wide, narrow) = (narrow, 0.5 * narrow);
    }
    for _ in 0..if wide < f64::MAX { 60 } else { 0 } {
        let middle = 0.5 * (wide + narrow);
        if holds(middle) < count { wide = middle } else { narrow = middle }
    }
    let counts = cells(narrow);
    let all = counts.iter().product::<usize>() * basis.len();
    let is_used = |site: usize| (site + 1) * count / all > site * count / all;
    let place = |site: usize| {
        let (number, within) = (site / basis.len(), basis[site % basis.len()]);
        let [nx, ny, _] = counts;
        let cell = [number % nx, number / nx % ny, number / nx / ny];
        std::array::from_fn(|axis| {
            let part = (cell[axis] as f64 + within[axis]) / counts[axis] as f64;
            region.axes[axis][0] + part * region.length(axis)
        })
    };
    (0..all).filter(|site| is_used(*site)).map(place).collect()
}
