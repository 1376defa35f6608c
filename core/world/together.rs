//! Did more than one collision come at this instant? Reads the queue and the pair as it was before; writes bodies and the queue.

use super::state::World;
use crate::detect::{EventKind, ScheduledEvent};
use crate::error::Error;
use crate::law::Rule;
use crate::particle::Body;
use crate::resolve::{Context, Crowd, Effects, Grains, slack};
use crate::scalar::{Scalar, Vector, max_abs};
use crate::schedule::is_tied;

/// Those who collide, how fast they are before it, and whether another event has the same time.
pub(super) struct Before<S: Scalar, const D: usize> {
    pair: [Option<usize>; 2],
    velocities: [Vector<S, D>; 2],
    is_tied: bool,
}

impl<S: Scalar, const D: usize, R: Rule<S>> World<'_, S, D, R> {
    /// What it takes to let a collision without duration happen once more, together with others; nothing where that is
    /// never done: in the papers' mode, and of grains that rotate, they come one after the other, the fastest first.
    #[inline]
    pub(super) fn before_collision(
        &self,
        grain: usize,
        event: &ScheduledEvent<S>,
    ) -> Option<Before<S, D>> {
        let settings = &self.parameters.settings;
        let may = event.kind == EventKind::Collision
            && settings.is_integrated(&self.rule)
            && settings.has_instantaneous
            && self.rule.inertia().is_none();
        may.then(|| {
            let pair = [Some(grain), event.partner.as_grain()];
            Before {
                pair,
                velocities: pair.map(|x| x.map_or(Vector::zeros(), |x| self.velocity_now(x))),
                is_tied: is_tied(&self.queue, (grain, event)),
            }
        })
    }

    /// The velocity of a grain that flies.
    #[inline]
    fn velocity_now(&self, grain: usize) -> Vector<S, D> {
        let Some(body) = self.particles.body(grain) else { return Vector::zeros() };
        match self.domain.is_weightless() {
            true => body.velocity,
            false => body.velocity + self.domain.gravity() * (self.clock.now - body.clock),
        }
    }

    /// The same collision with all others of this instant that share a grain with it, if there are such.
    #[inline]
    pub(super) fn collide_together(&mut self, before: &Before<S, D>) -> Result<(), Error> {
        let mut pair = before.pair.iter().flatten();
        if before.is_tied || pair.any(|&grain| self.collides_again(grain)) {
            return self.gather(before);
        }
        Ok(())
    }

    /// Whether the next event of a grain is a collision before it has moved visibly.
    #[inline]
    fn collides_again(&self, grain: usize) -> bool {
        let (event, now) = (self.queue.event(grain), self.clock.now);
        let Some(body) = self.particles.body(grain).filter(|_| event.kind == EventKind::Collision)
        else {
            return false;
        };
        let span = event.time - now;
        span <= now.rounding() * S::from_f32(8.0) || max_abs(&body.velocity) * span <= slack(body)
    }

    #[inline(never)]
    fn gather(&mut self, before: &Before<S, D>) -> Result<(), Error> {
        let mut effects = Effects::default();
        let mut context = Context {
            particles: &mut self.particles,
            domain: &self.domain,
            clock: &self.clock,
            parameters: &mut self.parameters,
            clusters: &mut self.clusters,
            effects: &mut effects,
        };
        let pair = before.pair.iter().zip(&before.velocities);
        let first = pair.filter_map(|(&grain, &velocity)| {
            grain.map(|grain| (grain, Body { velocity, ..context.present(grain) }))
        });
        let Some(crowd) = Crowd::gather(&context, &self.rule, first) else { return Ok(()) };
        let (grains, [pairs, walls]) = crowd.happen(&mut context);
        // One of them has been counted.
        let with_plane = before.pair.iter().flatten().count() == 1;
        self.statistics.collisions += pairs - u64::from(!with_plane).min(pairs);
        self.statistics.plane_collisions += walls - u64::from(with_plane).min(walls);
        self.predict_all_of(&grains)
    }

    fn predict_all_of(&mut self, grains: &Grains) -> Result<(), Error> {
        for &grain in grains {
            self.check_range(grain)?;
            let event = self.predict(grain);
            self.queue.set(grain, event);
        }
        Ok(())
    }
}
