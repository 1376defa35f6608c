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
    /// Two walls, which may vibrate together; the phase is that of both.
    Walls([f64; 2], Made, Option<Shaking>),
    /// A plate below; nothing above.
    Plate(Plate, Made),
}

/// What a wall is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Made {
    /// It follows the contact law of two of the grain's own material.
    Soft,
    /// It has this coefficient of restitution.
    Hard(f64),
    /// It follows the law of this material and the grain's.
    Of(u8),
}

/// How walls vibrate: by A₀ sin(2π (f t + φ)).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shaking {
    /// A₀.
    pub amplitude: f64,
    /// f.
    pub frequency: f64,
    /// φ, in turns.
    pub phase: f64,
}

impl Side {
    /// Where the axis begins and ends, if it does.
    pub const fn range(&self) -> Option<[f64; 2]> {
        match *self {
            Self::Open | Self::Plate(..) => None,
            Self::Periodic(range) | Self::Walls(range, ..) => Some(range),
        }
    }

    /// Where there is never a wall, if the axis has ends: a plate has one only.
    pub fn room(&self) -> [Option<f64>; 2] {
        let shaken = match self {
            Self::Walls(_, _, Some(shaking)) => shaking.amplitude.abs(),
            _ => 0.0,
        };
        match (self, self.range()) {
            (Self::Plate(plate, _), _) => [Some(plate.at + plate.amplitude.abs()), None],
            (_, Some([from, to])) => [Some(from + shaken), Some(to - shaken)],
            (_, None) => [None, None],
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
