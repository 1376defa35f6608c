//! How large are the errors of a trial? Reads its columns, at points that it was not fitted to; writes the largest errors.

use super::column::Column;
use super::cube::{Cube, test_point};
use super::exact::{exact_outcome, rotation_factor};
use super::options::FitOptions;
use crate::random::Rng;
use crate::read::domain::Domain;
use crate::read::groups::Groups;
use crate::read::layout::MAX_TERMS;

/// A point the fit does not see: groups, outcome, and the polynomials at its place in the box.
pub(super) struct Check {
    groups: [f64; 3],
    outcome: [f64; 3],
    basis: [[f64; MAX_TERMS]; 3],
}

/// Check points of one box.
const CHECKS: usize = 80;

impl Check {
    /// Corners, faces and the inside of a box, as far as they lie in the domain. Few do if the box only touches it.
    pub fn of(options: &FitOptions, cube: &Cube) -> Vec<Check> {
        let mut checks = Vec::new();
        let mut rng = Rng::new(17);
        for n in 0..50 * CHECKS {
            let y = test_point(n, &mut rng);
            let groups = options.coordinates.groups_at(cube.at(y));
            if inside(&options.checked_domain, groups) {
                let basis = y.map(polynomials);
                checks.push(Check { groups, outcome: exact_outcome(options, groups), basis });
            }
            if checks.len() == CHECKS {
                break;
            }
        }
        checks
    }
}

fn polynomials(y: f64) -> [f64; MAX_TERMS] {
    let x = 2.0 * y - 1.0;
    let mut t = [1.0; MAX_TERMS];
    t[1] = x;
    for k in 2..MAX_TERMS {
        t[k] = 2.0 * x * t[k - 1] - t[k - 2];
    }
    t
}

/// Do `kappa`, `eta`, `c_dis` belong to a collision of the domain?
fn inside(domain: &Domain, [kappa, eta, c_dis]: [f64; 3]) -> bool {
    let cos2 = eta / (kappa + eta);
    let cos = libm::sqrt(cos2);
    let sin = libm::sqrt(kappa / (kappa + eta));
    domain.contains(&Groups { sin, cos, eta, c_dis })
}

/// Largest error of duration (relative), speed and angle.
pub(super) fn errors(
    options: &FitOptions,
    direct_angle: bool,
    columns: &[Column; 3],
    checks: &[Check],
) -> [f64; 3] {
    let mut largest = [1e-300; 3];
    for check in checks {
        let values = columns.each_ref().map(|c| c.value(&check.basis));
        let got = options.coordinates.outcome(
            check.groups,
            rotation_factor(check.groups),
            direct_angle,
            values,
        );
        let [tau, speed, angle] = check.outcome;
        // The separation is 1 - c_dis eta speed, so an error of the speed becomes one of the separation.
        let separation_factor = (check.groups[1] * check.groups[2]).max(1.0);
        let error = [
            (got[0] / tau - 1.0).abs(),
            separation_factor * (got[1] - speed).abs(),
            (got[2] - angle).abs(),
        ];
        for (w, e) in largest.iter_mut().zip(error) {
            *w = if e > *w { e } else { *w };
            if e.is_nan() {
                *w = f64::INFINITY;
            }
        }
    }
    largest
}
