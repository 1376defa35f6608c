//! What does C see of an event and of the statistics? Reads the engine's; writes structures of C.

use carom::world::{Event, EventKind};
use carom::{Scalar, Statistics};

/// What an event was.
#[repr(i32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum carom_event_kind {
    /// Nothing happened until the time that was asked for.
    CAROM_EVENT_NONE = 0,
    /// A grain touched another, or a plane.
    CAROM_EVENT_COLLISION = 1,
    /// A contact of two ended.
    CAROM_EVENT_CONTACT_END = 2,
    /// Grains that touch several others moved a step on.
    CAROM_EVENT_STEP = 3,
    /// Something else that changes how a grain moves.
    CAROM_EVENT_OTHER = 4,
}

/// There is no such grain, or no such plane.
pub const CAROM_NOBODY: u32 = 0xFFFF_FFFF;

/// One event.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct carom_event {
    /// When, in units of time since the start.
    pub time: f64,
    /// What it was.
    pub kind: carom_event_kind,
    /// To which grain; CAROM_NOBODY if nothing happened.
    pub grain: u32,
    /// With which other grain, or CAROM_NOBODY.
    pub other: u32,
    /// With which plane, or CAROM_NOBODY.
    pub plane: u32,
}

impl carom_event {
    /// Nothing, until then.
    #[must_use]
    pub fn none(time: f64) -> Self {
        let kind = carom_event_kind::CAROM_EVENT_NONE;
        Self { time, kind, grain: CAROM_NOBODY, other: CAROM_NOBODY, plane: CAROM_NOBODY }
    }
}

impl<S: Scalar> From<Event<S>> for carom_event {
    fn from(event: Event<S>) -> Self {
        Self {
            time: event.at.as_f64(),
            kind: match event.kind {
                EventKind::Collision => carom_event_kind::CAROM_EVENT_COLLISION,
                EventKind::ContactEnd => carom_event_kind::CAROM_EVENT_CONTACT_END,
                EventKind::Step => carom_event_kind::CAROM_EVENT_STEP,
                _ => carom_event_kind::CAROM_EVENT_OTHER,
            },
            grain: number(Some(event.grain)),
            other: number(event.partner.as_grain()),
            plane: number(event.partner.as_plane()),
        }
    }
}

/// The number of a grain or plane, if there is one.
fn number(index: Option<usize>) -> u32 {
    index.and_then(|index| u32::try_from(index).ok()).unwrap_or(CAROM_NOBODY)
}

/// How often what happened.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct carom_statistics {
    /// Contacts of two grains that began, and instantaneous collisions of two.
    pub collisions: u64,
    /// The same with planes.
    pub plane_collisions: u64,
    /// Contacts of two that ended at their time: one for each grain.
    pub releases: u64,
    /// Impacts outside the table's domain, answered by the hard-sphere rule.
    pub hard_sphere: u64,
    /// Times that a grain began to be moved by the forces of all that it touches.
    pub joins: u64,
    /// Steps of such grains.
    pub steps: u64,
    /// Steps in which some two were crushed.
    pub crushed: u64,
    /// Flights into another cell.
    pub cell_crossings: u64,
}

impl From<&Statistics> for carom_statistics {
    fn from(all: &Statistics) -> Self {
        Self {
            collisions: all.collisions,
            plane_collisions: all.plane_collisions,
            releases: all.releases,
            hard_sphere: all.hard_sphere,
            joins: all.joins,
            steps: all.steps,
            crushed: all.crushed,
            cell_crossings: all.cell_crossings,
        }
    }
}
