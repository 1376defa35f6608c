//! Whom of its neighbours may a grain meet first? Reads a batch of them; writes the earliest collision found so far.

use super::predictor::Predictor;
use super::prefilter::{Kind, Prefilter};
use super::scheduled_event::ScheduledEvent;
use crate::scalar::{LANES, Scalar};
use crate::space::{BATCH, NeighbourBatch};

/// So many bytes of bodies are held by the cache next to a processor.
const CACHE: usize = 2 << 20;

impl<S: Scalar, const D: usize> Predictor<'_, S, D> {
    /// Takes the collisions with a batch into account, in the images that are nearest now.
    #[inline]
    pub fn batch(&self, first: &mut ScheduledEvent<S>, batch: &NeighbourBatch) {
        let same_image = batch.same_image || self.domain.boundary.is_open();
        match self.particles.supported {
            0 if S::RANGE.is_none() => self.prefiltered(first, batch, same_image),
            _ => self.one_by_one(first, batch, same_image),
        }
    }

    /// The same if something may support some of them, or in fixed point: there the squares of squares may
    /// not fit, and the prefilter costs what an exact test does.
    #[inline(never)]
    fn one_by_one(&self, first: &mut ScheduledEvent<S>, batch: &NeighbourBatch, same_image: bool) {
        let any = self.particles.supported > 0;
        let free = batch.only(self.filler(), |k| match self.particles.body(k as usize) {
            Some(other) if any && (self.me.is_supported() || other.is_supported()) => {
                self.supported(first, k as usize, other);
                false
            }
            _ => true,
        });
        match S::RANGE {
            None => self.prefiltered(first, &free, same_image),
            Some(_) => free.all().iter().for_each(|&k| self.pair(first, k as usize, same_image)),
        }
    }

    /// The same if nothing supports any of them. Most pairs never collide, which the prefilter tells: all of
    /// them go through it first, without a branch, and the others are solved exactly then.
    #[inline(never)]
    fn prefiltered(&self, first: &mut ScheduledEvent<S>, batch: &NeighbourBatch, same_image: bool) {
        if size_of_val(&*self.particles.bodies) > CACHE {
            self.fetch(batch);
        }
        let weightless = self.domain.is_weightless();
        // Where numbers are side by side there is a loop for each kind of neighbours, elsewhere one for all.
        match (LANES, same_image, weightless) {
            (2, true, true) => {
                self.those_that_may(first, batch, Kind { same_image: true, weightless: true });
            }
            (2, false, true) => {
                self.those_that_may(first, batch, Kind { same_image: false, weightless: true });
            }
            _ => self.those_that_may(first, batch, Kind { same_image, weightless }),
        }
    }

    /// The same for neighbours of one kind.
    #[inline(always)]
    fn those_that_may(&self, first: &mut ScheduledEvent<S>, batch: &NeighbourBatch, kind: Kind) {
        let mut may = self.sifted(batch, kind);
        while may != 0 {
            let place = may.trailing_zeros() as usize;
            may &= may - 1;
            let k = batch.all().get(place).filter(|k| **k != self.filler());
            if let Some(&k) = k {
                self.pair(first, k as usize, kind.same_image);
            }
        }
    }

    /// A bit for each place of a batch: whether the one there may collide. The grain itself may be among them.
    #[inline(always)]
    fn sifted(&self, batch: &NeighbourBatch, kind: Kind) -> u32 {
        const { assert!(BATCH <= 32) };
        let bodies = &*self.particles.bodies;
        let filter = Prefilter::new(self.now, [&self.here, &self.velocity], self.me.radius);
        let mut may = 0;
        for (number, some) in batch.groups().enumerate() {
            let others = some.map(|k| bodies.get(k as usize).unwrap_or(self.me));
            may |= filter.may_collide(self.domain, others, kind) << (number * LANES);
        }
        may
    }

    /// Reads something of every grain: all that are in no cache come at the same time.
    #[inline]
    fn fetch(&self, batch: &NeighbourBatch) {
        let bodies = batch.all().iter().filter_map(|&k| self.particles.body(k as usize));
        core::hint::black_box(bodies.fold(0, |sum, body| sum ^ body.clock.bits()));
    }
}
