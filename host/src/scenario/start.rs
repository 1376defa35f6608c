//! Where does everything stand, and who overlaps whom? Reads a scenario; writes nothing, returns grains and box at time 0.

use super::place::{self, Placed, Side, sphere_mass};
use super::spec::{Scenario, SideSpec, SurfaceSpec};
use anyhow::{Result, bail};
use carom_reference::Plate;
use std::f64::consts::PI;

/// Grains, box and gravity: the same for every method.
#[derive(Clone, Debug, PartialEq)]
pub struct Start {
    /// 1, 2 or 3.
    pub dimension: usize,
    /// The grains.
    pub grains: Vec<Placed>,
    /// The box; axes beyond the dimension are open.
    pub sides: [Side; 3],
    /// Uniform gravity.
    pub gravity: [f64; 3],
}

impl Start {
    /// Places everything.
    ///
    /// # Errors
    /// When the box has no size, or grains find no place.
    pub fn new(scenario: &Scenario) -> Result<Self> {
        let dimension = scenario.dimension;
        let sides = sides(scenario)?;
        let mut grains: Vec<Placed> = scenario
            .grains
            .iter()
            .map(|grain| Placed {
                radius: grain.radius,
                mass: grain.mass.unwrap_or_else(|| {
                    sphere_mass(grain.radius, grain.density.unwrap_or_default())
                }),
                position: padded(&grain.at),
                velocity: padded(&grain.moving),
            })
            .collect();
        if let Some(gas) = &scenario.gas {
            place::scatter(gas, dimension, &sides, &mut grains)?;
        }
        Ok(Self { dimension, grains, sides, gravity: padded(&scenario.gravity) })
    }

    /// Separation of two points, nearest image.
    pub fn nearest(&self, a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
        std::array::from_fn(|k| self.sides[k].nearest(a[k] - b[k]))
    }

    /// Mean radius of the grains.
    pub fn mean_radius(&self) -> f64 {
        self.grains.iter().map(|grain| grain.radius).sum::<f64>() / self.grains.len() as f64
    }
}

fn padded(numbers: &[f64]) -> [f64; 3] {
    std::array::from_fn(|k| numbers.get(k).copied().unwrap_or(0.0))
}

fn sides(scenario: &Scenario) -> Result<[Side; 3]> {
    let specs = [scenario.sides.x, scenario.sides.y, scenario.sides.z];
    let edge = edge(scenario);
    let mut sides = [Side::Open; 3];
    for (axis, (side, spec)) in sides.iter_mut().zip(specs).enumerate() {
        let name = ["x", "y", "z"][axis];
        *side = match spec {
            SideSpec::Open => Side::Open,
            SideSpec::Periodic { from, to } => Side::Periodic(range(name, from, to, edge)?),
            SideSpec::Walls { from, to, surface, restitution } => {
                let range = range(name, from, to, edge)?;
                match surface {
                    SurfaceSpec::Soft => Side::Soft(range),
                    SurfaceSpec::Hard => Side::Hard(range, restitution.unwrap_or(1.0)),
                }
            }
            SideSpec::Plate { at, amplitude, frequency, phase, restitution, .. } => {
                Side::Plate(Plate { at, amplitude, frequency, phase }, restitution)
            }
        };
    }
    Ok(sides)
}

/// The edge of the cube that a gas fills to its packing fraction.
fn edge(scenario: &Scenario) -> Option<f64> {
    let gas = scenario.gas.as_ref()?;
    let phi = gas.packing_fraction?;
    let filled: f64 = place::radii(gas)
        .into_iter()
        .map(|radius| match scenario.dimension {
            1 => 2.0 * radius,
            2 => PI * radius * radius,
            _ => sphere_mass(radius, 1.0),
        })
        .sum();
    Some((filled / phi).powf(1.0 / scenario.dimension as f64))
}

fn range(name: &str, from: Option<f64>, to: Option<f64>, edge: Option<f64>) -> Result<[f64; 2]> {
    match (from, to, edge) {
        (Some(from), Some(to), None) if from < to && (to - from).is_finite() => Ok([from, to]),
        (Some(from), Some(to), None) => {
            bail!("box.{name}: from is {from} and to is {to}, from must be the smaller")
        }
        (None, None, Some(edge)) => Ok([0.0, edge]),
        (None, None, None) => {
            bail!("box.{name}: give from and to [m], or gas.packing_fraction")
        }
        (_, _, Some(_)) => bail!(
            "box.{name}: gas.packing_fraction sets the size of the box; leave out from and to, or it"
        ),
        _ => bail!("box.{name}: give both from and to [m]"),
    }
}

/// Whether each grain overlaps something.
///
/// Sweeps along the first axis, so that large systems take O(N log N) as long as they are dilute.
pub fn touching(start: &Start, grains: &[Placed]) -> Vec<bool> {
    let mut flags: Vec<bool> = grains.iter().map(|grain| on_wall(start, grain)).collect();
    let widest = 2.0 * grains.iter().map(|grain| grain.radius).fold(0.0, f64::max);
    let mut order: Vec<(f64, usize)> =
        grains.iter().enumerate().map(|(i, grain)| (grain.position[0], i)).collect();
    order.sort_by(|a, b| a.0.total_cmp(&b.0));
    // A second round, one period further on, for pairs across the periodic face.
    let again: Vec<(f64, usize)> = match start.sides[0] {
        Side::Periodic([from, to]) => {
            let near = order.iter().take_while(|(x, _)| *x < from + widest);
            near.map(|(x, i)| (x + to - from, *i)).collect()
        }
        _ => Vec::new(),
    };
    for (place, (x, i)) in order.iter().enumerate() {
        let rest = order[place + 1..].iter().chain(&again);
        for (_, j) in rest.take_while(|(other, _)| other - x < widest) {
            if i != j && overlap(start, &grains[*i], &grains[*j]) {
                flags[*i] = true;
                flags[*j] = true;
            }
        }
    }
    flags
}

fn overlap(start: &Start, a: &Placed, b: &Placed) -> bool {
    let square: f64 = start.nearest(&a.position, &b.position).iter().map(|x| x * x).sum();
    square < (a.radius + b.radius).powi(2)
}

fn on_wall(start: &Start, grain: &Placed) -> bool {
    start.sides.iter().zip(grain.position).any(|(side, x)| match *side {
        Side::Soft([from, to]) => x - from < grain.radius || to - x < grain.radius,
        // Wherever a plate is now, it is not above its highest place.
        Side::Plate(plate, None) => x - plate.at - plate.amplitude < grain.radius,
        _ => false,
    })
}
