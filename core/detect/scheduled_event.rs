//! What is predicted for a grain? Its earliest event and its earliest collision; reads and writes nothing else.

use crate::particle::Partner;
use crate::scalar::Scalar;
#[cfg(doc)]
use crate::space::CellFace;

/// What a grain's next event is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum EventKind {
    /// It touches its partner: a grain or a plane (E^φ of MP13, or an instantaneous collision).
    Collision,
    /// Its contact ends (E^v of MP13).
    ContactEnd,
    /// The plate that carries it falls away faster than it falls.
    TakeOff,
    /// What supports it may have gone.
    SupportCheck,
    /// It leaves a sheared box, and its image comes in at the other side.
    ShearCrossing,
    /// It leaves its cell: other grains are near it then.
    CellCrossing,
    /// It has flown so far along a periodic axis that another image may be the nearest.
    BoundarySentinel,
    /// Its prediction reaches no further: it is made anew.
    Recheck,
    /// Clustered grains move a step on, this one the first of them.
    Step,
    /// Nothing will happen to it.
    Nothing,
}

impl EventKind {
    /// Whether it only says that a prediction must be renewed: no trajectory changes.
    #[must_use]
    pub fn is_bookkeeping(self) -> bool {
        matches!(self, Self::CellCrossing | Self::BoundarySentinel | Self::Recheck)
    }
}

/// A grain's earliest event, and its earliest collision.
///
/// A grain that comes into another cell keeps its collision: only what is ahead must be looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ScheduledEvent<S: Scalar> {
    pub(crate) time: S,
    /// When it touches its partner.
    pub(crate) collision_time: S,
    pub(crate) partner: Partner,
    /// The partner's event count when this was predicted.
    pub(crate) partner_event_count: u32,
    pub(crate) kind: EventKind,
    /// Through which face of its cell it leaves, see [`CellFace::code`]; [`ScheduledEvent::NO_FACE`] for none.
    pub(crate) face: u8,
}

impl<S: Scalar> ScheduledEvent<S> {
    /// An event that crosses no face.
    pub(crate) const NO_FACE: u8 = u8::MAX;

    /// A place in memory that no grain has: all bits zero.
    pub(crate) const VACANT: Self = Self {
        time: S::ZERO,
        collision_time: S::ZERO,
        partner: Partner::ZERO,
        partner_event_count: 0,
        kind: EventKind::Collision,
        face: 0,
    };

    /// Nothing, ever.
    pub(crate) const NONE: Self = Self {
        time: S::NEVER,
        collision_time: S::NEVER,
        partner: Partner::NOTHING,
        partner_event_count: 0,
        kind: EventKind::Nothing,
        face: Self::NO_FACE,
    };

    /// An event without a partner.
    pub(crate) fn alone(time: S, kind: EventKind) -> Self {
        Self { time, kind, ..Self::NONE }
    }

    /// A search got no further: it goes on then, from there.
    pub(crate) fn paused(time: S) -> Self {
        Self { collision_time: time, ..Self::alone(time, EventKind::Recheck) }
    }

    /// Whether it is that.
    pub(crate) fn is_pause(&self) -> bool {
        self.kind == EventKind::Recheck && self.collision_time <= self.time
    }

    /// What the event is about: nothing but the grain itself, unless it is a collision.
    pub(crate) fn with(&self) -> Partner {
        if self.kind == EventKind::Collision { self.partner } else { Partner::NOTHING }
    }

    /// Only the collision; without a partner that is a search which paused there and must go on.
    pub(crate) fn only_collision(self) -> Self {
        let kind = match self.partner {
            Partner::NOTHING if self.collision_time < S::NEVER => EventKind::Recheck,
            Partner::NOTHING => EventKind::Nothing,
            _ => EventKind::Collision,
        };
        Self { time: self.collision_time, kind, face: Self::NO_FACE, ..self }
    }
}

impl<S: Scalar> Default for ScheduledEvent<S> {
    fn default() -> Self {
        Self::NONE
    }
}
