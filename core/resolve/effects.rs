//! What did an event do? Its outcome, what is worth counting, and whose predictions are void; reads and writes nothing else.

use crate::law::Outcome;

/// What an event did.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum EventOutcome<S> {
    /// An instantaneous collision with this coefficient of restitution.
    Collision {
        /// ε.
        restitution: S,
    },
    /// A contact began (E^φ).
    ContactBegan(Outcome<S>),
    /// A contact ended (E^v).
    ContactEnded,
    /// A grain came to rest: on a plane, on which it may slide, or asleep among others.
    CameToRest,
    /// A grain at rest was let go.
    TookOff,
    /// A third body came before the contact's end, which was drawn forward to now.
    ContactInterrupted,
    /// The two, or the grain that touched a plane, are clustered from now on: forces decide.
    Joined,
    /// Clustered grains moved a step on.
    Stepped,
    /// The same, and the event's grain and partner were crushed: they overlapped by more than an eighth of
    /// the smaller radius, and no other two by a larger part of theirs. What presses them leaves less room
    /// than they need, or is heavier than some hundred grains.
    Crushed {
        /// By how much they overlapped in the middle of the step.
        overlap: S,
    },
    /// A grain crossed into another cell; its trajectory is the same.
    CellCrossed,
    /// A grain left a sheared box and came in at the other side: its position is displaced and its velocity changed by those
    /// of the image through whose face it went.
    ShearCrossed,
    /// Nothing: a prediction was renewed, or a grain is still supported, or two part already.
    Unchanged,
}

/// Something in an event that is worth counting.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Incident {
    /// Two grains collided, or their contact began.
    Collision,
    /// A grain and a plane did.
    PlaneCollision,
    /// A grain left a contact at its time.
    Release,
    /// A turn would have overlapped a third body.
    RotationRefused,
    /// A third body ended a contact before its time.
    Interruption,
    /// It had to wait until the contact could be ended.
    Deferral,
    /// The rule answered with the nearest impact in its domain.
    Clamped,
    /// The hard-sphere rule answered.
    HardSphere,
    /// A grain came to rest.
    Rest,
    /// A grain at rest was let go.
    TakeOff,
    /// A collision was made elastic because the last one was less than t_c or a hop time ago.
    WithinTc,
    /// A collision was made elastic because a collapse would not have ended.
    Collapse,
    /// A slow collision with a grain that gives way only as far as its supports let it.
    SupportedCollision,
    /// Grains became clustered.
    Join,
}

/// What an event leaves to be done and to be counted.
#[derive(Default)]
pub(crate) struct Effects {
    /// The grains whose events must be predicted anew. No event concerns more than four.
    pub void: heapless::Vec<usize, 4>,
    /// Which of these, a bit for each, begin a contact until whose end nobody else can touch them.
    pub alone: u8,
    /// They were at rest until now: those that lie on them must look again.
    pub woken: heapless::Vec<usize, 4>,
    /// What is worth counting. The longest list, of a grain laid down by two others, has six entries.
    pub incidents: heapless::Vec<Incident, 12>,
}

impl Effects {
    /// This grain's events must be predicted anew.
    pub fn predict_anew(&mut self, grain: usize) {
        if !self.void.contains(&grain) {
            let _ = self.void.push(grain);
        }
    }

    /// Until its contact ends nobody else can touch this grain, whose events must be predicted anew.
    pub fn stands_alone(&mut self, grain: usize) {
        let place = self.void.iter().position(|&void| void == grain);
        self.alone |= place.map_or(0, |place| 1 << place);
    }

    /// This grain was at rest until now.
    pub fn wake(&mut self, grain: usize) {
        let _ = self.woken.push(grain);
    }

    /// This is worth counting.
    pub fn count(&mut self, incident: Incident) {
        let full = self.incidents.push(incident);
        debug_assert!(full.is_ok(), "an event has more incidents than there are places");
    }
}
