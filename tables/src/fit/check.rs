//! How wrong is a trial leaf? Reads its columns and points that it does not see; writes the largest errors.

use super::{Ask, Column, Cube, outcome, turn};
use crate::form::{Domain, MAX_TERMS};
use crate::recipe::spread::Spread;

/// A point the fit does not see: groups, outcome, and the polynomials at its place in the box.
pub(super) struct Check {
    groups: [f64; 3],
    outcome: [f64; 3],
    basis: [[f64; MAX_TERMS]; 3],
}

/// Check points of one box.
const CHECKS: usize = 80;

impl Check {
    /// Corners, faces and the inside of a box, as far as they lie in the domain; it may hold only a sliver of it.
    pub fn of(ask: &Ask, cube: &Cube) -> Vec<Check> {
        let mut checks = Vec::new();
        let mut spread = Spread::new(17);
        for n in 0..50 * CHECKS {
            let y = place(n, &mut spread);
            let groups = ask.frame.groups(cube.at(y));
            if inside(&ask.checked, groups) {
                let basis = y.map(chebyshev);
                checks.push(Check { groups, outcome: outcome(ask, groups), basis });
            }
            if checks.len() == CHECKS {
                break;
            }
        }
        checks
    }
}

/// The `n`-th place in a box: first its corners, then faces and the inside.
pub(crate) fn place(n: usize, spread: &mut Spread) -> [f64; 3] {
    if n < 8 {
        return [0, 1, 2].map(|a| if n >> a & 1 == 1 { 1.0 - 1e-6 } else { 1e-6 });
    }
    let mut y = [0.0; 3];
    for value in &mut y {
        let u = spread.uniform();
        // Often close to an end, where the errors peak.
        *value = match (spread.uniform() * 4.0) as u32 {
            0 => u * u * u,
            1 => 1.0 - u * u * u,
            _ => u,
        };
    }
    if n % 3 == 1 {
        // A face; the outermost ones lie outside the domain, so come from any distance.
        let near = libm::pow(10.0, -1.0 - 5.0 * spread.uniform());
        y[(n / 3) % 3] = if n.is_multiple_of(2) { 1.0 - near } else { near };
    }
    y
}

fn chebyshev(y: f64) -> [f64; MAX_TERMS] {
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
    domain.contains(&crate::form::Groups { sin, cos, eta, c_dis })
}

/// Largest error of duration (relative), speed and angle.
pub(super) fn errors(ask: &Ask, direct: bool, columns: &[Column; 3], checks: &[Check]) -> [f64; 3] {
    let mut worst = [1e-300; 3];
    for check in checks {
        let values = columns.each_ref().map(|c| c.value(&check.basis));
        let got = ask.frame.unscale(check.groups, turn(check.groups), direct, values);
        let [tau, speed, angle] = check.outcome;
        // The separation is 1 - c_dis eta speed.
        let pull = (check.groups[1] * check.groups[2]).max(1.0);
        let error =
            [(got[0] / tau - 1.0).abs(), pull * (got[1] - speed).abs(), (got[2] - angle).abs()];
        for (w, e) in worst.iter_mut().zip(error) {
            *w = if e > *w { e } else { *w };
            if e.is_nan() {
                *w = f64::INFINITY;
            }
        }
    }
    worst
}
