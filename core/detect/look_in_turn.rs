//! Whom of its neighbours may a grain meet first, looked at one after the other? Reads a list of them; writes the earliest collision found so far.
//!
//! Without the feature `alloc`: small machines compute nothing side by side, and what is known already saves
//! them the most. Whoever cannot be met before what happens anyway is left out.

use super::horizon::Motion;
use super::predictor::Predictor;
use super::scheduled_event::ScheduledEvent;
use crate::particle::Body;
use crate::scalar::Scalar;
use crate::space::NeighbourBatch;

impl<S: Scalar, const D: usize> Predictor<'_, S, D> {
    /// Takes the collisions with those of a look into account, in the images that are nearest now.
    #[inline(never)]
    pub fn batch(&self, first: &mut ScheduledEvent<S>, batch: &NeighbourBatch<'_>) {
        let same_image = batch.same_image || self.domain.boundary.is_open();
        let any = self.particles.supported > 0;
        batch.for_each(|k| {
            let other = self.particles.body(k as usize).filter(|_| k != self.filler());
            let Some(other) = other else { return };
            if any && (self.me.is_supported() || other.is_supported()) {
                self.supported(first, k as usize, other);
            } else if S::RANGE.is_some() || self.may_meet(first, other, same_image) {
                self.pair(first, k as usize, same_image);
            }
        });
    }

    /// Whether the grain may meet another before its own next event and the earliest collision known.
    ///
    /// Where they are is not rounded to a lattice: the margins allow for that. In fixed point the squares of squares
    /// may not fit.
    #[inline]
    fn may_meet(&self, first: &ScheduledEvent<S>, other: &Body<S, D>, same_image: bool) -> bool {
        let span = self.now - other.clock;
        // Half of what gravity has added, twice.
        let added = self.domain.gravity() * (span * S::half());
        let mean = other.velocity + added;
        let there = other.position + mean * span;
        let mut apart = self.here - there;
        if !same_image {
            apart = self.domain.boundary.nearest(apart);
        }
        let velocity = self.velocity - (mean + added);
        let motion = Motion::new(&apart, &velocity, self.me.radius + other.radius);
        let until = self.own.time.min(first.collision_time);
        motion.may_collide(until - self.now)
    }
}
