//! What does the engine keep of a grain? Its state at its own clock, its contact, how it is supported; reads and writes nothing else.

use super::grain::Grain;
use super::partner::Partner;
use crate::scalar::{Scalar, Vector, vector};

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
    /// Of a clustered grain: its acceleration in the last step.
    pub(crate) velocity_change: Vector<S, D>,
    /// When the contact ends. Of a clustered grain: when it touched something last.
    pub(crate) contact_end: S,
    /// In a contact: until when no third body may end it. Of a clustered grain: since when it has been
    /// slow. Else: when the last collision was.
    pub(crate) reference_time: S,
    pub(crate) mass: S,
    /// With whom it is in contact; of a clustered grain the next clustered one.
    pub(crate) partner: Partner,
    /// Changes whenever the trajectory does, so that events predicted before can be told as stale.
    pub(crate) event_count: u32,
    /// In which cell it is.
    pub(crate) cell: u32,
    pub(crate) material: u8,
    /// The planes it rests on, a bit for each; for a grain on top of others the plate that carries them.
    pub(crate) planes: u8,
    /// How many collisions it had one right after the other; [`Body::ASLEEP`] for a grain at rest.
    pub(crate) consecutive_collisions: u16,
}

impl<S: Scalar, const D: usize> Body<S, D> {
    /// A place in memory that no grain has: all bits zero, so that a `static` needs no image in flash.
    pub(crate) const VACANT: Self = Self {
        position: vector([S::ZERO; D]),
        velocity: vector([S::ZERO; D]),
        clock: S::ZERO,
        radius: S::ZERO,
        velocity_change: vector([S::ZERO; D]),
        contact_end: S::ZERO,
        reference_time: S::ZERO,
        mass: S::ZERO,
        partner: Partner::ZERO,
        event_count: 0,
        cell: 0,
        material: 0,
        planes: 0,
        consecutive_collisions: 0,
    };

    /// An empty place among grains, for one that is added later.
    pub(crate) fn vacant(clock: S, event_count: u32) -> Self {
        let (contact_end, reference_time) = (S::NEVER, -S::NEVER);
        let partner = Partner::NOTHING;
        Self { clock, contact_end, reference_time, partner, event_count, ..Self::VACANT }
    }

    /// Whether no grain is in this place.
    pub(crate) fn is_vacant(&self) -> bool {
        self.mass == S::ZERO
    }

    /// The grain at the start of its clock, in contact with nothing.
    pub(crate) fn new(grain: &Grain<S, D>) -> Self {
        Self {
            position: grain.position,
            velocity: grain.velocity,
            clock: S::zero(),
            radius: grain.radius,
            mass: grain.mass,
            velocity_change: Vector::zeros(),
            contact_end: S::NEVER,
            reference_time: -S::NEVER,
            partner: Partner::NOTHING,
            event_count: 0,
            cell: 0,
            material: grain.material,
            planes: 0,
            consecutive_collisions: 0,
        }
    }

    /// The grain as a user describes it, at its own clock.
    pub(crate) fn as_grain(&self) -> Grain<S, D> {
        let Self { position, velocity, radius, mass, material, .. } = *self;
        Grain { position, velocity, radius, mass, material }
    }

    /// The `consecutive_collisions` of a grain at rest.
    const ASLEEP: u16 = u16::MAX;

    /// Whether something holds it against gravity.
    pub(crate) fn is_supported(&self) -> bool {
        self.planes != 0 || self.is_asleep()
    }

    /// Whether it lies still (relative to the plate that carries it, if one does).
    pub(crate) fn is_asleep(&self) -> bool {
        self.consecutive_collisions == Self::ASLEEP
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
    pub(crate) fn asleep(self) -> Self {
        Self { consecutive_collisions: Self::ASLEEP, ..self }
    }

    /// The same body, supported by nothing.
    pub(crate) fn awake(self) -> Self {
        Self {
            planes: 0,
            consecutive_collisions: if self.is_asleep() { 0 } else { self.consecutive_collisions },
            ..self
        }
    }

    /// When its last collision was.
    pub(crate) fn last_collision(&self) -> S {
        if self.in_contact() { -S::NEVER } else { self.reference_time }
    }

    /// The first field that can no longer be computed with, if there is one.
    pub(crate) fn out_of_range(&self) -> Option<&'static str> {
        let inside = |v: &Vector<S, D>| v.iter().fold(true, |inside, x| inside & x.in_range());
        if !inside(&self.position) {
            return Some("position");
        }
        if !self.contact_end.is_finite() {
            return Some("time of the contact's end");
        }
        (!inside(&self.velocity) || !inside(&self.velocity_change)).then_some("velocity")
    }

    /// Until when no third body may end the contact that it is in; zero if it is in none.
    ///
    /// Without it two contacts could end each other for ever at one instant, and soft grains in a corner
    /// would collapse as hard ones do.
    pub(crate) fn uninterruptible_until(&self) -> S {
        if self.in_contact() { self.reference_time } else { S::zero() }
    }

    /// Whether a contact of two is under way.
    pub(crate) fn in_contact(&self) -> bool {
        self.partner != Partner::NOTHING && !self.partner.is_clustered()
    }

    /// Whether it moves in steps, by the forces of all that it touches.
    pub(crate) fn is_clustered(&self) -> bool {
        self.partner.is_clustered()
    }
}

impl<S: Scalar, const D: usize> Default for Body<S, D> {
    /// An empty place in memory.
    fn default() -> Self {
        Self::new(&Grain::with_mass(S::one(), S::one()))
    }
}
