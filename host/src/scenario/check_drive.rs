//! Can this drive a scenario? Reads its `[[drive]]`; writes a list of what is wrong.

use super::drive::{DriveSpec, EndName};
use super::observe::Axis;
use super::problem::Problems;
use super::sides::{SideSpec, SurfaceSpec};
use super::spec::Scenario;

/// Notes what is wrong with what drives a scenario.
pub fn check(scenario: &Scenario, problems: &mut Problems) {
    for (k, drive) in scenario.drives.iter().enumerate() {
        let path = format!("drive.{k}");
        let below = |field: &str| format!("{path}.{field}");
        let d = scenario.dimension;
        if let Some(grain) = is_gone(&scenario.drives, k) {
            problems.add(below("grain"), format!("is {grain}, which is taken out before"));
        }
        match drive {
            DriveSpec::ThermalWall { axis, side, temperature } => {
                problems.positive(&below("temperature"), *temperature);
                wall(scenario, &path, (*axis, *side), problems);
            }
            DriveSpec::Andersen { temperature, rate } => {
                problems.positive(&below("temperature"), *temperature);
                problems.positive(&below("rate"), *rate);
            }
            DriveSpec::WhiteNoise { strength, interval } => {
                problems.positive(&below("strength"), *strength);
                problems.positive(&below("interval"), *interval);
            }
            DriveSpec::GravityTable { rows } => table(&below("rows"), rows, d, problems),
            DriveSpec::TurningGravity { magnitude, axes: [a, b], period, steps } => {
                problems.finite(&below("magnitude"), &[*magnitude]);
                problems.positive(&below("period"), *period);
                let enough = *steps >= 3;
                problems.must(&below("steps"), f64::from(*steps), enough, "at least 3");
                if a == b || (*a as usize).max(*b as usize) >= d {
                    problems.add(below("axes"), format!("must be two of the {d} axes"));
                }
            }
            DriveSpec::Kick { time, by: v, .. } | DriveSpec::SetVelocity { time, to: v, .. } => {
                problems.not_negative(&below("time"), *time);
                let field = if matches!(drive, DriveSpec::Kick { .. }) { "by" } else { "to" };
                problems.vector(&below(field), v, d);
            }
            DriveSpec::Remove { time, .. } => {
                problems.not_negative(&below("time"), *time);
            }
        }
    }
}

/// The grain that something is to happen to when it has been taken out already.
fn is_gone(drives: &[DriveSpec], which: usize) -> Option<usize> {
    let (time, grain) = happens(&drives[which])?;
    let mut removals = drives.iter().enumerate().filter(|(k, drive)| {
        let is_removal = matches!(drive, DriveSpec::Remove { .. });
        *k != which && is_removal && happens(drive).is_some_and(|(_, one)| one == grain)
    });
    let before = |(k, drive): (usize, &DriveSpec)| {
        happens(drive).is_some_and(|(at, _)| at < time || at == time && k < which)
    };
    removals.any(before).then_some(grain)
}

/// When something happens to one grain, and to which.
fn happens(drive: &DriveSpec) -> Option<(f64, usize)> {
    match drive {
        DriveSpec::Kick { time, grain, .. }
        | DriveSpec::SetVelocity { time, grain, .. }
        | DriveSpec::Remove { time, grain } => Some((*time, *grain)),
        _ => None,
    }
}

/// A thermal wall must be there, and hard: it says itself how fast grains leave it.
fn wall(scenario: &Scenario, path: &str, (axis, end): (Axis, EndName), problems: &mut Problems) {
    let sides = [&scenario.sides.x, &scenario.sides.y, &scenario.sides.z];
    let name = ["x", "y", "z"][axis as usize];
    let side = sides[axis as usize];
    let is_there = match side {
        SideSpec::Walls { .. } => true,
        SideSpec::Plate { .. } => end == EndName::Low,
        SideSpec::Open | SideSpec::Periodic { .. } => false,
    };
    let (surface, restitution, _) = side.surface().unwrap_or_default();
    let is_hard = surface == Some(SurfaceSpec::Hard) || restitution.is_some();
    if !is_there || axis as usize >= scenario.dimension {
        let which = if end == EndName::Low { "lower" } else { "upper" };
        problems.add(
            format!("{path}.axis"),
            format!("is {name:?}, but box.{name} has no {which} wall"),
        );
    } else if !is_hard {
        let rest =
            format!("is {name:?}, but box.{name} has soft walls; a thermal one must be hard");
        problems.add(format!("{path}.axis"), rest);
    }
}

fn table(path: &str, rows: &[Vec<f64>], dimension: usize, problems: &mut Problems) {
    let width = dimension + 1;
    if let Some(row) = rows.iter().find(|row| row.len() != width) {
        let rest = format!("has a row of {}, must have {width}: a time and gravity", row.len());
        problems.add(path, rest);
        return;
    }
    rows.iter().for_each(|row| problems.finite(path, row));
    let grows = rows.windows(2).all(|pair| pair[0][0] < pair[1][0]);
    if rows.is_empty() || !grows || rows[0][0] < 0.0 {
        problems.add(path, "must have times that grow from at least 0");
    }
}
