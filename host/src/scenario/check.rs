//! Can this scenario be run? Reads a scenario whose fields are all there; writes a list of what is wrong.

use super::check_fields::{density, made_of, material, radius};
use super::check_laws::materials;
use super::grains::{Gas, GrainSpec};
use super::laws::Laws;
use super::obstacle::ObstacleSpec;
use super::problem::Problems;
use super::sides::SideSpec;
use super::spec::{MethodName, Scenario};
use super::{check_drive, check_friction, check_obstacles, check_shear, check_species, memory};

/// Everything that is wrong with it.
pub fn check(scenario: &Scenario) -> Problems {
    let mut problems = Problems::default();
    let d = scenario.dimension;
    if !(1..=3).contains(&d) {
        problems.add("dimension", format!("is {d}, must be 1, 2 or 3"));
        return problems;
    }
    if !scenario.gravity.is_empty() {
        problems.vector("gravity", &scenario.gravity, d);
    }
    end(scenario, &mut problems);
    sample(scenario, &mut problems);
    if let Some(Err(error)) =
        scenario.observe.as_ref().map(|o| o.check(scenario.sample, scenario.duration))
    {
        let message = error.to_string();
        let path = message.split([' ', ':']).next().unwrap_or_default().to_owned();
        problems.say(path, message);
    }
    if let Some(time) = scenario.options.exact_until {
        problems.positive("options.exact_until", time);
    }
    problems.not_negative("options.tc", scenario.options.tc);
    let laws = materials(scenario, &mut problems);
    sides(scenario, &laws, &mut problems);
    check_obstacles::check(scenario, &laws, &mut problems);
    check_friction::check(scenario, &mut problems);
    methods(scenario, &mut problems);
    if scenario.grains.is_empty() && scenario.gas.is_none() && scenario.species.is_empty() {
        problems.say("", "no grains: add [[grain]] entries, [[species]] or a [gas]");
    }
    for (number, one) in scenario.grains.iter().enumerate() {
        grain(scenario, &laws, number, one, &mut problems);
    }
    if let Some(one) = &scenario.gas {
        gas(scenario, &laws, one, &mut problems);
    }
    check_species::check(scenario, &laws, &mut problems);
    check_drive::check(scenario, &mut problems);
    check_shear::check(scenario, &mut problems);
    // Who is called by a wrong name seems to have no law, either.
    let is_about_names = |path: &str| path.ends_with(".between") || path.ends_with(".name");
    if !problems.0.iter().any(|problem| is_about_names(&problem.path)) {
        touches(scenario, &laws, &mut problems);
    }
    problems
}

fn end(scenario: &Scenario, problems: &mut Problems) {
    match (scenario.duration, scenario.collisions) {
        (Some(duration), None) => _ = problems.positive("duration", duration),
        (None, Some(0)) => problems.add("collisions", "is 0, must be at least 1"),
        (None, Some(_)) => {}
        (Some(_), Some(_)) => {
            problems.say("collisions", "give one of duration [s] and collisions");
        }
        (None, None) => problems.say("", "give one of duration [s] and collisions"),
    }
}

/// More samples than this are a slip of the pen.
const MAX_SAMPLES: f64 = 1e7;

fn sample(scenario: &Scenario, problems: &mut Problems) {
    let (sample, duration) = (scenario.sample, scenario.duration.unwrap_or(0.0));
    if problems.positive("sample", sample) && duration / sample > MAX_SAMPLES {
        let least = duration / MAX_SAMPLES;
        let rest =
            format!("is {sample:?}, must be at least {least:?}: duration in {MAX_SAMPLES} parts");
        problems.add("sample", rest);
    }
}

fn sides(scenario: &Scenario, laws: &Laws, problems: &mut Problems) {
    let dimension = scenario.dimension;
    if let Some(packing) = scenario.sides.packing_fraction {
        problems.packing("box.packing_fraction", packing);
    }
    for (axis, (name, side)) in scenario.sides.named().into_iter().enumerate() {
        let path = format!("box.{name}");
        if axis >= dimension && *side != SideSpec::Open {
            problems.add(&path, format!("is given, but dimension is {dimension}"));
            continue;
        }
        match side {
            SideSpec::Periodic { from, to } | SideSpec::Walls { from, to, .. } => {
                range(&path, *from, *to, problems);
            }
            SideSpec::Plate { at, .. } => problems.finite(&format!("{path}.at"), &[*at]),
            SideSpec::Open => {}
        }
        if let Some(made) = side.surface() {
            made_of(&path, made, laws, problems);
        }
        if let Some(vibration) = side.vibration() {
            vibrates(&path, vibration, problems);
        }
        goes_on(&path, side, scenario.duration, problems);
    }
}

fn vibrates(path: &str, [amplitude, frequency, phase]: [f64; 3], problems: &mut Problems) {
    problems.finite(&format!("{path}.phase"), &[phase]);
    problems.not_negative(&format!("{path}.amplitude"), amplitude);
    if amplitude > 0.0 {
        problems.positive(&format!("{path}.frequency"), frequency);
    }
}

/// Walls that go on steadily vibrate no more, and must not meet.
fn goes_on(path: &str, side: &SideSpec, duration: Option<f64>, problems: &mut Problems) {
    let [low, high] = side.moving();
    if low == 0.0 && high == 0.0 {
        return;
    }
    let moving = format!("{path}.moving");
    problems.finite(&moving, &[low, high]);
    if side.vibration().is_some_and(|[amplitude, ..]| amplitude != 0.0) {
        problems.add(&moving, "is given, and so is amplitude: give one of them");
    }
    let SideSpec::Walls { from: Some(from), to: Some(to), .. } = side else { return };
    let meet = (to - from) / (low - high);
    if low > high && duration.is_some_and(|duration| meet <= duration) {
        let rest = format!("is [{low}, {high}]: the walls meet at t = {meet} s, before duration");
        problems.add(&moving, rest);
    }
}

