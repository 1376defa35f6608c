//! Where does everything stand at time 0? Reads a scenario; writes nothing, returns grains and box.

use super::{Scenario, SideSpec, SurfaceSpec, place};
use anyhow::{Result, bail};
use carom_reference::Plate;
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

/// Mass of a sphere.
pub(super) fn sphere_mass(radius: f64, density: f64) -> f64 {
    4.0 / 3.0 * PI * radius.powi(3) * density
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
