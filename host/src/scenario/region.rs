//! Where may grains be placed? Reads the box and a species' corners; writes nothing, returns a box with two corners.

use super::grains::PlaceSpec;
use super::problem::{Problem, named};
use super::side::Side;

/// A box in which grains are placed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Region {
    /// 1, 2 or 3.
    pub dimension: usize,
    /// Both corners; 0 beyond the dimension.
    pub axes: [[f64; 2]; 3],
    /// Along which axes it goes all round the box.
    pub periodic: [bool; 3],
}

/// How full a region without a lid is: about as loosely as grains can be poured.
const LOOSE: f64 = 0.2;

impl Region {
    /// The part of the box that `from` and `to` leave; above a plate without `to`, as high as these
    /// grains, which fill so much, need for the packing fraction (0.2 if none is given).
    ///
    /// # Errors
    /// When an axis has no end.
    pub fn new(
        (path, place): (&str, &PlaceSpec),
        dimension: usize,
        sides: &[Side; 3],
        (filled, packing): (f64, Option<f64>),
    ) -> Result<Self, Problem> {
        let [from, to] = place.corners();
        let corner = |corner: Option<&Vec<f64>>, axis: usize| corner?.get(axis).copied();
        let mut region = Self { dimension, axes: [[0.0; 2]; 3], periodic: [false; 3] };
        let mut lidless = None;
        for (axis, side) in sides.iter().enumerate().take(dimension) {
            let (from, to) = (corner(from, axis), corner(to, axis));
            let [low, high] = side.room();
            let is_whole =
                from.is_none_or(|from| Some(from) == low) && to.is_none_or(|to| Some(to) == high);
            region.periodic[axis] = matches!(side, Side::Periodic(_)) && is_whole;
            let Some(begin) = from.or(low) else {
                return Err(endless(path, axis, "from and to are"));
            };
            let Some(end) = to.or(high) else {
                if lidless.is_some() || matches!(side, Side::Open) {
                    return Err(endless(path, axis, "to is"));
                }
                lidless = Some(axis);
                region.axes[axis] = [begin; 2];
                continue;
            };
            region.axes[axis] = [begin, end];
            if !(begin < end) {
                let message = format!("{}: nothing lies from {begin} to {end}", named(path));
                return Err(Problem { path: path.to_owned(), offset: None, message });
            }
        }
        if let Some(axis) = lidless {
            let across: f64 =
                (0..dimension).filter(|&k| k != axis).map(|k| region.length(k)).product();
            region.axes[axis][1] += filled / (packing.unwrap_or(LOOSE) * across);
        }
        Ok(region)
    }

    /// Its extent along an axis.
    pub fn length(&self, axis: usize) -> f64 {
        self.axes[axis][1] - self.axes[axis][0]
    }

    /// Length, area or volume.
    pub fn volume(&self) -> f64 {
        (0..self.dimension).map(|axis| self.length(axis)).product()
    }
}

fn endless(path: &str, axis: usize, what: &str) -> Problem {
    let axis = ["x", "y", "z"][axis];
    let message =
        format!("{}: box.{axis} is open, so {what} needed to say where grains are", named(path));
    Problem { path: path.to_owned(), offset: None, message }
}
