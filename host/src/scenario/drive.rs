//! What drives a scenario? Reads the file's `[[drive]]`; checks it, writes the sources of a driven run.

use super::observe::Axis;
use super::problem::Problems;
use super::side::Side;
use super::sides::{SideSpec, SurfaceSpec};
use super::spec::Scenario;
use super::start::Start;
use crate::drive::{Action, Gravity, Source, Vector};
use schemars::JsonSchema;
use serde::Deserialize;

/// What gives grains energy, or changes them while they run. Event-driven methods only.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum DriveSpec {
    /// A hard wall or plate from which grains come as from a gas behind it: along the normal from Maxwell's flux, across it
    /// from his distribution.
    ThermalWall {
        /// Across which axis.
        axis: Axis,
        /// Which of two walls; a plate is the lower one.
        #[serde(default)]
        side: EndName,
        /// k T (J).
        temperature: f64,
    },
    /// Andersen's thermostat: grains get new velocities from Maxwell's distribution.
    Andersen {
        /// k T (J).
        temperature: f64,
        /// How often a grain gets one (1/s).
        rate: f64,
    },
    /// White noise: every velocity gets a random kick, all together no momentum.
    WhiteNoise {
        /// ξ², by which the variance of a component grows (m²/s³).
        strength: f64,
        /// Time between two kicks (s); short against the mean free time.
        interval: f64,
    },
    /// Gravity in steps.
    GravityTable {
        /// Rows of a time (s) and a number for each axis (m/s²): gravity from that time on.
        rows: Vec<Vec<f64>>,
    },
    /// Gravity that turns in the plane of two axes, from the first to the second.
    TurningGravity {
        /// g (m/s²).
        magnitude: f64,
        /// In which plane.
        axes: [Axis; 2],
        /// How long a turn takes (s).
        period: f64,
        /// In how many steps.
        #[serde(default = "steps")]
        steps: u32,
    },
    /// A grain gets a kick.
    Kick {
        /// When (s).
        time: f64,
        /// Which: they are counted from 0, in the order of the file.
        grain: usize,
        /// What is added to its velocity (m/s).
        by: Vec<f64>,
    },
    /// A grain gets a velocity.
    SetVelocity {
        /// When (s).
        time: f64,
        /// Which: they are counted from 0, in the order of the file.
        grain: usize,
        /// The velocity (m/s).
        to: Vec<f64>,
    },
}

const fn steps() -> u32 {
    360
}

/// An end of an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum EndName {
    /// The lower one.
    #[default]
    Low,
    /// The upper one.
    High,
}

/// Notes what is wrong with what drives a scenario.
pub fn check(scenario: &Scenario, problems: &mut Problems) {
    for (k, drive) in scenario.drives.iter().enumerate() {
        let path = format!("drive.{k}");
        let below = |field: &str| format!("{path}.{field}");
        let d = scenario.dimension;
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
        }
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
