//! Is this a world that can run? Reads what the user says, checks each field; writes the memory.

use super::memory::{Lend, Room};
use super::{World, check};
use crate::event::queue::Queue;
use crate::event::scene::{Counters, Release, Scene};
use crate::event::{Kind, Slot, predict, support};
use crate::fault::{Fault, Subject};
use crate::law::Rule;
use crate::matter::boundary::MOST_PLANES;
use crate::matter::cells::Cells;
use crate::matter::grid::Grid;
use crate::matter::{Body, Boundary, Grain, Periodic, Plane, Surface, flight};
use crate::number::{Instant, Scalar, Vector};

/// A setup that has no rule yet, and so cannot start.
#[derive(Clone, Copy, Debug)]
pub struct NoRule;

/// A world being described. See [`World::setup`].
pub struct Setup<'m, S: Scalar, const D: usize, R> {
    room: Room<'m, S, D>,
    count: usize,
    pub(super) boundary: Boundary<'m, S, D>,
    pub(super) gravity: Vector<S, D>,
    release: Release,
    t_c: S,
    rule: R,
    /// The first thing that was wrong; told by [`Setup::start`].
    fault: Option<Fault>,
}

impl<'m, S: Scalar, const D: usize> World<'m, S, D, NoRule> {
    /// Begins to describe a world that will live in this memory.
    pub fn setup(memory: &'m mut impl Lend<S, D>) -> Setup<'m, S, D, NoRule> {
        let mut room = memory.lend();
        let boundary = Boundary::open(core::mem::take(&mut room.planes));
        Setup {
            room,
            count: 0,
            boundary,
            gravity: Vector::zeros(),
            release: Release::default(),
            t_c: S::zero(),
            rule: NoRule,
            fault: None,
        }
    }
}

impl<'m, S: Scalar, const D: usize, R> Setup<'m, S, D, R> {
    /// A box of soft plane walls: `[low, high]` along each axis. The rule says what they do.
    #[must_use]
    pub fn walls(self, sides: [[S; 2]; D]) -> Self {
        self.boxed(sides, Surface::Rule)
    }

    /// A box of hard plane walls with this coefficient of restitution.
    #[must_use]
    pub fn hard_walls(self, sides: [[S; 2]; D], restitution: S) -> Self {
        self.boxed(sides, Surface::Hard(restitution))
    }

    fn boxed(mut self, sides: [[S; 2]; D], surface: Surface<S>) -> Self {
        for (axis, [low, high]) in sides.into_iter().enumerate() {
            self = self.plane(Plane::across(axis, low, true, surface));
            self = self.plane(Plane::across(axis, high, false, surface));
        }
        self
    }

    /// One plane wall. Grains stay where `normal · r ≥ offset`.
    #[must_use]
    pub fn plane(mut self, plane: Plane<S, D>) -> Self {
        if !self.boundary.add_plane(plane) {
            self.note(Err(self.no_plane_more()));
        }
        self
    }

    pub(super) fn no_plane_more(&self) -> Fault {
        let capacity = self.boundary.capacity();
        let knob = if capacity < MOST_PLANES {
            "the memory's places for planes (P of Memory, or the host's vectors)"
        } else {
            "the list of planes (carom::matter::boundary::MOST_PLANES)"
        };
        Fault::Full { knob, capacity }
    }

    /// A box that is periodic along every axis: `[low, high]` for each.
    #[must_use]
    pub fn periodic(mut self, sides: [[S; 2]; D]) -> Self {
        for (axis, side) in sides.into_iter().enumerate() {
            self = self.periodic_axis(axis, side);
        }
        self
    }

    /// One periodic axis, from low to high.
    #[must_use]
    pub fn periodic_axis(mut self, axis: usize, [low, high]: [S; 2]) -> Self {
        let length = high - low;
        let no =
            |field, value, wanted| Err(Fault::input(Subject::Axis(axis), field, value, wanted));
        if axis >= D {
            self.note(no("axis", axis as f64, "the number of an axis"));
        }
        if !(length > S::zero()) {
            self.note(no("length", length.to_f64(), check::LENGTH));
        }
        self.boundary.set_periodic(axis, Periodic { low, length });
        self
    }

    /// Uniform gravity. [`World::set_gravity`] changes it later.
    #[must_use]
    pub fn gravity(mut self, gravity: [S; D]) -> Self {
        self.gravity = Vector::from(gravity);
        self
    }

    /// How a contact ends when a third body interrupts it.
    #[must_use]
    pub fn release(mut self, release: Release) -> Self {
        self.release = release;
        self
    }

    /// The TC rule (Luding & McNamara, Granul. Matter 1, 113, 1998): an instantaneous collision less
    /// than `t_c` after the last one of either grain is elastic. Zero, the default, is no such rule.
    ///
    /// A real contact lasts t_c; grains that meet more often than that are in lasting contact, and
    /// lose no more energy by it. It also says when a hop is too short to be one: a grain that would
    /// be back within t_c lies still. Soft laws have their own contact duration and do not need it.
    ///
    /// # Units
    /// Time; at least zero.
    #[must_use]
    pub fn tc(mut self, t_c: S) -> Self {
        if !(t_c >= S::zero() && t_c.is_number()) {
            let wanted = "a contact duration: finite and at least 0";
            self.note(Err(Fault::input(Subject::World, "t_c", t_c.to_f64(), wanted)));
        }
        self.t_c = t_c;
        self
    }

