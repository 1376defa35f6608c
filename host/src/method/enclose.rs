//! What is around the grains? Reads the sides of a start; writes planes, periodic axes and a flow.

use super::obstacles::surface;
use crate::scenario::{Made, Shaking, Side, Start};
use carom::space::{Drift, Plane, Shear, Vibration};
use carom::world::WorldBuilder;
use carom_reference::Plate;

/// A world within these sides.
pub(super) fn enclose<'m, const D: usize, R>(
    mut builder: WorldBuilder<'m, f64, D, R>,
    start: &Start,
) -> WorldBuilder<'m, f64, D, R> {
    for (axis, side) in start.sides.iter().enumerate().take(D) {
        match *side {
            Side::Open => {}
            Side::Periodic(range) => builder = builder.periodic_axis(axis, range),
            Side::Plate(plate, made) => {
                let Plate { at, amplitude, frequency, phase } = plate;
                let shaking = Shaking { amplitude, frequency, phase };
                let steady = start.steady[axis][0];
                builder = builder.plane(wall(axis, (at, 1.0), made, Some(shaking), steady));
            }
            Side::Walls([from, to], made, shaking) => {
                for (end, steady) in [(from, 1.0), (to, -1.0)].into_iter().zip(start.steady[axis]) {
                    builder = builder.plane(wall(axis, end, made, shaking, steady));
                }
            }
        }
    }
    match start.flow {
        Some(flow) => builder.sheared(Shear::new(flow.along, flow.gradient, flow.rate)),
        None => builder,
    }
}

/// The wall across an axis that faces up or down it; a positive amplitude moves it up first, wherever it faces, and a
/// positive steady speed up all the time.
fn wall<const D: usize>(
    axis: usize,
    (at, facing): (f64, f64),
    made: Made,
    shaking: Option<Shaking>,
    steady: f64,
) -> Plane<f64, D> {
    let mut normal = [0.0; D];
    normal[axis] = facing;
    let plane = Plane::new(normal, facing * at, surface(made));
    match shaking.filter(|shaking| shaking.amplitude != 0.0) {
        Some(Shaking { amplitude, frequency, phase }) => {
            plane.vibrating(Vibration::new(facing * amplitude, frequency).starting_at(phase))
        }
        None if steady != 0.0 => plane.drifting(Drift::new(facing * steady)),
        None => plane,
    }
}
