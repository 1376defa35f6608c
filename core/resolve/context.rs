//! What does an event see and change? Particles and effects to write, domain, clock and parameters to read.

use super::effects::{Effects, Incident};
use super::parameters::Parameters;
use crate::cluster::{self, Clusters};
use crate::particle::Body;
use crate::scalar::{Clock, Scalar, Vector};
use crate::space::{Domain, Particles, flight};

/// What the resolution of one event works on.
pub(crate) struct Context<'a, 'm, S: Scalar, const D: usize> {
    pub particles: &'a mut Particles<'m, S, D>,
    pub domain: &'a Domain<'m, S, D>,
    pub clock: &'a Clock<S>,
    pub parameters: &'a mut Parameters<S, D>,
    pub clusters: &'a mut Clusters<S>,
    pub effects: &'a mut Effects,
}

impl<S: Scalar, const D: usize> Context<'_, '_, S, D> {
    /// The time of the event.
    #[inline]
    pub fn now(&self) -> S {
        self.clock.now
    }

    /// A body as it is now.
    #[inline]
    pub fn present(&self, grain: usize) -> Body<S, D> {
        self.particles.present(grain, self.domain, self.clock.now)
    }

    /// Two bodies as they are now: copied once.
    #[cfg_attr(target_pointer_width = "64", inline)]
    #[cfg_attr(not(target_pointer_width = "64"), inline(never))]
    pub fn both_present(&self, who: [usize; 2]) -> [Body<S, D>; 2] {
        let [Some(a), Some(b)] = [self.particles.body(who[0]), self.particles.body(who[1])] else {
            return [Body::default(); 2];
        };
        let mut pair = [*a, *b];
        pair.iter_mut().for_each(|body| flight::advance(body, self.domain, self.clock.now));
        pair
    }

    /// A grain that is here now moves on with another velocity; one more collision in a row, or the first of a row.
    /// Where it flew further than a box is long it may be beside the lattice of the boundary's axes.
    #[cfg_attr(target_pointer_width = "64", inline)]
    #[cfg_attr(not(target_pointer_width = "64"), inline(never))]
    pub fn kick(&mut self, grain: usize, [position, velocity]: [Vector<S, D>; 2], in_a_row: bool) {
        let (now, position) = (self.clock.now, self.domain.boundary.to_lattice(position));
        self.particles.change(grain, |body| {
            (body.position, body.velocity) = (position, velocity);
            (body.clock, body.reference_time) = (now, now);
            let one_more = body.consecutive_collisions.saturating_add(1);
            body.consecutive_collisions = if in_a_row { one_more } else { 0 };
        });
    }

    /// Writes a body whose velocity changed.
    pub fn replace(&mut self, grain: usize, body: Body<S, D>) {
        self.particles.replace(&self.domain.boundary, grain, body);
    }

    /// Writes a body that was put somewhere else, at its own clock.
    pub fn relocate(&mut self, grain: usize, body: Body<S, D>) {
        self.particles.relocate(&self.domain.boundary, (grain, body.clock), body);
    }

    /// The same for one that is inside the box along the gradient of a shear.
    pub fn put_inside(&mut self, grain: usize, body: Body<S, D>) {
        self.particles.put_inside(&self.domain.boundary, grain, body);
    }

    /// A grain is clustered from now on.
    pub fn join(&mut self, grain: usize) {
        let now = self.clock.now;
        cluster::join(self.particles, self.domain, self.clusters, (grain, now));
    }

    /// Something happened that is worth counting.
    pub fn count(&mut self, incident: Incident) {
        self.effects.count(incident);
    }
}