    /// What grains do when they touch.
    #[must_use]
    pub fn rule<Q: Rule<S>>(self, rule: Q) -> Setup<'m, S, D, Q> {
        let Self { room, count, boundary, gravity, release, t_c, fault, .. } = self;
        Setup { room, count, boundary, gravity, release, t_c, rule, fault }
    }

    /// One more grain.
    ///
    /// # Errors
    /// [`Fault::Full`] if the memory holds no more, [`Fault::Input`] that names the grain and its field.
    pub fn grain(mut self, grain: Grain<S, D>) -> Result<Self, Fault> {
        check::grain(&grain, self.count)?;
        let capacity = self.room.capacity();
        let full =
            Fault::Full { knob: "the memory (N of Memory, or the host's vectors)", capacity };
        if self.count >= capacity.min(Queue::<S>::MOST) {
            return Err(full);
        }
        let place = self.room.bodies.get_mut(self.count).ok_or(full)?;
        *place = Body::new(&grain);
        self.count += 1;
        Ok(self)
    }

    /// Many more grains.
    ///
    /// # Errors
    /// As [`Setup::grain`].
    pub fn grains(self, grains: impl IntoIterator<Item = Grain<S, D>>) -> Result<Self, Fault> {
        grains.into_iter().try_fold(self, Self::grain)
    }

    fn note(&mut self, checked: Result<(), Fault>) {
        if self.fault.is_none() {
            self.fault = checked.err();
        }
    }
}

impl<'m, S: Scalar, const D: usize, R: Rule<S>> Setup<'m, S, D, R> {
    /// Checks everything, predicts every grain's first event, and starts at [`Instant::START`].
    ///
    /// # Errors
    /// [`Fault::Input`] for a field, [`Fault::Overlap`] for two bodies that overlap.
    pub fn start(self) -> Result<World<'m, S, D, R>, Fault> {
        let mut world = self.build()?;
        check::overlaps(&world.scene)?;
        world.predict_all();
        Ok(world)
    }

    /// The world, its fields checked, nothing predicted.
    pub(super) fn build(self) -> Result<World<'m, S, D, R>, Fault> {
        self.fault.map_or(Ok(()), Err)?;
        self.rule.check()?;
        let mut boundary = self.boundary;
        boundary.start_epoch(Instant::START);
        for axis in 0..D {
            boundary.periodic(axis).into_iter().for_each(|p| boundary.set_periodic(axis, p));
        }
        let Room { bodies, slots, tree, links, heads, .. } = self.room;
        let bodies = bodies.get_mut(..self.count).unwrap_or_default();
        let slots = slots.get_mut(..self.count).unwrap_or_default();
        let tree = tree.get_mut(..self.count).unwrap_or_default();
        let links = links.get_mut(..self.count).unwrap_or_default();
        let largest_radius = bodies.iter().fold(S::zero(), |r, b| r.larger(b.radius));
        check::space(&boundary, &self.gravity, largest_radius)?;
        for (i, body) in bodies.iter_mut().enumerate() {
            body.position = boundary.on_lattice(boundary.wrap_from_afar(body.position));
            check::inside(&boundary, i, body)?;
        }
        slots.fill(Slot::EMPTY);
        let reach = largest_radius + largest_radius;
        let grid = Grid::choose(&boundary, bodies, reach, heads.len());
        let mut scene = Scene {
            bodies,
            cells: Cells::new(grid, heads, links),
            boundary,
            gravity: self.gravity,
            weightless: flight::is_weightless(&self.gravity),
            now: S::zero(),
            epoch: Instant::START,
            largest_radius,
            release: self.release,
            t_c: self.t_c,
            hop: support::hop(&self.gravity, largest_radius),
            held: 0,
            counters: Counters::default(),
        };
        scene.fill_cells();
        let queue = Queue::new(slots, tree);
        Ok(World {
            scene,
            queue,
            rule: self.rule,
            since_epoch: 0,
            wanders: 0,
            at_once: 0,
            mark: Instant::START,
        })
    }
}

impl<S: Scalar, const D: usize, R: Rule<S>> World<'_, S, D, R> {
    /// A grain's next event. Without cells it is brought back into the box first, so that the nearest
    /// image is one box length away at most.
    pub(super) fn predict(&mut self, grain: usize) -> Slot<S> {
        if self.scene.cells.grid.is_none() {
            self.scene.rein_in(grain);
        }
        predict::next(&self.scene, grain)
    }

    /// The same for a grain that has just left its cell.
    pub(super) fn predict_ahead(&mut self, grain: usize, slot: Slot<S>) -> Slot<S> {
        if self.scene.cells.grid.is_none() {
            return self.predict(grain);
        }
        predict::ahead(&self.scene, grain, slot)
    }

    /// Predicts every grain's next event. Who was told to check what holds it still does so first.
    pub(super) fn predict_all(&mut self) {
        for i in 0..self.scene.bodies.len() {
            let slot = match self.queue.slot(i).kind {
                Kind::Check => Slot::alone(self.scene.now, Kind::Check),
                _ => self.predict(i),
            };
            if let Some(place) = self.queue.slots.get_mut(i) {
                *place = slot;
            }
        }
        self.queue.rebuild();
    }
}
