//! What do the sources of a driven run know of its scenario? Reads both; writes nothing, returns the sources.

use super::drive::{DriveSpec, EndName};
use super::observe::Axis;
use super::side::Side;
use super::spec::Scenario;
use super::start::Start;
use crate::drive::{Action, Gravity, Source, Vector};

/// The sources of a scenario that has been checked, for worlds of this dimension.
pub fn sources<const D: usize>(scenario: &Scenario, start: &Start) -> Vec<Source<D>> {
    scenario.drives.iter().map(|drive| source(drive, start)).collect()
}

fn source<const D: usize>(drive: &DriveSpec, start: &Start) -> Source<D> {
    let at = |time, action| Source::At { time, action };
    match drive {
        &DriveSpec::ThermalWall { axis, side, temperature } => {
            Source::ThermalWall { plane: plane(start, axis, side), temperature }
        }
        &DriveSpec::Andersen { temperature, rate } => Source::Andersen { temperature, rate },
        &DriveSpec::WhiteNoise { strength, interval } => Source::WhiteNoise { strength, interval },
        DriveSpec::GravityTable { rows } => {
            let row = |row: &Vec<f64>| (row[0], components(&row[1..]));
            Source::Gravity(Gravity::Table(rows.iter().map(row).collect()))
        }
        &DriveSpec::TurningGravity { magnitude, axes, period, steps } => {
            let axes = axes.map(|axis| axis as usize);
            Source::Gravity(Gravity::Rotating { magnitude, axes, period, steps })
        }
        DriveSpec::Kick { time, grain, by } => at(*time, Action::Kick(*grain, components(by))),
        DriveSpec::SetVelocity { time, grain, to } => {
            at(*time, Action::SetVelocity(*grain, components(to)))
        }
        DriveSpec::Remove { time, grain } => at(*time, Action::Remove(*grain)),
    }
}

fn components<const D: usize>(numbers: &[f64]) -> Vector<D> {
    Vector(std::array::from_fn(|axis| numbers.get(axis).copied().unwrap_or(0.0)))
}

/// The number of a wall's plane: worlds have one for a plate and two for walls, axis by axis.
fn plane(start: &Start, axis: Axis, end: EndName) -> usize {
    let planes = |side: &Side| match side {
        Side::Open | Side::Periodic(_) => 0,
        Side::Plate(..) => 1,
        Side::Walls(..) => 2,
    };
    start.sides[..axis as usize].iter().map(planes).sum::<usize>() + end as usize
}
