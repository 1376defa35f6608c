//! Where is a vibrating plate? Reads a time; writes its height, velocity and acceleration.

use std::f64::consts::TAU;

use crate::error::{ReferenceError, zero_or_more};

/// A plane across an axis, z_0(t) = z + A_0 sin(2π (f t + phase)) (L94 Eq. 1); grains are above it.
///
/// # Units
///
/// Lengths in m, frequency in Hz, phase in turns.
///
/// # Examples
///
/// ```
/// use carom_reference::Plate;
/// let plate = Plate { amplitude: 1e-3, frequency: 20.0, ..Plate::fixed(0.5) };
/// assert_eq!(plate.height(0.0), 0.5);
/// assert!((plate.height(1.0 / 80.0) - 0.501).abs() < 1e-15);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Plate {
    /// Its middle height.
    pub at: f64,
    /// A_0 ≥ 0.
    pub amplitude: f64,
    /// f ≥ 0.
    pub frequency: f64,
    /// Where in its period it starts, in turns.
    pub phase: f64,
}

impl Plate {
    /// A plate at rest.
    #[inline]
    pub const fn fixed(at: f64) -> Self {
        Self { at, amplitude: 0.0, frequency: 0.0, phase: 0.0 }
    }

    /// Whether it moves.
    #[inline]
    pub(crate) fn moves(&self) -> bool {
        self.amplitude > 0.0 && self.frequency > 0.0
    }

    #[inline]
    fn sin_cos(&self, t: f64) -> (f64, f64) {
        let turns = self.frequency * t + self.phase;
        libm::sincos(TAU * (turns - turns.round()))
    }

    /// z_0.
    #[inline]
    pub fn height(&self, t: f64) -> f64 {
        if self.amplitude == 0.0 {
            return self.at;
        }
        self.at + self.amplitude * self.sin_cos(t).0
    }

    /// dz_0/dt.
    #[inline]
    pub fn velocity(&self, t: f64) -> f64 {
        if self.amplitude == 0.0 {
            return 0.0;
        }
        self.fastest() * self.sin_cos(t).1
    }

    /// d²z_0/dt².
    #[inline]
    pub fn acceleration(&self, t: f64) -> f64 {
        if self.amplitude == 0.0 {
            return 0.0;
        }
        -self.fastest() * TAU * self.frequency * self.sin_cos(t).0
    }

    /// A_0 ω, its largest speed.
    #[inline]
    pub fn fastest(&self) -> f64 {
        self.amplitude * TAU * self.frequency
    }

    pub(crate) fn check(&self) -> Result<(), ReferenceError> {
        for (field, value) in [("plate.at", self.at), ("plate.phase", self.phase)] {
            if !value.is_finite() {
                return Err(ReferenceError::parameter(field, value, "finite"));
            }
        }
        zero_or_more("plate.amplitude", self.amplitude)?;
        zero_or_more("plate.frequency", self.frequency)
    }
}
