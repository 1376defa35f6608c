//! In which list is a grain without the feature `alloc`? Always in that of its cell: small machines carry no levels; reads and writes nothing.

use super::boundary::Boundary;
use super::choose_grid;
use super::grid::Grid;
use super::sight::Sight;
use crate::particle::Body;
use crate::scalar::Scalar;

/// One grid for all grains.
#[derive(Clone, Debug)]
pub(crate) struct Levels<const D: usize>;

impl<const D: usize> Levels<D> {
    pub fn sight(&self) -> Sight {
        Sight { may_crowd: false }
    }

    pub fn len(&self) -> usize {
        1
    }

    #[inline(always)]
    pub fn list<S: Scalar>(&self, _: &Grid<S, D>, cell: u32, _: S) -> u32 {
        cell
    }

    pub fn finest<S: Scalar>(&self, largest: S) -> S {
        largest
    }

    /// Those over this grid, if it serves all grains.
    pub fn over<S: Scalar>(
        grid: &Grid<S, D>,
        bodies: &[Body<S, D>],
        _: Sight,
        _: usize,
    ) -> Option<Self> {
        let largest = bodies.iter().fold(S::zero(), |largest, body| largest.max(body.radius));
        let mut axes = grid.axes().iter().filter(|along| along.periodic || along.count > 1);
        axes.all(|along| along.width >= largest + largest).then_some(Self)
    }
}

/// The grid for these grains; no more lists than there is room for.
pub(crate) fn choose_cells<S: Scalar, const D: usize>(
    boundary: &Boundary<'_, S, D>,
    bodies: &[Body<S, D>],
    sight: Sight,
    most: usize,
) -> (Option<Grid<S, D>>, Levels<D>) {
    let largest = bodies.iter().fold(S::zero(), |largest, body| largest.max(body.radius));
    let reach = choose_grid::width_of(sight.of_equal(largest));
    (choose_grid::choose(boundary, bodies, reach, most), Levels)
}
