//! What should pressure and mean free time be? Reads a density; writes nothing, returns published equations of state.

use std::f64::consts::PI;

/// The packing fraction of spheres of diameter 1.
pub fn packing_of_spheres(density: f64) -> f64 {
    density * PI / 6.0
}

/// The packing fraction of disks of diameter 1.
pub fn packing_of_disks(density: f64) -> f64 {
    density * PI / 4.0
}

/// Z of hard spheres at packing fraction η: Carnahan and Starling (J. Chem. Phys. 51, 635, 1969,
/// doi:10.1063/1.1672048). Good to about 0.3 % in the fluid, η < 0.49.
///
/// ```
/// use carom_host::figure::hard::theory::carnahan_starling;
/// // Second virial coefficient: Z = 1 + 4 η + …
/// assert!(((carnahan_starling(1e-6) - 1.0) / 1e-6 - 4.0).abs() < 1e-4);
/// ```
pub fn carnahan_starling(eta: f64) -> f64 {
    (1.0 + eta + eta * eta - eta.powi(3)) / (1.0 - eta).powi(3)
}

/// Coefficients of x^1, x^2, … in [`kolafa_rottner`].
const DISKS: [f64; 12] = [
    2.0,
    1.128_017_75,
    0.001_818_952_91,
    -0.052_613_473_7,
    0.050_496_016_8,
    -0.032_553_779_2,
    0.013_457_863_2,
    0.001_408_881_82,
    -0.008_342_736_01,
    0.006_941_273_67,
    -0.002_622_547_23,
    0.000_355_746_352,
];

/// Z of hard disks at packing fraction η: Kolafa and Rottner (Mol. Phys. 104, 3435, 2006,
/// doi:10.1080/00268970600967963), their fit up to density 0.9, η < 0.707.
///
/// ```
/// use carom_host::figure::hard::theory::kolafa_rottner;
/// // The virial series of Clisby and McCoy (J. Stat. Phys. 122, 15, 2006) up to its tenth term.
/// let virial = [1.0, 1.0, 0.782004, 0.5322318, 0.33355604, 0.1988425, 0.1148728, 0.064993, 0.0362193, 0.0199537];
/// let z: f64 = (0..).zip(virial).map(|(k, b)| b * 0.4_f64.powi(k)).sum();
/// assert!((kolafa_rottner(0.2) - z).abs() < 1e-4);
/// ```
pub fn kolafa_rottner(eta: f64) -> f64 {
    let x = eta / (1.0 - eta);
    let sum = DISKS.iter().rev().fold(0.0, |sum, c| (sum + c) * x);
    1.0 + sum - 5.246_729_38e-9 * x.powi(22)
}

/// The mean free time of hard spheres of diameter and mass 1 at kT = 1, with Enskog's exact relation
/// between collision rate and pressure: 1/τ = 4 ρ χ √π, χ = (Z − 1)/(4 η).
pub fn mean_free_time(density: f64, compressibility: f64) -> f64 {
    let chi = (compressibility - 1.0) / (4.0 * packing_of_spheres(density));
    1.0 / (4.0 * density * chi * PI.sqrt())
}

/// The mean free time at density 0.5 by molecular dynamics: Lue (J. Chem. Phys. 122, 044513, 2005,
/// doi:10.1063/1.1834498).
pub const LUE: f64 = 0.1303;
