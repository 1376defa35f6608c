//! Where do the grains of a gas go? Reads number, radii and box; writes grains that do not overlap.

use super::spec::Gas;
use anyhow::{Result, bail};
use carom_reference::Plate;
use rand::{RngExt, SeedableRng};
use rand_distr::StandardNormal;
use rand_pcg::Pcg64;
use std::collections::HashMap;
use std::f64::consts::PI;

/// One grain at time 0; components beyond the dimension are 0.
///
/// # Units
/// SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed {
    /// R.
    pub radius: f64,
    /// m.
    pub mass: f64,
    /// Centre.
    pub position: [f64; 3],
    /// Velocity.
    pub velocity: [f64; 3],
}

/// One axis of the box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Side {
    /// Nothing.
    Open,
    /// The box repeats from the first to the second number.
    Periodic([f64; 2]),
    /// Walls that follow the contact law.
    Soft([f64; 2]),
    /// Walls with this coefficient of restitution.
    Hard([f64; 2], f64),
    /// A plate below, soft or with this coefficient of restitution; nothing above.
    Plate(Plate, Option<f64>),
}

impl Side {
    /// Where the axis begins and ends, if it does.
    pub const fn range(&self) -> Option<[f64; 2]> {
        match *self {
            Self::Open | Self::Plate(..) => None,
            Self::Periodic(range) | Self::Soft(range) | Self::Hard(range, _) => Some(range),
        }
    }

    /// The nearest image of a separation along this axis.
    pub fn nearest(&self, separation: f64) -> f64 {
        match *self {
            Self::Periodic([from, to]) => {
                separation - (to - from) * (separation / (to - from)).round()
            }
            _ => separation,
        }
    }
}

/// Mass of a sphere.
pub(super) fn sphere_mass(radius: f64, density: f64) -> f64 {
    4.0 / 3.0 * PI * radius.powi(3) * density
}

/// Tries to place one grain before the box is called full.
const TRIES: usize = 20_000;

/// The radii of a gas, largest first: small grains still find a place between large ones.
pub(super) fn radii(gas: &Gas) -> Vec<f64> {
    let [small, large] = gas.radius.range();
    let mut rng = Pcg64::seed_from_u64(gas.seed);
    let mut radii: Vec<f64> =
        (0..gas.count).map(|_| small + (large - small) * rng.random::<f64>()).collect();
    radii.sort_by(|a, b| b.total_cmp(a));
    radii
}

/// Adds the grains of a gas to those that are there: uniformly, one after the other, each placed
/// anew until it overlaps nothing; then velocities, with no total momentum.
///
/// # Errors
/// When an axis is open, or a grain finds no place.
pub(super) fn scatter(
    gas: &Gas,
    dimension: usize,
    sides: &[Side; 3],
    grains: &mut Vec<Placed>,
) -> Result<()> {
    let radii = radii(gas);
    let first = grains.len();
    let mut rng = Pcg64::seed_from_u64(gas.seed.wrapping_add(1));
    let largest = grains.iter().map(|grain| grain.radius).chain(radii.iter().copied());
    let mut cells = Cells::new(2.0 * largest.fold(0.0, f64::max), sides);
    for (number, grain) in grains.iter().enumerate() {
        cells.add(number, &grain.position);
    }
    for (number, radius) in radii.into_iter().enumerate() {
        let position = find_place(&mut rng, radius, dimension, sides, &cells, grains, number)?;
        cells.add(grains.len(), &position);
        let mass = sphere_mass(radius, gas.density);
        grains.push(Placed { radius, mass, position, velocity: [0.0; 3] });
    }
    draw_velocities(&mut rng, gas.thermal_speed, dimension, &mut grains[first..]);
    Ok(())
}

fn find_place(
    rng: &mut Pcg64,
    radius: f64,
    dimension: usize,
    sides: &[Side; 3],
    cells: &Cells<'_>,
    grains: &[Placed],
    number: usize,
) -> Result<[f64; 3]> {
    let mut range = [[0.0; 2]; 3];
    for (axis, range) in range.iter_mut().enumerate().take(dimension) {
        *range = match sides[axis] {
            Side::Periodic(range) => range,
            Side::Soft([from, to]) | Side::Hard([from, to], _) => [from + radius, to - radius],
            Side::Open | Side::Plate(..) => {
                bail!("box.{}: a gas needs every axis walled or periodic", ["x", "y", "z"][axis])
            }
        };
        if range[0] > range[1] {
            bail!("gas.radius is {radius}, does not fit between the walls");
        }
    }
    for _ in 0..TRIES {
        let position = range.map(|[from, to]| from + (to - from) * rng.random::<f64>());
        if cells.is_free(&position, radius, grains) {
            return Ok(position);
        }
    }
    bail!(
        "gas: no place found for grain {number} in {TRIES} tries; fewer grains or a larger box are needed"
    )
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

/// Grains by cells as wide as the largest diameter.
struct Cells<'a> {
    width: f64,
    sides: &'a [Side; 3],
    members: HashMap<[i64; 3], Vec<usize>>,
}

impl<'a> Cells<'a> {
    fn new(width: f64, sides: &'a [Side; 3]) -> Self {
        Self { width, sides, members: HashMap::new() }
    }

    /// Cells along an axis; a periodic axis has a whole number, so the last one may be wider.
    fn cell(&self, axis: usize, at: f64) -> i64 {
        match self.sides[axis] {
            Side::Periodic([from, to]) => {
                let count = self.count(axis);
                (((at - from) / (to - from)).rem_euclid(1.0) * count as f64) as i64 % count
            }
            _ => (at / self.width).floor() as i64,
        }
    }

    fn count(&self, axis: usize) -> i64 {
        match self.sides[axis] {
            Side::Periodic([from, to]) => (((to - from) / self.width).floor() as i64).max(1),
            _ => i64::MAX,
        }
    }

    fn add(&mut self, number: usize, position: &[f64; 3]) {
        let key = std::array::from_fn(|axis| self.cell(axis, position[axis]));
        self.members.entry(key).or_default().push(number);
    }

    fn is_free(&self, position: &[f64; 3], radius: f64, grains: &[Placed]) -> bool {
        let home: [i64; 3] = std::array::from_fn(|axis| self.cell(axis, position[axis]));
        let separate = |number: &usize| {
            let other = &grains[*number];
            let square: f64 = (0..3)
                .map(|k| self.sides[k].nearest(position[k] - other.position[k]).powi(2))
                .sum();
            square > (radius + other.radius).powi(2)
        };
        (0..27).all(|step| {
            let shift = [step % 3 - 1, step / 3 % 3 - 1, step / 9 - 1];
            let key = std::array::from_fn(|axis| match self.sides[axis] {
                Side::Periodic(_) => (home[axis] + shift[axis]).rem_euclid(self.count(axis)),
                _ => home[axis] + shift[axis],
            });
            self.members.get(&key).is_none_or(|members| members.iter().all(separate))
        })
    }
}
