//! What does an event see and change? The bodies, the space they are in, the present, the counters.

use crate::matter::{Body, Boundary, Partner, flight};
use crate::number::{Instant, Scalar, Vector};

/// How a contact ends for its two grains when a third body interrupts it (MP13 §VI.B.5, exception b).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Release {
    /// Both grains are released at once: angular momentum is kept.
    #[default]
    Paired,
    /// Only the one that is hit is released; its partner goes on until the contact's own end.
    Independent,
}

/// How often everything happened. Nothing is lost silently: what is not plain is counted here.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Counters {
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
    /// Encounters outside the table's domain answered with the nearest inside.
    pub clamped: u64,
    /// Encounters outside the table's domain answered with the hard-sphere rule.
    pub hard_sphere: u64,
    /// Predicted events that another event had made void.
    pub stale: u64,
    /// Looks at the neighbours again after a long flight in a periodic box.
    pub leashes: u64,
    /// Times the clock was set back so as not to lose precision.
    pub epochs: u64,
}

impl Counters {
    /// All events that change a trajectory.
    #[must_use]
    pub fn events(&self) -> u64 {
        self.collisions + self.plane_collisions + self.releases + self.interrupted
    }
}

/// Everything but the queue.
pub(crate) struct Scene<'m, S: Scalar, const D: usize> {
    pub bodies: &'m mut [Body<S, D>],
    pub boundary: Boundary<S, D>,
    pub gravity: Vector<S, D>,
    /// The present, after the epoch.
    pub now: S,
    /// The instant from which clocks count.
    pub epoch: Instant,
    pub largest_radius: S,
    pub release: Release,
    pub counters: Counters,
}

impl<S: Scalar, const D: usize> Scene<'_, S, D> {
    /// The body as it is now. An index out of range gives an empty place; none is ever asked for.
    pub fn present(&self, grain: usize) -> Body<S, D> {
        match self.bodies.get(grain) {
            Some(body) => flight::at(body, &self.gravity, self.now),
            None => Body::default(),
        }
    }

    /// The body as it was kept, at its own clock.
    pub fn body(&self, grain: usize) -> Option<&Body<S, D>> {
        self.bodies.get(grain)
    }

    /// Writes a body whose trajectory changed: inside the box, events predicted for it void.
    pub fn place(&mut self, grain: usize, mut body: Body<S, D>) {
        body.position = self.boundary.wrap(body.position);
        body.stamp = body.stamp.wrapping_add(1);
        if let Some(place) = self.bodies.get_mut(grain) {
            *place = body;
        }
    }

    /// The instant that the present is.
    pub fn instant(&self) -> Instant {
        self.epoch + Instant::from(self.now)
    }

    /// Separation (nearest image) and distance of the surfaces of two bodies at the same time.
    pub fn separation(&self, a: &Body<S, D>, b: &Body<S, D>) -> Vector<S, D> {
        self.boundary.nearest(a.position - b.position)
    }

    /// Whether the two are in contact with each other.
    pub fn bound(&self, a: usize, b: usize) -> bool {
        let partner = |i: usize| self.body(i).map_or(Partner::NOTHING, |x| x.partner);
        partner(a) == Partner::grain(b) && partner(b) == Partner::grain(a)
    }

    /// Whether `grain` can stand at `position`: it overlaps nothing but `except` more than it does now.
    pub fn is_free(&self, grain: usize, position: Vector<S, D>, except: Partner) -> bool {
        let me = self.present(grain);
        let mut others = self.bodies.iter().enumerate();
        self.free_of_planes(&me, position, except)
            && others.all(|(k, other)| {
                k == grain || Partner::grain(k) == except || self.free_of(&me, position, other)
            })
    }

    /// Whether `me` at `position` keeps clear of another body, wherever that is now.
    fn free_of(&self, me: &Body<S, D>, position: Vector<S, D>, other: &Body<S, D>) -> bool {
        let there = flight::position_after(other, &self.gravity, self.now - other.clock);
        let reach = me.radius + other.radius;
        let then = self.boundary.nearest(position - there);
        if then.dot(&then) >= reach * reach {
            return true;
        }
        let before = self.boundary.nearest(me.position - there);
        then.dot(&then) >= before.dot(&before)
    }

    fn free_of_planes(&self, me: &Body<S, D>, position: Vector<S, D>, except: Partner) -> bool {
        let planes = self.boundary.planes().iter().enumerate();
        planes.filter(|&(p, _)| Partner::plane(p) != except).all(|(_, plane)| {
            let then = plane.gap(&position, me.radius);
            then >= S::zero() || then >= plane.gap(&me.position, me.radius)
        })
    }
}