fn range(path: &str, from: Option<f64>, to: Option<f64>, problems: &mut Problems) {
    match (from, to) {
        (Some(from), Some(to)) if !(from < to && (to - from).is_finite()) => {
            let message =
                format!("{path}: from is {from} and to is {to}, from must be the smaller");
            problems.say(path, message);
        }
        (Some(_), None) | (None, Some(_)) => {
            problems.say(path, format!("{path}: give both from and to [m]"));
        }
        _ => {}
    }
}

/// Force-based MD needs forces, from walls too, and one law.
fn methods(scenario: &Scenario, problems: &mut Problems) {
    let mut say = |method: MethodName, why: &str| {
        let label = method.label();
        problems.say("methods", format!("methods: {label} needs {why}; leave {label} out"));
    };
    let has_force = scenario.laws().any(|law| law.has_force());
    let has_constant = scenario.laws().any(|law| !law.has_force());
    for &method in &scenario.methods {
        let is_force_based = matches!(method, MethodName::Md | MethodName::Exact);
        if method == MethodName::EmdStar && !has_force || is_force_based && has_constant {
            say(method, "a force law, but law.kind is constant");
        }
        if is_force_based && scenario.event_driven_walls().is_some() {
            say(method, "soft walls at rest, but the box has others");
        }
        if is_force_based && !scenario.drives.is_empty() {
            say(method, "grains that nothing drives, but there is [[drive]]");
        }
        if is_force_based && scenario.has_friction() {
            say(method, "smooth grains, but there is friction");
        }
        if is_force_based && !scenario.obstacles.is_empty() {
            say(method, "a box without obstacles, but there is [[obstacle]]");
        }
        if is_force_based && scenario.sides.shear.is_some() {
            say(method, "a box that is not sheared, but there is box.shear");
        }
        if is_force_based && !has_constant && scenario.only_law().is_none() {
            say(method, "one law for all, but there are several");
        }
    }
}

fn grain(
    scenario: &Scenario,
    laws: &Laws,
    number: usize,
    grain: &GrainSpec,
    problems: &mut Problems,
) {
    let path = format!("grain.{number}");
    let below = |field: &str| format!("{path}.{field}");
    problems.positive(&below("radius"), grain.radius);
    let material = material(laws, &path, grain.material.as_ref(), problems);
    let of_material = material.and_then(|number| scenario.materials.get(number)?.density);
    match (grain.mass, grain.density.or(of_material)) {
        (Some(mass), _) if grain.density.is_none() => _ = problems.positive(&below("mass"), mass),
        (None, Some(density)) => _ = problems.positive(&below("density"), density),
        _ => problems
            .say(&path, format!("grain {number}: give one of mass [kg] and density [kg/m3]")),
    }
    problems.vector(&below("at"), &grain.at, scenario.dimension);
    if !grain.moving.is_empty() {
        problems.vector(&below("moving"), &grain.moving, scenario.dimension);
    }
}

fn gas(scenario: &Scenario, laws: &Laws, gas: &Gas, problems: &mut Problems) {
    if gas.count == 0 {
        problems.add("gas.count", "is 0, must be at least 1");
    }
    if let Some(why) = memory::refusal(gas.count, scenario.dimension) {
        problems.add("gas.count", why);
    }
    radius("gas.radius", &gas.radius, problems);
    let number = material(laws, "gas", gas.material.as_ref(), problems);
    density(scenario, "gas", gas.density, number, problems);
    problems.not_negative("gas.thermal_speed", gas.thermal_speed);
    if let Some(packing) = gas.packing_fraction {
        problems.packing("gas.packing_fraction", packing);
    }
}

/// Every two materials that can touch need a law.
fn touches(scenario: &Scenario, laws: &Laws, problems: &mut Problems) {
    let named = |name: &Option<String>| laws.number(name.as_deref()).ok();
    let mut used: Vec<usize> = scenario.grains.iter().filter_map(|g| named(&g.material)).collect();
    used.extend(scenario.gas.iter().filter_map(|gas| named(&gas.material)));
    used.extend(scenario.species.iter().filter_map(|species| named(&species.material)));
    used.sort_unstable();
    used.dedup();
    let sides = scenario.sides.named().into_iter().filter_map(|(_, side)| side.surface());
    let made = sides.chain(scenario.obstacles.iter().map(ObstacleSpec::made));
    let number = |material: Option<&String>| {
        laws.number(material.map(|name| name.as_str()).or(Some(""))).ok()
    };
    let walls: Vec<usize> = made.filter_map(|(_, _, material)| number(material)).collect();
    for (k, &a) in used.iter().enumerate() {
        let others = used[k..].iter().chain(&walls);
        for &b in others.filter(|&&b| laws.between(a, b).is_none()) {
            let [a, b] = [a, b].map(|number| laws.names[number].as_str());
            let message = match a == b {
                true if a.is_empty() => "there is no law: add [law] or a [[material]]".to_owned(),
                true => {
                    format!("material {a:?} has no law: give it law or restitution, or add [law]")
                }
                false => format!(
                    "{a:?} and {b:?} can touch, but have no law: add a [[pair]] between them, or [law]"
                ),
            };
            problems.say(if a == b { "material" } else { "pair" }, message);
        }
    }
}
