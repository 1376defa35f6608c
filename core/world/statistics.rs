//! How often did everything happen? Reads what events did; writes counters that nobody who computes reads.

use crate::detect::EventKind;
use crate::resolve::Incident;

/// How often everything happened. Nothing is lost silently: what is not plain is counted here.
///
/// Counting changes nothing: the future of a world does not depend on its statistics.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct Statistics {
    /// Contacts of two grains that began (E^φ), or instantaneous collisions of two grains.
    pub collisions: u64,
    /// The same with a plane.
    pub plane_collisions: u64,
    /// Contacts that ended at their time (E^v): one for each grain.
    pub releases: u64,
    /// MP13's exception (a): the turn would have overlapped a third body, so the hard-sphere rule was used.
    pub rotation_refused: u64,
    /// MP13's exception (b): a third body ended a contact before its time.
    pub interrupted: u64,
    /// Those of them that had to wait until a 64th of the contact's duration had passed.
    pub deferred: u64,
    /// Impacts outside the table's domain answered with the nearest inside.
    pub clamped: u64,
    /// Impacts outside the table's domain answered with the hard-sphere rule, and contacts with a plane
    /// so long that gravity would pull the grain off it.
    pub hard_sphere: u64,
    /// Grains that came to rest, on a plane or on others.
    pub rests: u64,
    /// Grains at rest that were let go: their plate fell away faster than they fall, or they were hit.
    pub take_offs: u64,
    /// Collisions made elastic because the last one was less than t_c ago (the TC rule), or, of slow
    /// ones under gravity in two and three dimensions, less than the shortest hop time.
    pub within_tc: u64,
    /// Collisions made elastic because a collapse would not have ended.
    pub collapses: u64,
    /// Slow collisions with a grain at rest, which gave way only as far as its supports let it.
    pub supported_collisions: u64,
    /// Times that grains became clustered by touching something.
    pub joins: u64,
    /// Steps of clustered grains.
    pub steps: u64,
    /// Steps of clustered grains that a change between events ended: observers were not told what they did.
    pub cut_steps: u64,
    /// Steps in which some two were [crushed](crate::resolve::EventOutcome::Crushed).
    pub crushed: u64,
    /// Collisions put before others of the same instant because they were faster (LRV).
    pub reordered: u64,
    /// Predicted events that another event had made void.
    pub stale: u64,
    /// Flights into another cell.
    pub cell_crossings: u64,
    /// Predictions renewed because they reached no further, or because a grain had flown far along a
    /// periodic axis.
    pub rechecks: u64,
    /// Times the clock was set back so as not to lose precision.
    pub epochs: u64,
}

impl Statistics {
    /// All events that change a trajectory.
    #[must_use]
    pub fn events(&self) -> u64 {
        self.collisions + self.plane_collisions + self.releases + self.interrupted
    }

    /// Counts an event that only renews a prediction, by its kind.
    pub(super) fn count_bookkeeping(&mut self, kind: EventKind) {
        match kind {
            EventKind::CellCrossing => self.cell_crossings += 1,
            EventKind::BoundarySentinel | EventKind::Recheck => self.rechecks += 1,
            _ => {}
        }
    }

    /// Counts what happened in an event.
    pub(super) fn count(&mut self, incidents: &[Incident]) {
        for incident in incidents {
            *self.counter(*incident) += 1;
        }
    }

    fn counter(&mut self, incident: Incident) -> &mut u64 {
        match incident {
            Incident::Collision => &mut self.collisions,
            Incident::PlaneCollision => &mut self.plane_collisions,
            Incident::Release => &mut self.releases,
            Incident::RotationRefused => &mut self.rotation_refused,
            Incident::Interruption => &mut self.interrupted,
            Incident::Deferral => &mut self.deferred,
            Incident::Clamped => &mut self.clamped,
            Incident::HardSphere => &mut self.hard_sphere,
            Incident::Rest => &mut self.rests,
            Incident::TakeOff => &mut self.take_offs,
            Incident::WithinTc => &mut self.within_tc,
            Incident::Collapse => &mut self.collapses,
            Incident::Join => &mut self.joins,
            Incident::SupportedCollision => &mut self.supported_collisions,
        }
    }

    /// The largest of all.
    pub(super) fn max(&self) -> u64 {
        let Self { collisions, plane_collisions, releases, rotation_refused, .. } = *self;
        let Self { interrupted, deferred, clamped, hard_sphere, stale, .. } = *self;
        let Self { cell_crossings, rechecks, epochs, reordered, .. } = *self;
        let Self { joins, steps, cut_steps, crushed, .. } = *self;
        let Self { rests, take_offs, within_tc, collapses, supported_collisions, .. } = *self;
        let contacts = [collisions, plane_collisions, releases, rotation_refused, interrupted];
        let answers = [deferred, clamped, hard_sphere, stale, reordered];
        let looks = [cell_crossings, rechecks, epochs, rests, take_offs];
        let slow = [within_tc, collapses, supported_collisions];
        let clusters = [joins, steps, cut_steps, crushed];
        let all = contacts.into_iter().chain(answers).chain(looks).chain(slow).chain(clusters);
        all.fold(0, u64::max)
    }
}
