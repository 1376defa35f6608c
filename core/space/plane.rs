//! What is a wall, and where is it now? Planes at rest and vibrating plates; reads a time, writes nothing.

#[cfg(not(feature = "plates"))]
use super::no_plates::{Drift, Vibration};
use super::plane_motion::PlaneMotion;
#[cfg(feature = "plates")]
use super::plates::{Drift, Vibration};
use crate::scalar::{Instant, Scalar, Vector, dot, vector};

/// What a plane does to a grain that touches it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Surface<S> {
    /// The world's rule decides: the law with infinite mass, without rotation, for two of the grain's own material.
    Rule,
    /// An instantaneous reflection with this coefficient of restitution, whatever the rule is.
    Hard(S),
    /// The world's rule decides, for this material and the grain's.
    Material(u8),
}

impl<S: Scalar> Surface<S> {
    /// The coefficient of restitution, if the surface says one itself.
    pub(crate) fn restitution(&self) -> Option<S> {
        match *self {
            Self::Hard(restitution) => Some(restitution),
            Self::Rule | Self::Material(_) => None,
        }
    }

    /// The materials of a contact with a grain of this one.
    pub(crate) fn materials(&self, of_grain: u8) -> [u8; 2] {
        match *self {
            Self::Material(own) => [own, of_grain],
            Self::Rule | Self::Hard(_) => [of_grain; 2],
        }
    }
}

/// A plane wall: grains stay where `normal · r ≥ offset` (plus their radius).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Plane<S: Scalar, const D: usize> {
    /// Unit vector into the allowed side.
    pub normal: Vector<S, D>,
    /// Distance of the plane (of a plate's mean position) from the origin along the normal.
    pub offset: S,
    /// What it does.
    pub surface: Surface<S>,
    /// How it vibrates; none if it does not.
    pub vibration: Option<Vibration<S>>,
    /// How it goes on; none if it stands or vibrates.
    pub drift: Option<Drift<S>>,
}

#[cfg(feature = "defmt")]
impl<S: Scalar + defmt::Format, const D: usize> defmt::Format for Plane<S, D> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(
            f,
            "Plane {{ normal: {}, offset: {}, surface: {}, vibration: {}, drift: {} }}",
            self.normal.as_slice(),
            self.offset,
            self.surface,
            self.vibration,
            self.drift
        );
    }
}

impl<S: Scalar, const D: usize> Plane<S, D> {
    /// A place in memory that no plane has: all bits zero.
    pub(crate) const VACANT: Self = Self {
        normal: vector([S::ZERO; D]),
        offset: S::ZERO,
        surface: Surface::Rule,
        vibration: None,
        drift: None,
    };

    /// A plane with this unit normal, at this distance from the origin along it, at rest.
    #[must_use]
    pub fn new(normal: [S; D], offset: S, surface: Surface<S>) -> Self {
        Self { normal: Vector::from(normal), offset, surface, vibration: None, drift: None }
    }

    /// The same plane, vibrating along its normal about its offset.
    #[must_use]
    pub fn vibrating(self, vibration: Vibration<S>) -> Self {
        Self { vibration: Some(vibration), drift: None, ..self }
    }

    /// The same plane, going on steadily along its normal. It vibrates no more.
    #[must_use]
    pub fn drifting(self, drift: Drift<S>) -> Self {
        Self { drift: Some(drift), vibration: None, ..self }
    }

    /// How it vibrates, if it does. Without the feature `plates` a compiler sees that none does.
    #[inline(always)]
    pub(crate) fn vibration(&self) -> Option<Vibration<S>> {
        if cfg!(feature = "plates") { self.vibration } else { None }
    }

    /// How it goes on steadily, if it does.
    #[inline(always)]
    pub(crate) fn drift(&self) -> Option<Drift<S>> {
        if cfg!(feature = "plates") { self.drift } else { None }
    }

    /// The same plane, where a facet that moves carries it: with this normal, at this distance from a position, its point
    /// there moving so.
    #[cfg_attr(not(feature = "plates"), allow(unused_variables))]
    pub(super) fn carried(
        self,
        (normal, velocity): (Vector<S, D>, &Vector<S, D>),
        (position, distance): (&Vector<S, D>, S),
        now: S,
    ) -> Self {
        #[cfg(feature = "plates")]
        let drift = Some(Drift::passing(dot(&normal, velocity), now));
        #[cfg(not(feature = "plates"))]
        let drift = self.drift;
        let offset = dot(&normal, position) - distance;
        Self { normal, offset, drift, ..self }
    }

    /// Whether it moves.
    pub(crate) fn moves(&self) -> bool {
        self.vibration().is_some() || self.drift().is_some()
    }

    /// It never moves faster than this.
    pub(crate) fn peak_speed(&self) -> S {
        let drift = self.drift().map_or(S::zero(), |drift| drift.rate().abs());
        self.vibration().map_or(drift, |vibration| vibration.peak_speed())
    }

    /// From now on clocks count from this epoch.
    pub(super) fn set_epoch(&mut self, epoch: Instant) {
        if !cfg!(feature = "plates") {
            return;
        }
        if let Some(vibration) = &mut self.vibration {
            vibration.set_epoch(epoch);
        }
        if let Some(drift) = &mut self.drift {
            drift.set_epoch(epoch);
        }
    }

    /// The same plane, its normal of unit length to the last place if it was to five digits.
    #[inline(never)]
    pub(crate) fn with_unit_normal(self) -> Self {
        let square = dot(&self.normal, &self.normal);
        let is_near = (square - S::one()).abs() <= S::from_f32(1e-5).max(S::RESOLUTION);
        if square == S::one() || !is_near {
            return self;
        }
        Self { normal: self.normal / square.sqrt(), ..self }
    }

    /// The plane at `at` across `axis`, allowing what is above it (or below).
    pub(crate) fn across(axis: usize, at: S, above: bool, surface: Surface<S>) -> Self {
        let sign = if above { S::one() } else { -S::one() };
        let mut normal = [S::zero(); D];
        if let Some(n) = normal.get_mut(axis) {
            *n = sign;
        }
        Self::new(normal, sign * at, surface)
    }

    /// Where it is now along its normal, about its offset; a plane at rest does not move.
    pub(crate) fn motion(&self, now: S) -> PlaneMotion<S> {
        let still = PlaneMotion { place: S::zero(), speed: S::zero(), acceleration: S::zero() };
        match (self.vibration(), self.drift()) {
            (Some(vibration), _) => vibration.at(now),
            (None, Some(drift)) => drift.at(now),
            (None, None) => still,
        }
    }

    /// How far a grain of this radius, centred there, is from touching; negative if it overlaps.
    pub(crate) fn gap(&self, position: &Vector<S, D>, radius: S, now: S) -> S {
        let mean = self.mean_gap(position, radius);
        if self.moves() { mean - self.motion(now).place } else { mean }
    }

    /// How far a grain is from touching the plane's mean position.
    pub(crate) fn mean_gap(&self, position: &Vector<S, D>, radius: S) -> S {
        dot(&self.normal, position) - self.offset - radius
    }
}
