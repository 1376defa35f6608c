//! What is an observer told of an event? Reads events and the world they happen in; writes nothing.

use super::view::View;
use crate::cluster::Transfer;
use crate::detect::EventKind;
use crate::particle::Partner;
use crate::resolve::EventOutcome;
use crate::scalar::{Instant, Scalar};

/// One event as an observer sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Event<S> {
    /// When.
    pub at: Instant,
    /// To which grain.
    pub grain: usize,
    /// With what.
    pub partner: Partner,
    /// What was due.
    pub kind: EventKind,
    /// What it did; none before it is done.
    pub outcome: Option<EventOutcome<S>>,
}

/// Sees each event just before and just after it happens. Observing changes nothing.
///
/// Implement it for your own measurements; `()` observes nothing.
pub trait Observer<S: Scalar, const D: usize> {
    /// The event is due; the grains stand where it will happen.
    fn before(&mut self, event: &Event<S>, view: View<'_, S, D>) {
        let _ = (event, view);
    }
    /// Clustered grains gave each other this in the step that is being made: between `before` and `after` of its event.
    /// Steps that a change between events cuts short ([`World::set_velocity`](super::World::set_velocity) and the like)
    /// are not told; [`Statistics::cut_steps`](super::Statistics::cut_steps) counts them.
    #[inline(always)]
    fn transferred(&mut self, transfer: &Transfer<S, D>) {
        let _ = transfer;
    }
    /// The event has happened.
    fn after(&mut self, event: &Event<S>, view: View<'_, S, D>) {
        let _ = (event, view);
    }
}

/// Nobody observes.
impl<S: Scalar, const D: usize> Observer<S, D> for () {}
