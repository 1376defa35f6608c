//! Can these obstacles stand there? Reads a scenario; writes a list of what is wrong.

use super::check_fields::made_of;
use super::laws::Laws;
use super::obstacle::ObstacleSpec;
use super::options::EnduringSpec;
use super::problem::Problems;
use super::sides::SideSpec;
use super::spec::Scenario;

/// What is wrong with `[[obstacle]]`, and with what cannot be beside it.
pub fn check(scenario: &Scenario, laws: &Laws, problems: &mut Problems) {
    for (number, obstacle) in scenario.obstacles.iter().enumerate() {
        one(scenario, laws, (number, obstacle), problems);
    }
    if scenario.obstacles.is_empty() {
        return;
    }
    let moving = scenario.obstacles.iter().filter(|obstacle| !obstacle.motions().is_empty());
    if moving.clone().count() > 256 {
        let message = format!("{} obstacles move: 256 can", moving.count());
        problems.say("obstacle", message);
    }
    for (name, side) in scenario.sides.named() {
        if matches!(side, SideSpec::Periodic { .. }) {
            let message = format!(
                "box.{name} is periodic, but there is [[obstacle]]: images of obstacles there are none"
            );
            problems.say(format!("box.{name}"), message);
        }
    }
    if scenario.options.enduring == EnduringSpec::Paper {
        let message = "options.enduring is paper, but there is [[obstacle]]: the papers have none";
        problems.say("options.enduring", message);
    }
}

fn one(
    scenario: &Scenario,
    laws: &Laws,
    (number, obstacle): (usize, &ObstacleSpec),
    problems: &mut Problems,
) {
    let path = format!("obstacle.{number}");
    let below = |field: &str| format!("{path}.{field}");
    if obstacle.shapes() != 1 {
        let message = format!("obstacle {number}: give one of polygon, chain, triangles and file");
        problems.say(&path, message);
        return;
    }
    let flat = [("polygon", &obstacle.polygon, 3), ("chain", &obstacle.chain, 2)];
    for (field, points, least) in flat {
        let Some(points) = points else { continue };
        in_dimension(scenario, &below(field), 2, problems);
        if points.len() < least {
            let rest = format!("has {} corners, must have at least {least}", points.len());
            problems.add(below(field), rest);
        }
        for (k, point) in points.iter().enumerate() {
            problems.vector(&format!("{}.{k}", below(field)), point, 2);
        }
    }
    for (k, triangle) in obstacle.triangles.iter().flatten().enumerate() {
        let triangle_path = format!("{}.{k}", below("triangles"));
        if triangle.len() != 3 {
            problems.add(&triangle_path, format!("has {} corners, must have 3", triangle.len()));
        }
        for (n, corner) in triangle.iter().enumerate() {
            problems.vector(&format!("{triangle_path}.{n}"), corner, 3);
        }
    }
    for field in ["triangles", "file"] {
        let is_given =
            if field == "file" { obstacle.file.is_some() } else { obstacle.triangles.is_some() };
        if is_given {
            in_dimension(scenario, &below(field), 3, problems);
        }
    }
    if let Some(unit) = obstacle.unit {
        problems.positive(&below("unit"), unit);
        if obstacle.file.is_none() {
            problems.add(below("unit"), "is given, but there is no file: corners are in metres");
        }
    }
    if !obstacle.at.is_empty() {
        problems.vector(&below("at"), &obstacle.at, scenario.dimension);
    }
    problems.finite(&below("speed"), &[obstacle.speed]);
    motion(scenario, &path, obstacle, problems);
    let is_flat = obstacle.polygon.is_some() || obstacle.chain.is_some();
    if obstacle.speed != 0.0 && !is_flat {
        problems.add(below("speed"), "is given, but only polygons and chains run along themselves");
    }
    if obstacle.closed && is_flat {
        problems.add(below("closed"), "is given, but only meshes have holes: a polygon is closed");
    }
    if obstacle.solid && obstacle.chain.is_some() {
        problems.add(below("solid"), "is given, but a chain has no inside: give a polygon");
    }
    made_of(&path, obstacle.made(), laws, problems);
}

/// What is wrong with how it moves.
fn motion(scenario: &Scenario, path: &str, obstacle: &ObstacleSpec, problems: &mut Problems) {
    let below = |field: &str| format!("{path}.{field}");
    if let [first, second, ..] = obstacle.motions()[..] {
        problems.add(below(second), format!("is given, but so is {first}: it moves in one way"));
    }
    let axes = scenario.dimension;
    if let Some(velocity) = &obstacle.velocity {
        problems.vector(&below("velocity"), velocity, axes);
    }
    if let Some(vibration) = &obstacle.vibration {
        problems.vector(&below("vibration.amplitude"), &vibration.amplitude, axes);
        problems.positive(&below("vibration.frequency"), vibration.frequency);
        problems.finite(&below("vibration.phase"), &[vibration.phase]);
    }
    if let Some(rotation) = &obstacle.rotation {
        problems.vector(&below("rotation.centre"), &rotation.centre, axes);
        let (omega, components) = (&rotation.angular_velocity, if axes == 3 { 3 } else { 1 });
        problems.vector(&below("rotation.angular_velocity"), omega, components);
        if omega.iter().all(|&component| component == 0.0) {
            problems.add(below("rotation.angular_velocity"), "is 0: then it stands");
        }
    }
}

fn in_dimension(scenario: &Scenario, path: &str, dimension: usize, problems: &mut Problems) {
    if scenario.dimension != dimension {
        problems
            .add(path, format!("needs dimension {dimension}, but it is {}", scenario.dimension));
    }
}
