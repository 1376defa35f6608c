//! What bounds an axis of a start, and what is a grain there? Reads and writes nothing else.

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
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Side {
    /// Nothing.
    #[default]
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
pub fn sphere_mass(radius: f64, density: f64) -> f64 {
    4.0 / 3.0 * PI * radius.powi(3) * density
}

/// How much of the space of this dimension a grain fills: a length, an area or a volume.
pub fn filled(radius: f64, dimension: usize) -> f64 {
    match dimension {
        1 => 2.0 * radius,
        2 => PI * radius * radius,
        _ => sphere_mass(radius, 1.0),
    }
}
