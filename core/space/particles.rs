//! Which grains are there, and in which cell is each? Reads the domain; writes bodies and the lists of cells.

use super::boundary::Boundary;
use super::cells::Cells;
use super::contacts::Contacts;
use super::domain::Domain;
use super::flight;
use super::grid::{CellFace, Grid};
use super::rotation::RotationBuffers;
use crate::error::{Error, Subject};
use crate::particle::{Body, Partner};
#[cfg(not(feature = "alloc"))]
use crate::scalar::max_abs;
use crate::scalar::{Scalar, Vector};

/// All bodies, and who is near whom.
pub(crate) struct Particles<'m, S: Scalar, const D: usize> {
    /// Each at its own clock.
    pub bodies: &'m mut [Body<S, D>],
    /// Of clustered grains during a step: those of the last one.
    pub accelerations: &'m mut [Vector<S, D>],
    pub cells: Cells<'m, S, D>,
    pub largest_radius: S,
    /// How many bodies something holds against gravity.
    pub supported: usize,
    /// No component of a velocity is larger, each at its body's own clock; without a bound at the start.
    #[cfg(not(feature = "alloc"))]
    pub top_speed: S,
    /// How they rotate; empty for smooth grains.
    pub rotation: RotationBuffers<'m, S>,
    /// What contacts remember that last; empty where none does.
    pub contacts: Contacts<'m, S>,
}

impl<'m, S: Scalar, const D: usize> Particles<'m, S, D> {
    /// These bodies, each in its cell.
    pub fn new(
        bodies: &'m mut [Body<S, D>],
        accelerations: &'m mut [Vector<S, D>],
        cells: Cells<'m, S, D>,
    ) -> Self {
        let largest_radius = largest_radius(bodies);
        let (rotation, contacts) = (RotationBuffers::default(), Contacts(&mut []));
        let mut all = Self {
            bodies,
            accelerations,
            cells,
            largest_radius,
            supported: 0,
            #[cfg(not(feature = "alloc"))]
            top_speed: S::NEVER,
            rotation,
            contacts,
        };
        all.fill_cells();
        all
    }

    /// The body as it is now. An index out of range gives an empty place; none is ever asked for.
    #[inline]
    pub fn present(&self, grain: usize, domain: &Domain<'_, S, D>, now: S) -> Body<S, D> {
        match self.bodies.get(grain) {
            Some(body) => flight::at(body, domain, now),
            None => Body::default(),
        }
    }

    /// The body as it was kept, at its own clock.
    #[inline]
    pub fn body(&self, grain: usize) -> Option<&Body<S, D>> {
        self.bodies.get(grain)
    }

    /// Whether the two are in contact with each other.
    pub fn are_in_contact(&self, a: usize, b: usize) -> bool {
        let partner = |i: usize| self.body(i).map_or(Partner::NOTHING, |x| x.partner);
        partner(a) == Partner::grain(b) && partner(b) == Partner::grain(a)
    }

    /// Writes a body whose velocity changed: events predicted for it are void.
    pub fn replace(&mut self, boundary: &Boundary<'_, S, D>, grain: usize, mut body: Body<S, D>) {
        body.position = boundary.to_lattice(body.position);
        self.put(grain, body);
    }

    /// The same where its position stays as it was: at its own clock it may be many boxes away.
    pub fn put(&mut self, grain: usize, body: Body<S, D>) {
        self.change(grain, |place| *place = body);
    }

    /// Changes a body where it is: events predicted for it are void.
    #[inline]
    pub fn change(&mut self, grain: usize, change: impl FnOnce(&mut Body<S, D>)) {
        if let Some(body) = self.bodies.get_mut(grain) {
            self.supported -= usize::from(body.is_supported());
            change(body);
            self.supported += usize::from(body.is_supported());
            body.event_count = body.event_count.wrapping_add(1);
            #[cfg(not(feature = "alloc"))]
            {
                self.top_speed = self.top_speed.max(max_abs(&body.velocity));
            }
        }
    }

    /// How far another can come, at most, nearer to a grain that has this velocity now within a span; more than that until
    /// clocks have been set back once.
    #[cfg(not(feature = "alloc"))]
    pub fn way_of_others(
        &self,
        domain: &Domain<'_, S, D>,
        (now, span): (S, S),
        velocity: &Vector<S, D>,
    ) -> S {
        // Since clocks were set back gravity has acted for no longer than now.
        let fall = max_abs(domain.gravity()) * (now + span);
        (self.top_speed + max_abs(velocity) + fall + fall) * S::from_count(D as u32) * span
    }

    /// Writes a body that was put somewhere else at a time: inside the box and in its new cell, too.
    pub fn relocate(
        &mut self,
        boundary: &Boundary<'_, S, D>,
        (grain, time): (usize, S),
        mut body: Body<S, D>,
    ) {
        if boundary.images().is_some() {
            [body.position, body.velocity] =
                boundary.image_inside([body.position, body.velocity], time);
        }
        self.put_inside(boundary, grain, body);
    }

