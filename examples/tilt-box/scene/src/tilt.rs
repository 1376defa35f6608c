//! Where is down? Reads an accelerometer; writes gravity in the plane of the display.

use accelerometer::Accelerometer;

use crate::scene::{G, Number};

/// A reading that differs by less than this from the one in use is noise, in g. Gravity that changes wakes what sleeps.
const DEAD_BAND: Number = 0.03;

/// An axis that is printed on the sensor's board, or the direction against it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Along x.
    X,
    /// Along y.
    Y,
    /// Along z.
    Z,
    /// Against x.
    MinusX,
    /// Against y.
    MinusY,
    /// Against z.
    MinusZ,
}

/// How the sensor is mounted beside the display.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mounting {
    /// The sensor's axis that points to the right of the picture.
    pub right: Axis,
    /// The sensor's axis that points to the top of the picture.
    pub up: Axis,
}

impl Default for Mounting {
    /// x to the right and y to the top, as on most boards.
    fn default() -> Self {
        Self { right: Axis::X, up: Axis::Y }
    }
}

/// Gravity in the plane of the display, as the accelerometer last told it.
#[derive(Clone, Debug)]
pub struct Tilt {
    mounting: Mounting,
    /// The acceleration in use, in g, along the picture's axes.
    felt: [Number; 2],
    faults: u32,
}

impl Tilt {
    /// Upright, until the first reading.
    #[must_use]
    pub fn new(mounting: Mounting) -> Self {
        Self { mounting, felt: [0.0, 1.0], faults: 0 }
    }

    /// Gravity by a new reading; by the last good one where the bus fails, and that is counted.
    ///
    /// A sensor at rest feels what holds it up, so gravity is against what it reads. Shaking counts as gravity, too: disks in a
    /// box that is pushed feel the same.
    ///
    /// # Units
    /// mm/ms².
    pub fn read(&mut self, sensor: &mut impl Accelerometer) -> [Number; 2] {
        match sensor.accel_norm() {
            Ok(reading) => self.take([reading.x, reading.y, reading.z]),
            Err(_) => self.faults = self.faults.saturating_add(1),
        }
        self.felt.map(|part| -part * G)
    }

    /// How often the sensor could not be read.
    #[must_use]
    pub fn faults(&self) -> u32 {
        self.faults
    }

    fn take(&mut self, reading: [Number; 3]) {
        let felt = [self.mounting.right, self.mounting.up].map(|axis| along(axis, reading));
        let differs = |(old, new): (&Number, &Number)| (new - old).abs() > DEAD_BAND;
        if self.felt.iter().zip(&felt).any(differs) {
            self.felt = felt;
        }
    }
}

/// The part of a reading along an axis.
fn along(axis: Axis, [x, y, z]: [Number; 3]) -> Number {
    match axis {
        Axis::X => x,
        Axis::Y => y,
        Axis::Z => z,
        Axis::MinusX => -x,
        Axis::MinusY => -y,
        Axis::MinusZ => -z,
    }
}
