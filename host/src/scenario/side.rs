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

impl Placed {
    /// Nobody: the place of a grain that was taken out. It keeps its number, so that those of others stay.
    pub const GONE: Self =
        Self { radius: 0.0, mass: 0.0, position: [f64::NAN; 3], velocity: [f64::NAN; 3] };

    /// Whether there is a grain.
    pub fn is_there(&self) -> bool {
        self.mass > 0.0
    }
}

/// The grains that are there, with their numbers.
pub fn present(grains: &[Placed]) -> impl Iterator<Item = (usize, &Placed)> + Clone {
    grains.iter().enumerate().filter(|(_, grain)| grain.is_there())
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

/// The steady flow of a sheared box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flow {
    /// The axis along which grains flow.
    pub along: usize,
    /// The axis along which the flow's velocity grows.
    pub gradient: usize,
    /// By how much it grows with length (1/s).
    pub rate: f64,
    /// Where it is 0: the middle of the box (m).
    pub middle: f64,
}

impl Flow {
    /// The flow's velocity where something is, along `along`.
    pub fn speed(&self, position: &[f64; 3]) -> f64 {
        self.rate * (position[self.gradient] - self.middle)
    }

    /// How far the flow has carried the nearest image of one that is so far from another along the gradient, by a time (m).
    pub fn carried(&self, sides: &[Side; 3], separation: f64, time: f64) -> f64 {
        let Side::Periodic([from, to]) = sides[self.gradient] else { return 0.0 };
        (separation / (to - from)).round() * (to - from) * self.rate * time
    }
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