    /// The same for one that is inside the box along the gradient of a shear.
    pub fn put_inside(
        &mut self,
        boundary: &Boundary<'_, S, D>,
        grain: usize,
        mut body: Body<S, D>,
    ) {
        body.position = boundary.wrap(body.position);
        let cell = self.cells.grid.as_ref().map(|grid| grid.locate(&body.position));
        if let Some(cell) = cell.filter(|cell| *cell != body.cell) {
            let lists = [body.cell, cell].map(|cell| self.cells.list(cell, body.radius));
            self.relist(grain, lists);
            body.cell = cell;
        }
        self.replace(boundary, grain, body);
    }

    /// Puts a grain into an empty place, and into its cell.
    pub fn occupy(&mut self, place: usize, body: Body<S, D>) {
        let cell = self.cells.grid.as_ref().map_or(0, |grid| grid.locate(&body.position));
        self.cells.occupy(place);
        if self.cells.grid.is_some() {
            let list = self.cells.list(cell, body.radius);
            self.cells.insert(place, list);
        }
        self.put(place, Body { cell, ..body });
    }

    /// Takes a grain out of its cell; its place is empty from now on.
    pub fn vacate(&mut self, grain: usize, now: S) {
        let Some(Body { cell, radius, event_count, .. }) = self.body(grain).copied() else {
            return;
        };
        if self.cells.grid.is_some() {
            let list = self.cells.list(cell, radius);
            self.cells.remove(grain, list);
        }
        self.cells.vacate(grain);
        self.put(grain, Body::vacant(now, event_count));
    }

    /// Lets a grain cross into the next cell. Its trajectory stays the same; only its image may change.
    pub fn cross(&mut self, boundary: &Boundary<'_, S, D>, grain: usize, face: CellFace) {
        let Some(body) = self.bodies.get_mut(grain) else { return };
        let from = body.cell;
        let next = self.cells.grid.as_ref().and_then(|grid| grid.across(from, face));
        let Some((cell, turns)) = next else { return };
        body.cell = cell;
        let radius = body.radius;
        let length = boundary.periodic(face.axis).map_or(S::zero(), |p| p.length);
        if let Some(x) = body.position.get_mut(face.axis).filter(|_| turns != S::zero()) {
            *x += turns * length;
        }
        let lists = [from, cell].map(|cell| self.cells.list(cell, radius));
        self.relist(grain, lists);
    }

    /// Takes a grain from one list into another.
    #[inline]
    fn relist(&mut self, grain: usize, [from, to]: [u32; 2]) {
        if from != to {
            self.cells.remove(grain, from);
            self.cells.insert(grain, to);
        }
    }

    /// Without cells: a grain that has flown far is brought back into the periodic box.
    pub fn rewrap(&mut self, grain: usize, domain: &Domain<'_, S, D>, now: S) {
        let present = self.present(grain, domain, now).position;
        let shift = domain.boundary.wrap(present) - present;
        if let Some(body) = self.bodies.get_mut(grain) {
            body.position += shift;
        }
    }

    /// Puts every grain into its cell, by its position at the start.
    fn fill_cells(&mut self) {
        for (i, body) in self.bodies.iter_mut().enumerate() {
            if body.is_vacant() {
                self.cells.vacate(i);
            } else if let Some(grid) = &self.cells.grid {
                body.cell = grid.locate(&body.position);
                let list = self.cells.list(body.cell, body.radius);
                self.cells.insert(i, list);
            }
        }
    }

    /// Takes over a saved grid and puts every grain into the cell it says it is in.
    ///
    /// # Errors
    /// [`Error::Full`] if there is no room for the cells, [`Error::Input`] that names a grain not in its cell.
    pub fn restore_cells(
        &mut self,
        grid: Option<Grid<S, D>>,
        domain: &Domain<'_, S, D>,
        now: S,
    ) -> Result<(), Error> {
        let fits = grid.as_ref().is_none_or(|grid| self.fits(domain, grid));
        if !(fits && self.cells.reset(grid)) {
            let knob = "the saved cells do not fit the box or the heads of the memory, which";
            return Err(Error::Full { knob, capacity: self.cells.capacity() });
        }
        for i in 0..self.bodies.len() {
            let body = self.present(i, domain, now);
            if body.is_vacant() {
                self.cells.vacate(i);
                continue;
            }
            if !grid.as_ref().is_none_or(|grid| grid.holds(body.cell, &body.position)) {
                let wanted = "the number of the cell that it is in";
                return Err(Error::input(Subject::Grain(i), "cell", f64::from(body.cell), wanted));
            }
            if grid.is_some() {
                let list = self.cells.list(body.cell, body.radius);
                self.cells.insert(i, list);
            }
        }
        Ok(())
    }
}

impl<S: Scalar, const D: usize> Particles<'_, S, D> {
    /// Whether these cells are for this box and these grains; then with the levels that they need.
    fn fits(&mut self, domain: &Domain<'_, S, D>, grid: &Grid<S, D>) -> bool {
        if !self.cells.choose_levels(grid, self.bodies) {
            return false;
        }
        let radius = self.cells.levels.finest(self.largest_radius);
        let has_rows = domain.boundary.images().is_none() || self.cells.levels.len() == 1;
        has_rows && grid.fits(&domain.boundary, radius + radius)
    }
}

/// The largest radius of all; zero without bodies.
pub(crate) fn largest_radius<S: Scalar, const D: usize>(bodies: &[Body<S, D>]) -> S {
    bodies.iter().fold(S::zero(), |largest, body| largest.max(body.radius))
}
