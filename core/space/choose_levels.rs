//! One grid, or levels of cells? Reads the boundary and all radii at the start; writes nothing, returns both.

use super::boundary::Boundary;
use super::choose_grid::{self, SLACK, dense_width, sides, with_width};
use super::grid::Grid;
use super::levels::Levels;
use super::sight::Sight;
use crate::particle::Body;
use crate::scalar::Scalar;

/// With fewer grains one grid, or none, is faster.
const FEWEST: usize = 32;

/// The grid for these grains, and its levels; no more lists than there is room for.
pub(crate) fn choose_cells<S: Scalar, const D: usize>(
    boundary: &Boundary<'_, S, D>,
    bodies: &[Body<S, D>],
    sight: Sight,
    most: usize,
) -> (Option<Grid<S, D>>, Levels<D>) {
    let grains = bodies.iter().filter(|body| !body.is_vacant());
    let radii = grains.map(|body| body.radius.to_f64());
    let largest = radii.fold(0.0, f64::max);
    levels(boundary, bodies, (sight, largest), most).map_or_else(
        || {
            let grid = choose_grid::choose(boundary, bodies, sight.of_equal(largest), most);
            (grid, Levels::one(sight))
        },
        |(grid, levels)| (Some(grid), levels),
    )
}

/// Levels over cells for small grains, if so many of them are in a cell for large ones that it is worth it.
fn levels<S: Scalar, const D: usize>(
    boundary: &Boundary<'_, S, D>,
    bodies: &[Body<S, D>],
    (sight, largest): (Sight, f64),
    most: usize,
) -> Option<(Grid<S, D>, Levels<D>)> {
    if boundary.images().is_some() {
        // Those across a sheared face are found row by row of the grid's own cells.
        return None;
    }
    let sides = sides(boundary, bodies);
    let dense = dense_width(&sides, bodies.len());
    let reach = |radius: f64| SLACK * sight.of_equal(radius);
    if bodies.len() < FEWEST || !(dense > 0.0 && reach(0.5 * largest) >= dense) {
        return None;
    }
    // The smallest radius over a power of two whose cells are no finer than the grains are dense.
    let mut finest = largest;
    while reach(0.5 * finest) >= dense {
        finest *= 0.5;
    }
    // An eighth of the lists is for the wider cells.
    let grid = with_width(boundary, &sides, reach(finest), most - most / 8)?;
    let levels = Levels::over(&grid, bodies, sight, most)?;
    (!levels.is_one()).then_some((grid, levels))
}
