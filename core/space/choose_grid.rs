//! How wide are the cells? Reads the boundary, the grains' density and their reach at the start; writes nothing, returns a grid.

use super::boundary::Boundary;
use super::grid::{Grid, GridAxis, MAX_AXES, NOWHERE};
use crate::particle::Body;
#[cfg(not(feature = "alloc"))]
use crate::scalar::Real;
use crate::scalar::Scalar;

/// In what widths are computed. `f64` in software takes 5 KB of flash, and nothing else here needs it; a last place
/// in the width of cells decides nothing.
#[cfg(feature = "alloc")]
pub(super) type Width = f64;
#[cfg(not(feature = "alloc"))]
pub(super) type Width = f32;

/// The width of a cell, if grains are far from each other, in units of the space a grain has: measured.
#[cfg(feature = "alloc")]
const CELL_WIDTH: Width = 0.8;
/// On small machines it is a matter of how much memory is lent for lists.
#[cfg(not(feature = "alloc"))]
const CELL_WIDTH: Width = 0.5;

/// Cells are wider by this than grains can see: a grain that rounding puts beside its cell is seen, too.
pub(super) const SLACK: Width = 1.001;

/// The grid with at least half a grain a cell, cells no narrower than `reach`, at most `most` of them;
/// none if that leaves fewer than four along a periodic axis.
pub(super) fn choose<S: Scalar, const D: usize>(
    boundary: &Boundary<'_, S, D>,
    bodies: &[Body<S, D>],
    reach: Width,
    most: usize,
) -> Option<Grid<S, D>> {
    let sides = sides(boundary, bodies);
    let width = (SLACK * reach).max(dense_width(&sides, bodies.len()));
    with_width(boundary, &sides, width, most)
}

/// From where to where the grains can be along each axis.
pub(super) fn sides<S: Scalar, const D: usize>(
    boundary: &Boundary<'_, S, D>,
    bodies: &[Body<S, D>],
) -> [[S; 2]; D] {
    core::array::from_fn(|axis| extent(boundary, bodies, axis))
}

/// The nearest width.
#[inline]
pub(super) fn width_of<S: Scalar>(x: S) -> Width {
    x.to_f64() as Width
}

/// The width of cells for so many grains that are points.
pub(super) fn dense_width<S: Scalar, const D: usize>(sides: &[[S; 2]; D], grains: usize) -> Width {
    let volume: Width = sides.iter().map(|[low, high]| width_of(*high - *low)).product();
    CELL_WIDTH * side_of::<D>(volume / grains.max(1) as Width)
}

/// The side of a cube, a square or a line of this volume.
#[cfg(feature = "alloc")]
fn side_of<const D: usize>(volume: Width) -> Width {
    libm::pow(volume, 1.0 / D as f64)
}

/// The same; for more than three axes there are no cells.
#[cfg(not(feature = "alloc"))]
fn side_of<const D: usize>(volume: Width) -> Width {
    match D {
        1 => volume,
        2 => Real::sqrt(volume),
        _ => Real::cbrt(volume),
    }
}

#[cfg(feature = "alloc")]
fn number(count: u32) -> Width {
    f64::from(count)
}

/// The nearest number.
#[cfg(not(feature = "alloc"))]
fn number(count: u32) -> Width {
    count as Width
}

/// The grid whose cells have this width at least, at most `most` of them.
pub(super) fn with_width<S: Scalar, const D: usize>(
    boundary: &Boundary<'_, S, D>,
    sides: &[[S; 2]; D],
    mut width: Width,
    most: usize,
) -> Option<Grid<S, D>> {
    if !(width > 0.0 && width.is_finite()) || D > MAX_AXES {
        return None;
    }
    // Each round makes cells an eighth wider; 500 of them span any range of widths.
    for _ in 0..500 {
        let along = |axis| {
            let side = sides.get(axis).copied().unwrap_or_default();
            along(side, boundary.at_rest(axis).map(|p| p.length), width)
        };
        let axes: [GridAxis<S>; D] = core::array::from_fn(along);
        let cells: Width = axes.iter().map(|along| number(along.count)).product();
        let is_round = |axis: usize| boundary.periodic(axis).is_some();
        if axes.iter().enumerate().any(|(axis, along)| is_round(axis) && along.count < 4) {
            return None;
        }
        if cells <= most.min(NOWHERE as usize) as Width {
            return (cells >= 8.0).then(|| Grid::new(axes));
        }
        width *= 1.125;
    }
    None
}

/// From where to where the grains can be along an axis: the box, or where they are at the start.
fn extent<S: Scalar, const D: usize>(
    boundary: &Boundary<'_, S, D>,
    bodies: &[Body<S, D>],
    axis: usize,
) -> [S; 2] {
    if let Some(p) = boundary.periodic(axis) {
        return [p.low, p.low + p.length];
    }
    let (mut low, mut high) = (S::NEVER, -S::NEVER);
    for body in bodies.iter().filter(|body| !body.is_vacant()) {
        if let Some(&x) = body.position.get(axis) {
            low = low.min(x - body.radius);
            high = high.max(x + body.radius);
        }
    }
    boundary.between_planes(axis, [low, high])
}

fn along<S: Scalar>([low, high]: [S; 2], periodic: Option<S>, width: Width) -> GridAxis<S> {
    let length = periodic.unwrap_or(high - low);
    let count = ((width_of(length) / width) as u32).clamp(1, 1 << 20);
    GridAxis {
        low,
        width: length / S::from_count(count),
        count,
        periodic: periodic.is_some(),
        length: periodic.unwrap_or(S::zero()),
    }
}
