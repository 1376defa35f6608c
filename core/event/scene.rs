//! What does an event see and change? The bodies, the space they are in, the present, the counters.

use crate::fault::{Fault, Subject};
use crate::matter::cells::Cells;
use crate::matter::grid::{Grid, Stride};
use crate::matter::{Body, Boundary, Field, Partner, flight};
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
    /// Those of them that had to wait until a 64th of the contact's duration had passed.
    pub put_off: u64,
    /// Encounters outside the table's domain answered with the nearest inside.
    pub clamped: u64,
    /// Encounters outside the table's domain answered with the hard-sphere rule, and contacts with a plane
    /// so long that gravity would pull the grain off it.
    pub hard_sphere: u64,
    /// Grains that came to rest, on a plane or on others.
    pub rests: u64,
    /// Grains at rest that were let go: their plate fell away faster than they fall, or they were hit.
    pub take_offs: u64,
    /// Collisions made elastic because the last one was less than t_c ago (the TC rule), or, of slow
    /// ones under gravity in two and three dimensions, less than the hop time.
    pub within_tc: u64,
    /// Collisions made elastic because a collapse would not have ended.
    pub collapses: u64,
    /// Slow collisions with a grain at rest, which gave way only as far as its supports let it.
    pub propped: u64,
    /// Collisions put before others of the same instant because they were faster (LRV).
    pub reordered: u64,
    /// Predicted events that another event had made void.
    pub stale: u64,
    /// Flights into another cell, or so far that the neighbours had to be looked at again.
    pub wanderings: u64,
    /// Times the clock was set back so as not to lose precision.
    pub epochs: u64,
}

impl Counters {
    /// The largest of all.
    pub(crate) fn largest(&self) -> u64 {
        let Self { collisions, plane_collisions, releases, rotation_refused, .. } = *self;
        let Self { interrupted, put_off, clamped, hard_sphere, stale, wanderings, epochs, .. } =
            *self;
        let Self { rests, take_offs, within_tc, collapses, propped, reordered, .. } = *self;
        let first = [collisions, plane_collisions, releases, rotation_refused, interrupted];
        let rest = [put_off, clamped, hard_sphere, stale, wanderings, epochs];
        let calm = [rests, take_offs, within_tc, collapses, propped, reordered];
        first.into_iter().chain(rest).chain(calm).fold(0, u64::max)
    }

    /// All events that change a trajectory.
    #[must_use]
    pub fn events(&self) -> u64 {
        self.collisions + self.plane_collisions + self.releases + self.interrupted
    }
}

/// Everything but the queue.
pub(crate) struct Scene<'m, S: Scalar, const D: usize> {
    pub bodies: &'m mut [Body<S, D>],
    pub cells: Cells<'m, S, D>,
    pub boundary: Boundary<'m, S, D>,
    pub gravity: Vector<S, D>,
    /// Whether gravity is zero.
    pub weightless: bool,
    /// The present, after the epoch.
    pub now: S,
    /// The instant from which clocks count.
    pub epoch: Instant,
    pub largest_radius: S,
    pub release: Release,
    /// The TC rule's contact duration t_c; 0 without the rule.
    pub t_c: S,
    /// Hops shorter than this are none, see [`super::support::hop`].
    pub hop: S,
    /// How many bodies something holds against gravity.
    pub held: usize,
    pub counters: Counters,
}

