//! What is a grain? What the user describes and what the engine keeps of it; reads and writes nothing else.

use crate::number::{Scalar, Vector};

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

/// What a grain is in contact with, or what its next event is about: one word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Partner(u32);

impl Partner {
    const FIRST_PLANE: u32 = u32::MAX - 255;
    /// Nothing at all.
    pub const NOTHING: Self = Self(u32::MAX);
    /// The most grains a world can hold: the words above name planes.
    pub const MOST_GRAINS: usize = Self::FIRST_PLANE as usize;

    /// The grain with this number.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, reason = "setup refuses more than MOST_GRAINS")]
    pub fn grain(index: usize) -> Self {
        Self(index as u32)
    }

    /// The plane with this number.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, reason = "there are at most a handful of planes")]
    pub fn plane(index: usize) -> Self {
        Self(Self::FIRST_PLANE + index as u32)
    }

    /// The grain's number, if it is a grain.
    #[must_use]
    pub fn as_grain(self) -> Option<usize> {
        (self.0 < Self::FIRST_PLANE).then_some(self.0 as usize)
    }

    /// The plane's number, if it is a plane.
    #[must_use]
    pub fn as_plane(self) -> Option<usize> {
        let number = self.0.checked_sub(Self::FIRST_PLANE)?;
        (self != Self::NOTHING).then_some(number as usize)
    }

    /// The word itself, for a digest.
    #[must_use]
    pub fn word(self) -> u32 {
        self.0
    }
}

/// A grain as the engine keeps it: its state at its own clock, and the contact it is in.
///
/// The first four fields say all about a free flight: in three dimensions of `f64` they are 64 bytes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(target_pointer_width = "64", repr(C, align(64)))]
#[cfg_attr(not(target_pointer_width = "64"), repr(C))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Body<S: Scalar, const D: usize> {
    pub(crate) position: Vector<S, D>,
    pub(crate) velocity: Vector<S, D>,
    /// The time, since the world's epoch, at which position and velocity hold.
    pub(crate) clock: S,
    pub(crate) radius: S,
    /// What the contact's end (E^v) adds to the velocity. For a plane: the normal velocity's new value.
    pub(crate) release: Vector<S, D>,
    /// When the contact ends.
    pub(crate) release_at: S,
    /// In a contact: until when no third body may end it. Else: when the last collision was.
    pub(crate) moment: S,
    pub(crate) mass: S,
    /// With whom it is in contact.
    pub(crate) partner: Partner,
    /// Changes whenever the trajectory does, so that events predicted before can be told as stale.
    pub(crate) stamp: u32,
    /// In which cell it is.
    pub(crate) cell: u32,
    pub(crate) material: u8,
    /// The planes it rests on, a bit for each; for a grain on top of others the plate that carries them.
    pub(crate) planes: u8,
    /// How many collisions it had one right after the other; [`Body::FROZEN`] for a grain at rest.
    pub(crate) burst: u16,
}

impl<S: Scalar, const D: usize> Body<S, D> {
    /// The grain at the start of its clock, in contact with nothing.
    pub(crate) fn new(grain: &Grain<S, D>) -> Self {
        Self {
            position: grain.position,
            velocity: grain.velocity,
            clock: S::zero(),
            radius: grain.radius,
            mass: grain.mass,
            release: Vector::zeros(),
            release_at: S::NEVER,
            moment: -S::NEVER,
            partner: Partner::NOTHING,
            stamp: 0,
            cell: 0,
            material: grain.material,
            planes: 0,
            burst: 0,
        }
    }

    /// The grain as a user describes it, at its own clock.
    pub(crate) fn as_grain(&self) -> Grain<S, D> {
        let Self { position, velocity, radius, mass, material, .. } = *self;
        Grain { position, velocity, radius, mass, material }
    }

    /// The `burst` of a grain at rest.
    const FROZEN: u16 = u16::MAX;

    /// Whether something holds it against gravity.
    pub(crate) fn is_held(&self) -> bool {
        self.planes != 0 || self.is_frozen()
    }

    /// Whether it lies still (relative to the plate that carries it, if one does).
    pub(crate) fn is_frozen(&self) -> bool {
        self.burst == Self::FROZEN
    }

    /// Whether it rests on this plane.
    pub(crate) fn rests_on(&self, plane: usize) -> bool {
        u8::try_from(plane).is_ok_and(|p| self.planes.checked_shr(p.into()).unwrap_or(0) & 1 == 1)
    }

    /// The same body at rest on this plane, too.
    pub(crate) fn resting_on(self, plane: usize) -> Self {
        Self { planes: self.planes | 1_u8.checked_shl(plane as u32).unwrap_or(0), ..self }
    }

    /// The same body, lying still.
    pub(crate) fn frozen(self) -> Self {
        Self { burst: Self::FROZEN, ..self }
    }

    /// The same body, held by nothing.
    pub(crate) fn let_go(self) -> Self {
        Self { planes: 0, burst: if self.is_frozen() { 0 } else { self.burst }, ..self }
    }

    /// When its last collision was.
    pub(crate) fn last_collision(&self) -> S {
        if self.in_contact() { -S::NEVER } else { self.moment }
    }

    /// Whether a contact is under way.
    pub(crate) fn in_contact(&self) -> bool {
        self.partner != Partner::NOTHING
    }
}

impl<S: Scalar, const D: usize> Default for Body<S, D> {
    /// An empty place in memory.
    fn default() -> Self {
        Self::new(&Grain::with_mass(S::one(), S::one()))
    }
}
