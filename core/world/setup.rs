//! Is this a world that can run? Reads what the user says, checks each field; writes the memory.

use super::World;
use super::memory::{Lend, Room};
use crate::event::queue::Queue;
use crate::event::scene::{Counters, Release, Scene};
use crate::event::{Slot, predict};
use crate::fault::{Fault, Subject};
use crate::law::Rule;
use crate::matter::boundary::MOST_PLANES;
use crate::matter::cells::Cells;
use crate::matter::grid::Grid;
use crate::matter::{Body, Boundary, Grain, Partner, Periodic, Plane, Surface};
use crate::number::{Instant, Scalar, Vector};

/// A setup that has no rule yet, and so cannot start.
#[derive(Clone, Copy, Debug)]
pub struct NoRule;

/// A world being described. See [`World::setup`].
pub struct Setup<'m, S: Scalar, const D: usize, R> {
    room: Room<'m, S, D>,
    count: usize,
    boundary: Boundary<S, D>,
    gravity: Vector<S, D>,
    release: Release,
    rule: R,
    /// The first thing that was wrong; told by [`Setup::start`].
    fault: Option<Fault>,
}

impl<'m, S: Scalar, const D: usize> World<'m, S, D, NoRule> {
    /// Begins to describe a world that will live in this memory.
    pub fn setup(memory: &'m mut impl Lend<S, D>) -> Setup<'m, S, D, NoRule> {
        Setup {
            room: memory.lend(),
            count: 0,
            boundary: Boundary::default(),
            gravity: Vector::zeros(),
            release: Release::default(),
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
        let number = self.boundary.planes().len();
        self.note(check_plane(&plane, number));
        if !self.boundary.add_plane(plane) {
            let knob = "the list of planes (carom::matter::boundary::MOST_PLANES)";
            self.note(Err(Fault::Full { knob, capacity: MOST_PLANES }));
        }
        self
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
        if axis >= D {
            let wanted = "the number of an axis";
            self.note(Err(Fault::input(Subject::Axis(axis), "axis", axis as f64, wanted)));
        } else if !(low.is_number() && length.is_number() && length > S::zero()) {
            let wanted = "finite and above 0";
            self.note(Err(Fault::input(Subject::Axis(axis), "length", length.to_f64(), wanted)));
        }
        self.boundary.set_periodic(axis, Periodic { low, length });
        self
    }

    /// Uniform gravity. [`World::set_gravity`] changes it later.
    #[must_use]
    pub fn gravity(mut self, gravity: [S; D]) -> Self {
        self.gravity = Vector::from(gravity);
        self.note(finite(Subject::World, "gravity", &self.gravity));
        self
    }

    /// How a contact ends when a third body interrupts it.
    #[must_use]
    pub fn release(mut self, release: Release) -> Self {
        self.release = release;
        self
    }

    /// What grains do when they touch.
    #[must_use]
    pub fn rule<Q: Rule<S>>(self, rule: Q) -> Setup<'m, S, D, Q> {
        let Self { room, count, boundary, gravity, release, fault, .. } = self;
        Setup { room, count, boundary, gravity, release, rule, fault }
    }

    /// One more grain.
    ///
    /// # Errors
    /// [`Fault::Full`] if the memory holds no more, [`Fault::Input`] that names the grain and its field.
    pub fn grain(mut self, grain: Grain<S, D>) -> Result<Self, Fault> {
        check_grain(&grain, self.count)?;
        let capacity = self.room.bodies.len().min(self.room.slots.len()).min(self.room.tree.len());
        let full =
            Fault::Full { knob: "the memory (N of Memory, or the host's vectors)", capacity };
        if self.count >= capacity.min(Partner::MOST_GRAINS) {
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
        let world = self.build()?;
        let mut world = world;
        check_overlaps(&world.scene)?;
        world.predict_all();
        Ok(world)
    }

    /// The world, its fields checked, nothing predicted.
    pub(super) fn build(self) -> Result<World<'m, S, D, R>, Fault> {
        self.fault.map_or(Ok(()), Err)?;
        self.rule.check()?;
        let Room { bodies, slots, tree, links, heads } = self.room;
        let bodies = bodies.get_mut(..self.count).unwrap_or_default();
        let slots = slots.get_mut(..self.count).unwrap_or_default();
        let tree = tree.get_mut(..self.count).unwrap_or_default();
        let links = links.get_mut(..self.count).unwrap_or_default();
        let largest_radius = bodies.iter().fold(S::zero(), |r, b| r.larger(b.radius));
        check_box(&self.boundary, largest_radius)?;
        for body in bodies.iter_mut() {
            body.position = self.boundary.wrap_from_afar(body.position);
        }
        slots.fill(Slot::EMPTY);
        let reach = largest_radius + largest_radius;
        let grid = Grid::choose(&self.boundary, bodies, reach, heads.len());
        let mut scene = Scene {
            bodies,
            cells: Cells::new(grid, heads, links),
            boundary: self.boundary,
            gravity: self.gravity,
            now: S::zero(),
            epoch: Instant::START,
            largest_radius,
            release: self.release,
            counters: Counters::default(),
        };
        scene.fill_cells();
        let queue = Queue::new(slots, tree);
        Ok(World { scene, queue, rule: self.rule, since_epoch: 0, at_once: 0 })
    }
}

impl<S: Scalar, const D: usize, R: Rule<S>> World<'_, S, D, R> {
    /// Predicts every grain's next event.
    pub(super) fn predict_all(&mut self) {
        for i in 0..self.scene.bodies.len() {
            let slot = predict::next(&self.scene, i);
            if let Some(place) = self.queue.slots.get_mut(i) {
                *place = slot;
            }
        }
        self.queue.rebuild();
    }
}

