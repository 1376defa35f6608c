//! Where does space end? Periodic axes and planes; reads positions, writes wrapped ones.

use super::if_obstacles::IfObstacles;
use super::if_sheared::IfSheared;
use super::obstacles::Obstacles;
use super::periodic_axis::PeriodicAxis;
use super::plane::Plane;
use super::shear::{Images, Shear};
use crate::error::Error;
#[cfg(feature = "alloc")]
use crate::scalar::component;
use crate::scalar::{Instant, Scalar, Vector};

/// How many planes a world can have, if its memory has place for them.
pub const MAX_PLANES: usize = 8;

/// All of a world's boundaries.
#[derive(Debug)]
pub struct Boundary<'m, S: Scalar, const D: usize> {
    /// Where periodic axes begin.
    low: Vector<S, D>,
    /// How long periodic axes are; zero for the others.
    length: Vector<S, D>,
    /// What rounds a position to the lattice of a periodic axis, see [`Scalar::lattice`]; else zero.
    lattice: Vector<S, D>,
    /// Places for planes, lent by the world's memory.
    planes: &'m mut [Plane<S, D>],
    /// How many of them are taken.
    count: u8,
    /// Whether an axis is periodic.
    is_periodic: bool,
    /// How images move, if the box is sheared. Its gradient then has no `length`: whoever goes round that axis asks here.
    images: IfSheared<Images<S>>,
    /// What stands inside.
    pub(super) obstacles: IfObstacles<Obstacles<'m, S, D>>,
}

/// The boundaries as a snapshot keeps them.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct SavedBoundary<S: Scalar, const D: usize> {
    low: Vector<S, D>,
    length: Vector<S, D>,
    pub planes: heapless::Vec<Plane<S, D>, MAX_PLANES>,
    pub shear: Option<Shear<S>>,
    /// What tells the obstacles from others; 0 without any.
    #[cfg_attr(feature = "serde", serde(default))]
    pub obstacles: u64,
}

impl<'m, S: Scalar, const D: usize> Boundary<'m, S, D> {
    /// Open space, with places for planes.
    pub(crate) fn open(planes: &'m mut [Plane<S, D>]) -> Self {
        let zero = Vector::zeros();
        Self {
            low: zero,
            length: zero,
            lattice: zero,
            planes,
            count: 0,
            is_periodic: false,
            images: IfSheared::new(None),
            obstacles: IfObstacles::new(None),
        }
    }

