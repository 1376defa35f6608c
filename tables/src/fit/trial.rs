//! How good is a fit of one box with given numbers of nodes? Reads the exact results at the nodes; writes Chebyshev coefficients and their error.

use super::check::{Check, errors};
use super::column::{Column, nodes as chebyshev_nodes};
use super::cube::Cube;
use super::exact::{exact_outcome, rotation_factor};
use super::options::FitOptions;

/// One attempt at a leaf.
pub(super) struct Trial {
    pub columns: [Column; 3],
    thresholds: [f64; 3],
    /// Number of coefficients that are kept.
    pub count: usize,
    /// The largest error at the check points.
    pub error: f64,
}

impl Trial {
    /// Fits a box with so many nodes along each axis.
    pub fn new(
        options: &FitOptions,
        cube: &Cube,
        nodes: [usize; 3],
        tolerance: f64,
        checks: &[Check],
    ) -> Self {
        let columns = sample(options, cube, nodes);
        let thresholds = columns.each_ref().map(|c| c.all[0].abs() * tolerance * 0.3);
        let mut trial = Trial { columns, thresholds, count: 0, error: f64::INFINITY };
        trial.trim(options, cube, tolerance, checks);
        trial.count = trial.columns.iter().map(Column::count).sum();
        trial
    }

    /// Whether error and number of coefficients are small enough.
    pub fn is_good_enough(&self, options: &FitOptions, tolerance: f64) -> bool {
        self.error <= tolerance && self.count <= options.terms_max
    }

    /// Drops, round by round, what the tolerance does not need.
    fn trim(&mut self, options: &FitOptions, cube: &Cube, tolerance: f64, checks: &[Check]) {
        let direct = options.stores_direct_angle(cube);
        for round in 0..6 {
            for (column, &threshold) in self.columns.iter_mut().zip(&self.thresholds) {
                column.cut(threshold);
            }
            let errors = errors(options, direct, &self.columns, checks);
            self.error = errors.iter().fold(0.0, |worst, &e| if e > worst { e } else { worst });
            if round == 0 && self.error > 100.0 * tolerance {
                return;
            }
            for (threshold, e) in self.thresholds.iter_mut().zip(errors) {
                let kept = round == 4 && e <= tolerance;
                *threshold *= if kept { 1.0 } else { (0.85 * tolerance / e).clamp(0.1, 4.0) };
            }
        }
    }

    /// The axis along which the expansions fall off most slowly.
    pub fn slowest_axis(&self) -> usize {
        let mut tails = [0.0; 3];
        for (column, threshold) in self.columns.iter().zip(self.thresholds) {
            for (tail, more) in tails.iter_mut().zip(column.tails(threshold)) {
                *tail += more;
            }
        }
        let mut axis = 0;
        for a in 1..3 {
            if tails[a] > tails[axis] {
                axis = a;
            }
        }
        axis
    }
}

/// The three columns at the Chebyshev nodes of a box, transformed.
fn sample(options: &FitOptions, cube: &Cube, nodes: [usize; 3]) -> [Column; 3] {
    let direct = options.stores_direct_angle(cube);
    let places = nodes.map(chebyshev_nodes);
    let mut columns = [const { Vec::new() }; 3];
    for &first in &places[0] {
        for &second in &places[1] {
            for &third in &places[2] {
                let g = extended(
                    options,
                    options.coordinates.groups_at(cube.at([first, second, third])),
                );
                let outcome = exact_outcome(options, g);
                let values = options.coordinates.columns(g, rotation_factor(g), direct, outcome);
                columns[0].push(values[0]);
                columns[1].push(values[1]);
                columns[2].push(values[2]);
            }
        }
    }
    columns.map(|values| Column::new(values, nodes))
}

/// Well below the smallest eccentricity of soft contacts the fit sees that eccentricity.
fn extended(options: &FitOptions, [kappa, eta, c_dis]: [f64; 3]) -> [f64; 3] {
    let least = options.domain.sin_min * options.domain.sin_min * eta * 0.2;
    [if eta > 0.4 && kappa < least { least } else { kappa }, eta, c_dis]
}