fn check_plane<S: Scalar, const D: usize>(plane: &Plane<S, D>, number: usize) -> Result<(), Fault> {
    let subject = Subject::Plane(number);
    finite(subject, "normal", &plane.normal)?;
    let length = plane.normal.dot(&plane.normal).to_f64();
    if (length - 1.0).abs() > 1e-5 {
        return Err(Fault::input(subject, "normal's length squared", length, "1"));
    }
    if !plane.offset.is_number() {
        return Err(Fault::input(subject, "offset", plane.offset.to_f64(), "a finite number"));
    }
    match plane.surface {
        Surface::Hard(e) if !(e >= S::zero() && e <= S::one()) => {
            Err(Fault::input(subject, "restitution", e.to_f64(), "between 0 and 1"))
        }
        _ => Ok(()),
    }
}

fn check_grain<S: Scalar, const D: usize>(grain: &Grain<S, D>, number: usize) -> Result<(), Fault> {
    let subject = Subject::Grain(number);
    for (field, value) in [("radius", grain.radius), ("mass", grain.mass)] {
        if !(value > S::zero() && value.is_number()) {
            return Err(Fault::input(subject, field, value.to_f64(), "finite and above 0"));
        }
    }
    finite(subject, "position", &grain.position)?;
    finite(subject, "velocity", &grain.velocity)
}

fn check_box<S: Scalar, const D: usize>(boundary: &Boundary<S, D>, radius: S) -> Result<(), Fault> {
    for (axis, periodic) in boundary.periodic_axes() {
        if !(Boundary::<S, D>::leash(&periodic, radius) > S::zero()) {
            let wanted = "more than four times the largest radius";
            return Err(Fault::input(
                Subject::Axis(axis),
                "length",
                periodic.length.to_f64(),
                wanted,
            ));
        }
    }
    Ok(())
}

/// No two bodies may overlap by more than the rounding of their positions. So little is harmless
/// (BSFP14), and the state of another run, written out and read in again, has it.
fn check_overlaps<S: Scalar, const D: usize>(scene: &Scene<'_, S, D>) -> Result<(), Fault> {
    for (a, body) in scene.bodies.iter().enumerate() {
        for b in scene.cells.near(body.cell).filter(|&b| b < a) {
            let Some(other) = scene.body(b) else { continue };
            let apart = scene.separation(body, other);
            let gap = apart.dot(&apart).sqrt() - (body.radius + other.radius);
            refuse_overlap(a, body, Partner::grain(b), gap)?;
        }
        for (p, plane) in scene.boundary.planes().iter().enumerate() {
            refuse_overlap(a, body, Partner::plane(p), plane.gap(&body.position, body.radius))?;
        }
    }
    Ok(())
}

fn refuse_overlap<S: Scalar, const D: usize>(
    grain: usize,
    body: &Body<S, D>,
    with: Partner,
    gap: S,
) -> Result<(), Fault> {
    let far = body.position.iter().fold(body.radius, |far, x| far.larger(x.magnitude()));
    let rounding = S::RESOLUTION * S::from_f32(8.0) * far;
    if gap >= -rounding {
        return Ok(());
    }
    Err(Fault::Overlap { grain, with, gap: gap.to_f64() })
}

fn finite<S: Scalar, const D: usize>(
    subject: Subject,
    field: &'static str,
    v: &Vector<S, D>,
) -> Result<(), Fault> {
    match v.iter().find(|x| !x.is_number()) {
        Some(x) => Err(Fault::input(subject, field, x.to_f64(), "a finite number")),
        None => Ok(()),
    }
}
