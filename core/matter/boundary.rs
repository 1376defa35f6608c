//! Where does space end? Periodic axes and planes; reads positions, writes wrapped ones.

use super::plane::Plane;
use crate::number::{Instant, Scalar, Vector};

/// How many planes a world can have.
pub const MOST_PLANES: usize = 8;

/// A periodic axis from `low` to `low + length`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Periodic<S> {
    /// Where the box begins.
    pub low: S,
    /// How long it is.
    pub length: S,
}

/// All of a world's boundaries.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Boundary<S: Scalar, const D: usize> {
    axes: Vector<Option<Periodic<S>>, D>,
    planes: heapless::Vec<Plane<S, D>, MOST_PLANES>,
}

impl<S: Scalar, const D: usize> Default for Boundary<S, D> {
    /// Open space.
    fn default() -> Self {
        Self { axes: Vector::from([None; D]), planes: heapless::Vec::new() }
    }
}

impl<S: Scalar, const D: usize> Boundary<S, D> {
    /// Makes an axis periodic. An axis that does not exist is ignored.
    pub(crate) fn set_periodic(&mut self, axis: usize, periodic: Periodic<S>) {
        if let Some(a) = self.axes.get_mut(axis) {
            *a = Some(periodic);
        }
    }

    /// Adds a plane; false if there is no place for it.
    pub(crate) fn add_plane(&mut self, plane: Plane<S, D>) -> bool {
        self.planes.push(plane).is_ok()
    }

    /// From now on clocks count from this epoch.
    pub(crate) fn start_epoch(&mut self, epoch: Instant) {
        for vibration in self.planes.iter_mut().filter_map(|plane| plane.vibration.as_mut()) {
            vibration.start_epoch(epoch);
        }
    }

    /// What a periodic axis is; none if it is not one.
    #[must_use]
    pub fn periodic(&self, axis: usize) -> Option<Periodic<S>> {
        self.axes.get(axis).copied().flatten()
    }

    /// An interval along an axis, its ends put onto the planes that stand across that axis.
    pub(crate) fn between_planes(&self, axis: usize, [mut low, mut high]: [S; 2]) -> [S; 2] {
        for plane in &self.planes {
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
        &self.planes
    }

    /// The periodic axes and their numbers.
    pub fn periodic_axes(&self) -> impl Iterator<Item = (usize, Periodic<S>)> + '_ {
        self.axes.iter().enumerate().filter_map(|(a, p)| p.map(|p| (a, p)))
    }

    /// The separation of the nearest images (minimum image), given that of two positions near the box.
    ///
    /// Both lie within a quarter of the box's length of it (the leash sees to
    /// that), so one box length is all there can be to take off.
    #[must_use]
    pub fn nearest(&self, mut separation: Vector<S, D>) -> Vector<S, D> {
        for (x, axis) in separation.iter_mut().zip(self.axes.iter()) {
            if let Some(p) = axis {
                let half = p.length * S::half();
                if *x > half {
                    *x -= p.length;
                } else if *x < -half {
                    *x += p.length;
                }
            }
        }
        separation
    }

    /// The image inside the periodic box of a position near it.
    #[must_use]
    pub fn wrap(&self, mut position: Vector<S, D>) -> Vector<S, D> {
        for (x, axis) in position.iter_mut().zip(self.axes.iter()) {
            if let Some(p) = axis {
                if *x < p.low {
                    *x += p.length;
                } else if *x >= p.low + p.length {
                    *x -= p.length;
                }
            }
        }
        position
    }

    /// The image inside the periodic box of a position anywhere.
    pub(crate) fn wrap_from_afar(&self, mut position: Vector<S, D>) -> Vector<S, D> {
        for (x, axis) in position.iter_mut().zip(self.axes.iter()) {
            if let Some(p) = axis {
                *x -= p.length * ((*x - p.low) / p.length).round_down();
            }
        }
        self.wrap(position)
    }

    /// How far a grain may fly along a periodic axis before its neighbours must be looked at again.
    ///
    /// A pair is tried in its nearest image only. Another image is at least half a box away, so it
    /// cannot touch before the two have moved L/2 − 2 R_max against each other: half of it each.
    #[must_use]
    pub(crate) fn leash(periodic: &Periodic<S>, largest_radius: S) -> S {
        (periodic.length * S::half() - (largest_radius + largest_radius)) * S::half()
    }
}