    /// The same boundaries, lent for a while.
    pub(crate) fn lent(&mut self) -> Boundary<'_, S, D> {
        let Self { low, length, lattice, count, is_periodic, images, .. } = *self;
        let obstacles = IfObstacles::new(self.obstacles.get_mut().map(Obstacles::lent));
        Boundary {
            low,
            length,
            lattice,
            planes: self.planes,
            count,
            is_periodic,
            images,
            obstacles,
        }
    }

    /// How many planes there can be.
    pub(crate) fn capacity(&self) -> usize {
        self.planes.len().min(MAX_PLANES)
    }

    /// The boundaries for a snapshot.
    pub(crate) fn save(&self) -> SavedBoundary<S, D> {
        let mut length = self.length;
        for (axis, length) in length.iter_mut().enumerate() {
            *length = self.periodic(axis).map_or(S::zero(), |p| p.length);
        }
        SavedBoundary {
            low: self.low,
            length,
            planes: self.planes().iter().copied().collect(),
            shear: self.shear(),
            obstacles: self.fingerprint(),
        }
    }

    /// Takes over those of a snapshot, not yet sheared; false if there is no place for a plane.
    pub(crate) fn restore(&mut self, saved: &SavedBoundary<S, D>) -> bool {
        (self.low, self.length, self.count) = (saved.low, saved.length, 0);
        self.is_periodic = self.length.iter().any(|&length| length != S::zero());
        saved.planes.iter().all(|&plane| self.add_plane(plane))
    }

    /// Makes an axis periodic. Its length is put on the lattice of its positions. An axis that does not
    /// exist is ignored.
    pub(crate) fn set_periodic(
        &mut self,
        axis: usize,
        PeriodicAxis { low, length }: PeriodicAxis<S>,
    ) {
        let far = low.abs().max((low + length).abs());
        let lattice = S::lattice(far);
        let fields = [
            (&mut self.low, low),
            (&mut self.length, (length + lattice) - lattice),
            (&mut self.lattice, lattice),
        ];
        for (vector, value) in fields {
            if let Some(x) = vector.get_mut(axis) {
                *x = value;
            }
        }
        self.is_periodic = self.length.iter().any(|&length| length != S::zero());
    }

    /// Lets images move. All axes are known by now.
    ///
    /// # Errors
    /// What [`Images::new`] refuses.
    pub(crate) fn set_sheared(&mut self, shear: Shear<S>) -> Result<(), Error> {
        let axes = [shear.flow, shear.gradient].map(|axis| self.periodic(axis));
        let lattice = self.lattice.get(shear.flow).copied().unwrap_or(S::zero());
        self.images = IfSheared::new(Images::new(shear, axes, lattice)?);
        if let Some(length) =
            self.length.get_mut(shear.gradient).filter(|_| self.images.get().is_some())
        {
            *length = S::zero();
        }
        Ok(())
    }

    /// The shear of the box; none if nothing moves.
    #[must_use]
    pub fn shear(&self) -> Option<Shear<S>> {
        self.images.get().map(|images| images.shear)
    }

    /// How its images move.
    #[inline]
    pub(crate) fn images(&self) -> Option<&Images<S>> {
        self.images.get()
    }

    /// Adds a plane; false if there is no place for it.
    pub(crate) fn add_plane(&mut self, plane: Plane<S, D>) -> bool {
        let (most, number) = (self.capacity(), usize::from(self.count));
        match self.planes.get_mut(number).filter(|_| number < most) {
            Some(place) => {
                *place = plane;
                self.count += 1;
                true
            }
            None => false,
        }
    }

    /// From now on clocks count from this epoch.
    pub(crate) fn set_epoch(&mut self, epoch: Instant) {
        let planes = self.planes.iter_mut().take(self.count.into());
        planes.for_each(|plane| plane.set_epoch(epoch));
        self.images.get_mut().into_iter().for_each(|images| images.set_epoch(epoch));
        self.obstacles.get_mut().into_iter().for_each(|obstacles| obstacles.set_epoch(epoch));
    }

    /// What a periodic axis is; none if it is not one.
    #[must_use]
    pub fn periodic(&self, axis: usize) -> Option<PeriodicAxis<S>> {
        let sheared = self.images.get().filter(|images| images.shear.gradient == axis);
        sheared.map_or_else(|| self.at_rest(axis), |images| Some(images.across))
    }

    /// The same for an axis whose images stand beside each other.
    pub(crate) fn at_rest(&self, axis: usize) -> Option<PeriodicAxis<S>> {
        let (&low, &length) = (self.low.get(axis)?, self.length.get(axis)?);
        (length != S::zero()).then_some(PeriodicAxis { low, length })
    }

    /// An interval along an axis, with all obstacles in it, its ends put onto the planes that stand across that axis.
    pub(crate) fn between_planes(&self, axis: usize, [mut low, mut high]: [S; 2]) -> [S; 2] {
        if let Some([from, to]) = self.obstacles().map(|obstacles| obstacles.along(axis)) {
            (low, high) = (low.min(from), high.max(to));
        }
        for plane in self.planes() {
            match plane.normal.get(axis) {
                Some(&n) if n == S::one() => low = plane.offset,
                Some(&n) if n == -S::one() => high = -plane.offset,
                _ => {}
            }
        }
        [low, high]
    }

    /// The planes, in the order in which they were added.
    #[must_use]
    pub fn planes(&self) -> &[Plane<S, D>] {
        self.planes.get(..self.count.into()).unwrap_or_default()
    }

    /// Whether no axis is periodic: kept, so that nobody need look.
    #[inline]
    pub(crate) fn is_open(&self) -> bool {
        !self.is_periodic
    }

    /// The periodic axes and their numbers.
    pub fn periodic_axes(&self) -> impl Iterator<Item = (usize, PeriodicAxis<S>)> + '_ {
        (0..D).filter_map(|axis| self.periodic(axis).map(|p| (axis, p)))
    }

    /// The separation of the nearest images (minimum image), given that of two positions near the box.
    ///
    /// Both lie within a quarter of the box's length of it (the max_displacement sees to
    /// that), so one box length is all there can be to take off. Of a box that is [sheared](Shear) only images beside
    /// each other are compared; [`View::relative`](crate::View::relative) knows the others.
    #[must_use]
    #[inline]
    pub fn nearest(&self, separation: Vector<S, D>) -> Vector<S, D> {
        // Where branches cost nothing.
        #[cfg(not(feature = "alloc"))]
        if self.is_open() {
            return separation;
        }
        separation.zip_map(&self.length, |x, length| {
            let half = length * S::half();
            let over = if x > half { length } else { S::zero() };
            x - if x < -half { -length } else { over }
        })
    }

    /// Separation and relative velocity of the nearest images at a time, given those of two bodies near the box.
    #[inline(always)]
    pub(crate) fn relative(
        &self,
        [separation, velocity]: [Vector<S, D>; 2],
        time: S,
    ) -> [Vector<S, D>; 2] {
        match self.images.get() {
            None => [self.nearest(separation), velocity],
            Some(images) => self.relative_in(images, [separation, velocity], time),
        }
    }

    #[inline(never)]
    fn relative_in(
        &self,
        images: &Images<S>,
        [separation, velocity]: [Vector<S, D>; 2],
        time: S,
    ) -> [Vector<S, D>; 2] {
        let apart = separation.get(images.shear.gradient).copied().unwrap_or(S::zero());
        let [place, moves] = images.image(images.nearest_row(apart), time);
        // From one box into the next, and half a box moved: two lengths there can be.
        let nearest = self.nearest(self.nearest(separation - place));
        [nearest, velocity - moves]
    }

    /// How fast the next image moves; zero where none does.
    pub(crate) fn image_speed(&self) -> S {
        self.images.get().map_or(S::zero(), |images| images.speed.abs())
    }

    /// The velocity of the steady flow at a place of a sheared box: it grows by the shear rate along the gradient, and
    /// stands in the middle of the box. Zero where nothing is sheared.
    #[must_use]
    pub fn flow_at(&self, position: &Vector<S, D>) -> Vector<S, D> {
        self.images.get().map_or(Vector::zeros(), |images| images.flow_at(position))
    }

    /// How long a periodic axis is; zero for the others.
    #[cfg(feature = "alloc")]
    #[inline]
    pub(crate) fn periodic_length(&self, axis: usize) -> S {
        component(&self.length, axis)
    }

    /// A position on the lattice of the periodic axes.
    ///
    /// Where it lies beyond the box its image in the box is rounded: further out numbers are coarser, and the
    /// images of a pair would not be at the same distance.
    #[must_use]
    #[cfg_attr(not(feature = "alloc"), inline(never))]
    pub(crate) fn to_lattice(&self, x: Vector<S, D>) -> Vector<S, D> {
        let inside = self.wrap(x);
        self.on_lattice(inside) + (x - inside)
    }

    /// A step from one position on the lattice of the periodic axes to another; shorter than a box.
    #[must_use]
    #[inline]
    pub(crate) fn on_lattice(&self, x: Vector<S, D>) -> Vector<S, D> {
        (x + self.lattice) - self.lattice
    }

    /// A step on the lattice of the places that a position has, and on that of the periodic axes.
    #[must_use]
    pub(crate) fn on_lattice_near(&self, position: &Vector<S, D>, x: Vector<S, D>) -> Vector<S, D> {
        let lattice = self.lattice.zip_map(position, |own, at| own.max(S::lattice(at.abs())));
        (x + lattice) - lattice
    }

    /// The image inside the periodic box of a position near it.
    #[must_use]
    pub fn wrap(&self, position: Vector<S, D>) -> Vector<S, D> {
        let inside = |x: S, low: S, length: S| {
            if x < low {
                x + length
            } else if x >= low + length {
                x - length
            } else {
                x
            }
        };
        position.zip_zip_map(&self.low, &self.length, inside)
    }

    /// The image inside the box at a time of a position near it.
    pub(crate) fn place_inside(&self, position: Vector<S, D>, time: S) -> Vector<S, D> {
        if self.images.get().is_none() {
            return self.wrap(position);
        }
        let [position, _] = self.image_inside([position, Vector::zeros()], time);
        position
    }

    /// The image inside the periodic box of a position anywhere. Where it lies along the gradient of a shear stays.
    pub(crate) fn wrap_from_far(&self, mut position: Vector<S, D>) -> Vector<S, D> {
        for (axis, p) in (0..D).filter_map(|axis| self.at_rest(axis).map(|p| (axis, p))) {
            if let Some(x) = position.get_mut(axis) {
                *x -= p.length * ((*x - p.low) / p.length).floor();
            }
        }
        self.wrap(position)
    }

    /// Position and velocity of the image inside the box of something that is anywhere, at a time.
    pub(crate) fn image_inside(
        &self,
        [mut position, mut velocity]: [Vector<S, D>; 2],
        time: S,
    ) -> [Vector<S, D>; 2] {
        if let Some(images) = self.images.get() {
            let [place, moves] = images.image(images.row_of(&position), time);
            position -= place;
            velocity -= moves;
        }
        [self.wrap_from_far(position), velocity]
    }

    /// How far a grain may fly along a periodic axis before its neighbours must be looked at again.
    ///
    /// A pair is tried in its nearest image only. Another image is at least half a box away, so it
    /// cannot touch before the two have moved L/2 − 2 R_max against each other: half of it each.
    #[must_use]
    pub(crate) fn max_displacement(periodic: &PeriodicAxis<S>, largest_radius: S) -> S {
        (periodic.length * S::half() - (largest_radius + largest_radius)) * S::half()
    }
}
