//! What can happen to a grain at the face of a sheared box? Reads bodies and images; writes the earliest event found so far.

use super::collision_time;
use super::predictor::Predictor;
use super::scheduled_event::{EventKind, ScheduledEvent};
use crate::particle::Body;
use crate::scalar::{Scalar, component};
use crate::space::{Boundary, Images};

impl<S: Scalar, const D: usize> Predictor<'_, S, D> {
    /// The earliest event in a sheared box: the grain may leave it through a sheared face, or meet somebody across one.
    pub fn across(&self, first: &mut ScheduledEvent<S>, images: &Images<S>) -> ScheduledEvent<S> {
        self.plates(first);
        let turns = self.meetings_across(first, images);
        let mut own = self.own;
        let leaves = leaving(images, self.me).map(|time| time.max(self.now));
        if let Some(time) = leaves.filter(|&time| time < own.time && time <= S::LAST) {
            own = ScheduledEvent::alone(time, EventKind::ShearCrossing);
        }
        let earliest = self.earliest_of(*first, &own);
        if turns < earliest.time && turns <= S::LAST {
            let (kind, face) = (EventKind::BoundarySentinel, ScheduledEvent::<S>::NO_FACE);
            return ScheduledEvent { time: turns, kind, face, ..*first };
        }
        earliest
    }

    /// Takes all into account whom the grain may meet across a sheared face. Returns until when these are the images that
    /// count.
    fn meetings_across(&self, first: &mut ScheduledEvent<S>, images: &Images<S>) -> S {
        let cells = &self.particles.cells;
        if !cells.is_at_sheared_face(&self.at) {
            return S::NEVER;
        }
        cells.for_each_across(&self.at, &mut |k, rows| {
            if let Some(other) = self.particles.body(k) {
                let me = (&self.here, self.me);
                let time =
                    collision_time::pair_across(self.domain, images, self.now, (me, other), rows);
                self.meet(first, (k, other), time);
            }
        });
        self.turn_of_images(images)
    }

    /// When another image of somebody across the face may be the nearest along the flow: the two have moved as far
    /// against each other as without shear, and half of the image's motion is each one's.
    fn turn_of_images(&self, images: &Images<S>) -> S {
        let flow = images.shear.flow;
        let Some(periodic) = self.domain.boundary.periodic(flow) else { return S::NEVER };
        let far = Boundary::<S, D>::max_displacement(&periodic, self.particles.largest_radius);
        let speed = component(&self.velocity, flow).abs() + images.speed.abs() * S::half();
        let span = far / speed;
        if span.is_finite() { self.now + span } else { S::NEVER }
    }
}

/// When a body leaves the box through a sheared face. From where its motion began: the same, whoever asks.
fn leaving<S: Scalar, const D: usize>(images: &Images<S>, body: &Body<S, D>) -> Option<S> {
    let axis = images.shear.gradient;
    let [y, v] = [&body.position, &body.velocity].map(|x| component(x, axis));
    if v == S::zero() {
        return None;
    }
    let face = images.across.low + if v > S::zero() { images.across.length } else { S::zero() };
    let span = (face - y) / v;
    span.is_finite().then(|| body.clock + span.max(S::zero()))
}
