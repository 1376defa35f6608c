//! Can this box be sheared? Reads a scenario; writes a list of what is wrong.

use super::drive::DriveSpec;
use super::observe::Axis;
use super::problem::Problems;
use super::sides::SideSpec;
use super::spec::Scenario;

/// What is wrong with `[box.shear]`, and with what cannot be beside it.
pub fn check(scenario: &Scenario, problems: &mut Problems) {
    let Some(shear) = scenario.sides.shear else { return };
    problems.finite("box.shear.rate", &[shear.rate]);
    if shear.flow == shear.gradient {
        problems.add("box.shear.gradient", "is the axis of the flow, must be another");
    }
    for (field, axis) in [("flow", shear.flow), ("gradient", shear.gradient)] {
        is_periodic(scenario, &format!("box.shear.{field}"), axis, problems);
    }
    if scenario.gravity.iter().any(|g| *g != 0.0) {
        problems.say("gravity", "gravity: a sheared box has none: leave out gravity or box.shear");
    }
    let turns = |drive: &DriveSpec| {
        matches!(drive, DriveSpec::GravityTable { .. } | DriveSpec::TurningGravity { .. })
    };
    if let Some(number) = scenario.drives.iter().position(turns) {
        let message = format!("drive {number}: a sheared box has no gravity: leave it out");
        problems.say(format!("drive.{number}"), message);
    }
}

fn is_periodic(scenario: &Scenario, path: &str, axis: Axis, problems: &mut Problems) {
    let name = axis.name();
    let (_, side) = scenario.sides.named()[axis.number()];
    if axis.number() >= scenario.dimension {
        problems.add(path, format!("is {name}, but dimension is {}", scenario.dimension));
    } else if !matches!(side, SideSpec::Periodic { .. }) {
        problems.add(path, format!("is {name}, but box.{name} is not periodic: make it so"));
    }
}
