//! What is a fit to achieve? Reads nothing; writes nothing, holds law, domain, tolerances and limits of one fit.

use super::cube::Cube;
use crate::read::coordinates::CoordinateMap;
use crate::read::domain::Domain;
use crate::read::law::{End, Law};

/// Up to this softness coordinate the third column is the angle with its leading behaviour divided out.
const DIRECT_ANGLE_ABOVE: f64 = 0.28;

/// What is to be fitted, how well and with how much effort.
#[derive(Clone, Debug)]
pub(crate) struct FitOptions {
    pub law: Law,
    pub end: End,
    pub coordinates: CoordinateMap<f64>,
    pub domain: Domain,
    /// Largest error of each output that a leaf may have.
    pub tolerance: f64,
    /// The same where no typical collision falls.
    pub tolerance_atypical: f64,
    /// Largest number of coefficients of one leaf.
    pub terms_max: usize,
    /// Nodes along each axis to begin with.
    pub first_nodes: [usize; 3],
    /// Bisect rather than take more nodes when the error is more than this many times the tolerance.
    pub bisect_above: f64,
    /// Integrate to 1e-12 rather than 1e-10.
    pub precise: bool,
    /// Typical collisions as points of the unit cube; empty if all are equally typical.
    pub typical: Vec<[f64; 3]>,
    /// Where the check points of the leaves lie: a little more than the domain.
    pub checked_domain: Domain,
    /// The bisection of an earlier search, to be repeated: see `FittedTree::bisection`.
    pub bisection: Option<&'static str>,
}

impl FitOptions {
    /// The tolerance of a box with these typical collisions: where they are rare it is larger.
    pub fn tolerance_for(&self, typical: &[[f64; 3]]) -> f64 {
        if self.typical.is_empty() || typical.len() > 1 {
            self.tolerance
        } else {
            self.tolerance_atypical
        }
    }

    /// Whether the third column of a box is the angle itself.
    pub fn stores_direct_angle(&self, cube: &Cube) -> bool {
        self.coordinates.wide && self.law == Law::LinearDashpot && cube.low[1] > DIRECT_ANGLE_ABOVE
    }
}
