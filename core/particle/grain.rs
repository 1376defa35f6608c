//! What is a grain? What the user describes and what a world shows; reads and writes nothing else.

use crate::scalar::{Scalar, Vector};

/// A grain as the user describes it, and as the world shows it.
///
/// # Units
/// Any consistent ones; SI in all examples. `position` and `velocity` have `D` components.
///
/// ```
/// use carom::Grain;
/// let steel = Grain::sphere(1.0e-3, 7800.0).at([0.0, 0.02]).moving([0.1, 0.0]);
/// assert!((steel.mass - 3.267e-5_f64).abs() < 1e-8);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Grain<S: Scalar, const D: usize> {
    /// Centre.
    pub position: Vector<S, D>,
    /// Velocity of the centre.
    pub velocity: Vector<S, D>,
    /// Radius R > 0.
    pub radius: S,
    /// Mass m > 0.
    pub mass: S,
    /// Which material it is made of, for rules that differ by pair of materials.
    pub material: u8,
}

#[cfg(feature = "defmt")]
impl<S: Scalar + defmt::Format, const D: usize> defmt::Format for Grain<S, D> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(
            f,
            "Grain {{ position: {}, velocity: {}, radius: {}, mass: {}, material: {=u8} }}",
            self.position.as_slice(),
            self.velocity.as_slice(),
            self.radius,
            self.mass,
            self.material
        );
    }
}

impl<S: Scalar, const D: usize> Grain<S, D> {
    /// A sphere of this radius and mass density, at rest at the origin.
    ///
    /// It is a sphere (mass 4/3 π R³ ρ) in one and two dimensions as well: a bead on a wire, a ball
    /// between two plates. Use [`Grain::with_mass`] for anything else.
    #[must_use]
    pub fn sphere(radius: S, density: S) -> Self {
        let volume = S::from_f64(4.0 / 3.0 * core::f64::consts::PI) * radius * radius * radius;
        Self::with_mass(radius, volume * density)
    }

    /// A grain of this radius and mass, at rest at the origin.
    #[must_use]
    pub fn with_mass(radius: S, mass: S) -> Self {
        Self { position: Vector::zeros(), velocity: Vector::zeros(), radius, mass, material: 0 }
    }

    /// The same grain, centred there.
    #[must_use]
    pub fn at(self, position: [S; D]) -> Self {
        Self { position: Vector::from(position), ..self }
    }

    /// The same grain, moving so.
    #[must_use]
    pub fn moving(self, velocity: [S; D]) -> Self {
        Self { velocity: Vector::from(velocity), ..self }
    }

    /// The same grain, made of that material.
    #[must_use]
    pub fn of_material(self, material: u8) -> Self {
        Self { material, ..self }
    }
}