impl<S: Scalar, const D: usize> Scene<'_, S, D> {
    /// The body as it is now. An index out of range gives an empty place; none is ever asked for.
    pub fn present(&self, grain: usize) -> Body<S, D> {
        match self.bodies.get(grain) {
            Some(body) => flight::at(body, self.field(), self.now),
            None => Body::default(),
        }
    }

    /// What moves grains between events.
    pub fn field(&self) -> Field<'_, S, D> {
        Field { gravity: &self.gravity, weightless: self.weightless, boundary: &self.boundary }
    }

    /// How fast plane `p` moves along its normal now.
    pub fn speed_of(&self, p: usize) -> S {
        self.boundary.planes().get(p).map_or(S::zero(), |plane| plane.motion(self.now).speed)
    }

    /// The body as it was kept, at its own clock.
    pub fn body(&self, grain: usize) -> Option<&Body<S, D>> {
        self.bodies.get(grain)
    }

    /// Writes a body whose velocity changed: events predicted for it are void.
    pub fn place(&mut self, grain: usize, mut body: Body<S, D>) {
        body.stamp = body.stamp.wrapping_add(1);
        body.position = self.boundary.on_lattice(body.position);
        if let Some(place) = self.bodies.get_mut(grain) {
            self.held -= usize::from(place.is_held());
            self.held += usize::from(body.is_held());
            *place = body;
        }
    }

    /// Writes a body that was put somewhere else: inside the box and in its new cell, too.
    pub fn relocate(&mut self, grain: usize, mut body: Body<S, D>) {
        body.position = self.boundary.wrap(body.position);
        if let Some(cell) = self.cells.grid.as_ref().map(|grid| grid.locate(&body.position))
            && cell != body.cell
        {
            self.cells.remove(grain, body.cell);
            self.cells.insert(grain, cell);
            body.cell = cell;
        }
        self.place(grain, body);
    }

    /// Lets a grain cross into the next cell. Its trajectory stays the same; only its image may change.
    pub fn cross(&mut self, grain: usize, stride: Stride) {
        let Some(body) = self.bodies.get_mut(grain) else { return };
        let from = body.cell;
        let next = self.cells.grid.as_ref().and_then(|grid| grid.stride(from, stride));
        let Some((cell, turns)) = next else { return };
        body.cell = cell;
        let length = self.boundary.periodic(stride.axis).map_or(S::zero(), |p| p.length);
        if let Some(x) = body.position.get_mut(stride.axis).filter(|_| turns != S::zero()) {
            *x += turns * length;
        }
        self.cells.remove(grain, from);
        self.cells.insert(grain, cell);
    }

    /// Without cells: a grain at the end of its leash is brought back into the box.
    pub fn rein_in(&mut self, grain: usize) {
        let now = self.present(grain).position;
        let shift = self.boundary.wrap(now) - now;
        if let Some(body) = self.bodies.get_mut(grain) {
            body.position += shift;
        }
    }

    /// Puts every grain into its cell, by its position at the start.
    pub fn fill_cells(&mut self) {
        for (i, body) in self.bodies.iter_mut().enumerate() {
            if let Some(grid) = &self.cells.grid {
                body.cell = grid.locate(&body.position);
                self.cells.insert(i, body.cell);
            }
        }
    }

    /// Takes over a saved grid and puts every grain into the cell it says it is in.
    pub fn take_grid(&mut self, grid: Option<Grid<S, D>>) -> Result<(), Fault> {
        let reach = self.largest_radius + self.largest_radius;
        let fits = grid.as_ref().is_none_or(|grid| grid.fits(&self.boundary, reach));
        if !(fits && self.cells.start(grid)) {
            let knob = "the saved cells do not fit the box or the heads of the memory, which";
            return Err(Fault::Full { knob, capacity: self.cells.capacity() });
        }
        for i in 0..self.bodies.len() {
            let body = self.present(i);
            if !grid.as_ref().is_none_or(|grid| grid.holds(body.cell, &body.position)) {
                let wanted = "the number of the cell that it is in";
                return Err(Fault::input(Subject::Grain(i), "cell", f64::from(body.cell), wanted));
            }
            if grid.is_some() {
                self.cells.insert(i, body.cell);
            }
        }
        Ok(())
    }

    /// The instant that the present is.
    pub fn instant(&self) -> Instant {
        self.epoch + Instant::from(self.now)
    }

    /// Separation (nearest image) of two bodies at the same time.
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
        let inside = self.boundary.wrap(position);
        let cell = self.cells.grid.as_ref().map_or(0, |grid| grid.locate(&inside));
        self.free_of_planes(&me, position, except) && {
            let mut free = true;
            self.cells.near(cell, |k| {
                let other = self.body(k).filter(|_| k != grain && Partner::grain(k) != except);
                free &= other.is_none_or(|other| self.free_of(&me, position, other));
            });
            free
        }
    }

    /// Whether `me` at `position` keeps clear of another body, wherever that is now.
    fn free_of(&self, me: &Body<S, D>, position: Vector<S, D>, other: &Body<S, D>) -> bool {
        let there = flight::at(other, self.field(), self.now).position;
        let reach = me.radius + other.radius;
        let then = self.boundary.nearest(position - there);
        if S::dot(&then, &then) >= reach.times(reach) {
            return true;
        }
        let before = self.boundary.nearest(me.position - there);
        S::dot(&then, &then) >= S::dot(&before, &before)
    }

    fn free_of_planes(&self, me: &Body<S, D>, position: Vector<S, D>, except: Partner) -> bool {
        let planes = self.boundary.planes().iter().enumerate();
        planes.filter(|&(p, _)| Partner::plane(p) != except).all(|(_, plane)| {
            let then = plane.gap(&position, me.radius, self.now);
            then >= S::zero() || then >= plane.gap(&me.position, me.radius, self.now)
        })
    }
}
