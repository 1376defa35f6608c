//! Where do the grains of a gas go? Reads number, radii and box; writes grains that do not overlap.

use super::clear::Obstacles;
use super::fill::{self, Crowd};
use super::grains::{Gas, PlaceSpec};
use super::problem::Problem;
use super::radii;
use super::region::Region;
use super::side::{Placed, Side, filled, sphere_mass};
use rand::{RngExt, SeedableRng};
use rand_distr::StandardNormal;
use rand_pcg::Pcg64;

/// The radii of a gas, largest first: small grains still find a place between large ones.
pub fn radii(gas: &Gas) -> Vec<f64> {
    let mut rng = Pcg64::seed_from_u64(gas.seed);
    let mut radii = radii::draw(&gas.radius, gas.count, &mut rng);
    radii.sort_by(|a, b| b.total_cmp(a));
    radii
}

/// Adds the grains of a gas to those that are there: uniformly, one after the other, each placed
/// anew until it overlaps nothing, or by compression where that fails; then velocities, with no
/// total momentum.
///
/// # Errors
/// When an axis is open, or so many grains cannot be placed.
pub fn scatter(
    (gas, density): (&Gas, f64),
    sides: &[Side; 3],
    obstacles: &Obstacles,
    grains: &mut Vec<Placed>,
    dimension: usize,
) -> Result<(), Problem> {
    let radii = radii(gas);
    let first = grains.len();
    let mut rng = Pcg64::seed_from_u64(gas.seed.wrapping_add(1));
    let volume = radii.iter().map(|radius| filled(*radius, dimension)).sum();
    let place = ("gas", &PlaceSpec::default());
    let region = Region::new(place, dimension, sides, (volume, gas.packing_fraction))?;
    let others = &grains[..];
    let crowd = Crowd { path: "gas", region, sides, obstacles, radii: &radii, others };
    let positions = fill::anew_until_free(&crowd, 1.0, &mut rng)
        .map_or_else(|_| fill::compressed(&crowd, &mut rng), Ok)?;
    for (radius, position) in radii.into_iter().zip(positions) {
        let mass = sphere_mass(radius, density);
        grains.push(Placed { radius, mass, position, velocity: [0.0; 3] });
    }
    draw_velocities(&mut rng, gas.thermal_speed, dimension, &mut grains[first..]);
    Ok(())
}

/// Normal velocities of variance v_th²/2 a component, total momentum zero.
fn draw_velocities(rng: &mut Pcg64, thermal_speed: f64, dimension: usize, grains: &mut [Placed]) {
    let width = thermal_speed / 2f64.sqrt();
    for grain in grains.iter_mut() {
        for v in &mut grain.velocity[..dimension] {
            *v = width * rng.sample::<f64, _>(StandardNormal);
        }
    }
    let mass: f64 = grains.iter().map(|grain| grain.mass).sum();
    for axis in 0..dimension {
        let momentum: f64 = grains.iter().map(|grain| grain.mass * grain.velocity[axis]).sum();
        for grain in grains.iter_mut() {
            grain.velocity[axis] -= momentum / mass;
        }
    }
}
