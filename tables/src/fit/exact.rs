//! What is the exact result of a collision? Reads `kappa`, `eta`, `c_dis`; writes duration, speed and angle.

use super::options::FitOptions;
use crate::contact::{integrate_radial, integrate_radial_quickly};

/// Duration, speed and angle for `kappa`, `eta`, `c_dis`.
pub(super) fn exact_outcome(options: &FitOptions, g: [f64; 3]) -> [f64; 3] {
    let integrate = if options.precise { integrate_radial } else { integrate_radial_quickly };
    let done = integrate(options.law, options.end, g[0], g[1], g[2]);
    [done.tau, done.speed, rotation_factor(g) * done.rotation]
}

/// `tan(alpha) eta`, by which the integral over the contact is multiplied to give the angle.
pub(super) fn rotation_factor(g: [f64; 3]) -> f64 {
    libm::sqrt(g[0] * g[1])
}
