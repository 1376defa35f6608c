//! Is this a world that can run? Reads what the user says, checks each field; writes the memory.

use super::state::{Progress, World};
use super::statistics::Statistics;
use super::storage::{Buffers, Storage};
use super::{check_facets, check_input, check_rotation, check_scales};
use crate::cluster::{Clusters, Settings};
use crate::detect::ScheduledEvent;
use crate::error::{Error, Subject};
use crate::law::{Enduring, Rule};
use crate::resolve::{Parameters, Release, min_hop_time};
use crate::scalar::{Clock, Instant, Scalar, Vector};
use crate::schedule::EventQueue;
use crate::space::{
    Boundary, Cells, Contacts, Domain, MAX_PLANES, Obstacles, Particles, Plane, Shear, Surface,
    choose_cells, largest_radius,
};

/// A builder that has no rule yet, and so cannot start.
#[derive(Clone, Copy, Debug)]
pub struct NoRule;

/// A world being described. See [`World::builder`].
pub struct WorldBuilder<'m, S: Scalar, const D: usize, R> {
    pub(super) buffers: Buffers<'m, S, D>,
    pub(super) count: usize,
    pub(super) boundary: Boundary<'m, S, D>,
    pub(super) gravity: Vector<S, D>,
    pub(super) shear: Option<Shear<S>>,
    pub(super) release: Release,
    pub(super) t_c: S,
    pub(super) settings: Settings<S>,
    pub(super) rule: R,
    /// The first thing that was wrong; told by [`WorldBuilder::start`].
    pub(super) error: Option<Error>,
}

impl<'m, S: Scalar, const D: usize> World<'m, S, D, NoRule> {
    /// Begins to describe a world that will live in this memory.
    pub fn builder(memory: &'m mut impl Storage<S, D>) -> WorldBuilder<'m, S, D, NoRule> {
        Self::builder_with(memory.buffers())
    }

    /// As [`World::builder`], in arrays that are already lent.
    #[must_use]
    pub fn builder_with(mut buffers: Buffers<'m, S, D>) -> WorldBuilder<'m, S, D, NoRule> {
        let boundary = Boundary::open(core::mem::take(&mut buffers.planes));
        WorldBuilder {
            buffers,
            count: 0,
            boundary,
            gravity: Vector::zeros(),
            shear: None,
            release: Release::default(),
            t_c: S::zero(),
            settings: Settings::new(Enduring::default()),
            rule: NoRule,
            error: None,
        }
    }
}

impl<'m, S: Scalar, const D: usize, R> WorldBuilder<'m, S, D, R> {
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
            self.add(Plane::across(axis, low, true, surface));
            self.add(Plane::across(axis, high, false, surface));
        }
        self
    }

    /// One plane wall. Grains stay where `normal · r ≥ offset`.
    ///
    /// A normal written to five digits or more is made of unit length to the last place; one further off
    /// (|n|² − 1 above 10⁻⁵) is refused by [`WorldBuilder::start`].
    #[must_use]
    pub fn plane(mut self, plane: Plane<S, D>) -> Self {
        self.add(plane.with_unit_normal());
        self
    }

    /// One plane more, its normal of unit length.
    #[inline(never)]
    fn add(&mut self, plane: Plane<S, D>) {
        if !self.boundary.add_plane(plane) {
            self.note(Err(self.too_many_planes()));
        }
    }

    pub(super) fn too_many_planes(&self) -> Error {
        let capacity = self.boundary.capacity();
        let knob = if capacity < MAX_PLANES {
            "the memory's places for planes (P of Memory, or the host's vectors)"
        } else {
            "the list of planes (carom::space::MAX_PLANES)"
        };
        Error::Full { knob, capacity }
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
    pub fn periodic_axis(mut self, axis: usize, side: [S; 2]) -> Self {
        let set = self.set_periodic_axis(axis, side);
        self.note(set);
        self
    }

    /// A steady shear between two periodic axes (Lees & Edwards): see [`Shear`].
    ///
    /// Two axes of the box must be periodic, and there is no gravity: [`WorldBuilder::start`] refuses it.
    #[must_use]
    pub fn sheared(mut self, shear: Shear<S>) -> Self {
        self.shear = Some(shear);
        self
    }

    /// Uniform gravity. [`World::set_gravity`] changes it later.
    #[must_use]
    pub fn gravity(mut self, gravity: [S; D]) -> Self {
        self.gravity = Vector::from(gravity);
        self
    }

    /// How a contact ends when a third body interrupts it. [`Enduring::Paper`] only: else it goes on by forces.
    #[must_use]
    pub fn release(mut self, release: Release) -> Self {
        self.release = release;
        self
    }

    /// The TC rule (Luding & McNamara, Granul. Matter 1, 113, 1998): an instantaneous collision less
    /// than `t_c` after the last one of either grain is elastic. Zero, the default, is no such rule.
    ///
    /// A real contact lasts t_c; grains that meet more often than that are in lasting contact, and
    /// lose no more energy by it. [`Enduring::Paper`] only: else forces take over, see
    /// [`WorldBuilder::contact_time`]. It also says when a hop is too short to be one: a grain that would
    /// be back within t_c lies still (a rough one goes on hopping). Soft laws have their own contact duration and
    /// do not need it.
    ///
    /// # Units
    /// Time; at least zero.
    #[must_use]
    pub fn tc(mut self, t_c: S) -> Self {
        if !(t_c >= S::zero() && t_c.is_finite()) {
            let wanted = "a contact duration: finite and at least 0";
            self.note(Err(Error::input(Subject::World, "t_c", t_c.to_f64(), wanted)));
        }
        self.t_c = t_c;
        self
    }

    /// What becomes of contacts that last or crowd: see [`Enduring`].
    #[must_use]
    pub fn enduring(mut self, enduring: Enduring) -> Self {
        self.settings.enduring = enduring;
        self
    }

    /// How long a slow contact of grains lasts whose rule has no force law. By default (R/g)^½/16, R the
    /// smaller of the two, g with the largest acceleration of plates. [`Enduring::Integrated`] only.
    ///
    /// # Units
    /// Time; above zero, and at most 0.7 (R/g)^½: else grains at rest would overlap by more than a twentieth of
    /// their radius ([`Error::LongContact`] from `start`, or from [`World::set_gravity`]).
    #[must_use]
    pub fn contact_time(mut self, time: S) -> Self {
        let set = self.set_contact_time(time);
        self.note(set);
        self
    }

    /// In how many steps the shortest contact of a cluster is integrated: 32 by default, at least 8, at most 131,072
    /// (16,384 in fixed point). The error falls with the square of it, until a step is four times the resolution of the
    /// number. [`Enduring::Integrated`] only.
    #[must_use]
    pub fn steps_per_contact(mut self, steps: u32) -> Self {
        let set = self.set_steps_per_contact(steps);
        self.note(set);
        self
    }

    /// What grains do when they touch.
    #[must_use]
    pub fn rule<Q: Rule<S>>(self, rule: Q) -> WorldBuilder<'m, S, D, Q> {
        let Self {
            buffers, count, boundary, gravity, shear, release, t_c, settings, error, ..
        } = self;
        WorldBuilder {
            buffers,
            count,
            boundary,
            gravity,
            shear,
            release,
            t_c,
            settings,
            rule,
            error,
        }
    }

    fn note(&mut self, checked: Result<(), Error>) {
        if self.error.is_none() {
            self.error = checked.err();
        }
    }
}

impl<'m, S: Scalar, const D: usize, R: Rule<S>> WorldBuilder<'m, S, D, R> {
    /// Checks everything, predicts every grain's first event, and starts at [`Instant::START`].
    ///
    /// # Errors
    /// [`Error::Input`] for a field, [`Error::Overlap`] for two bodies that overlap.
    pub fn start(self) -> Result<World<'m, S, D, R>, Error> {
        let mut world = self.build()?;
        check_input::overlaps(&world.particles, &world.domain, world.clock.now)?;
        world.predict_all();
        Ok(world)
    }

    /// The world, its fields checked, nothing predicted.
    pub(super) fn build(self) -> Result<World<'m, S, D, R>, Error> {
        self.error.map_or(Ok(()), Err)?;
        self.rule.check()?;
        let mut boundary = self.boundary;
        boundary.set_epoch(Instant::START);
        for axis in 0..D {
            boundary.periodic(axis).into_iter().for_each(|p| boundary.set_periodic(axis, p));
        }
        self.shear.map_or(Ok(()), |shear| boundary.set_sheared(shear))?;
        check_input::sheared(&boundary, &self.gravity)?;
        let Buffers {
            bodies,
            events,
            tree,
            links,
            heads,
            accelerations,
            calendar,
            rotation,
            contacts,
            obstacles,
            ..
        } = self.buffers;
        let bodies = bodies.get_mut(..self.count).unwrap_or_default();
        let events = events.get_mut(..self.count).unwrap_or_default();
        let tree = tree.get_mut(..self.count).unwrap_or_default();
        let links = links.get_mut(..self.count).unwrap_or_default();
        let clustered = if self.settings.is_integrated(&self.rule) { self.count } else { 0 };
        check_input::accelerations(clustered, accelerations.len())?;
        let accelerations = accelerations.get_mut(..clustered).unwrap_or_default();
        let rotation = check_rotation::angular_velocities(rotation, self.rule.inertia(), bodies)?;
        let largest_radius = largest_radius(bodies);
        if cfg!(feature = "obstacles") {
            let enduring = self.rule.enduring().unwrap_or(self.settings.enduring);
            check_facets::facets(&obstacles)?;
            boundary.set_obstacles(Obstacles::new(obstacles, largest_radius)?);
            check_facets::obstacles(&boundary, enduring)?;
        }
        check_input::space(&boundary, &self.gravity, largest_radius)?;
        for (i, body) in bodies.iter_mut().enumerate().filter(|(_, body)| !body.is_vacant()) {
            let [position, velocity] =
                boundary.image_inside([body.position, body.velocity], S::zero());
            (body.position, body.velocity) = (boundary.to_lattice(position), velocity);
            check_input::inside(&boundary, i, body)?;
        }
        check_scales::scales(&boundary, &self.gravity, (0, bodies))?;
        events.fill(ScheduledEvent::NONE);
        let settings = self.settings.adopted(&self.rule, &boundary, &self.gravity, bodies);
        check_rotation::mode(&self.rule, &settings)?;
        settings.try_law(&self.rule)?;
        if settings.is_integrated(&self.rule) {
            settings.check_contact_time(&self.gravity)?;
        }
        let cells = choose_cells(&boundary, bodies, settings.sight(), heads.len());
        let cells = Cells::new(cells, boundary.shear(), heads, links);
        let min_hop_time = min_hop_time(&self.gravity, largest_radius);
        let mut particles = Particles::new(bodies, accelerations, cells);
        (particles.rotation, particles.contacts) = (rotation, Contacts(contacts));
        Ok(World {
            particles,
            domain: Domain::new(boundary, self.gravity),
            clock: Clock::start(),
            parameters: Parameters {
                t_c: self.t_c,
                min_hop_time,
                release: self.release,
                lossy_hops: false,
                settings,
                settled_gravity: self.gravity,
            },
            clusters: Clusters::none(),
            queue: EventQueue::new(events, tree, calendar),
            rule: self.rule,
            statistics: Statistics::default(),
            progress: Progress::START,
        })
    }
}
