//! Are rough surfaces and rotations right? Reads a scenario; writes a list of what is wrong.

use super::friction::{FrictionSpec, SPHERE};
use super::problem::Problems;
use super::spec::Scenario;

/// What is wrong with friction and rotation.
pub fn check(scenario: &Scenario, problems: &mut Problems) {
    let of_materials = scenario.materials.iter().map(|m| m.friction).enumerate();
    let of_pairs = scenario.pairs.iter().map(|p| p.friction).enumerate();
    let named = [("friction".to_owned(), scenario.friction)]
        .into_iter()
        .chain(of_materials.map(|(k, one)| (format!("material.{k}.friction"), one)))
        .chain(of_pairs.map(|(k, one)| (format!("pair.{k}.friction"), one)));
    let mut is_rough = false;
    for (path, spec) in named {
        if let Some(spec) = spec {
            is_rough = true;
            one(&path, &spec, problems);
        }
    }
    let q = scenario.inertia.unwrap_or(SPHERE);
    problems.must("inertia", q, q > 0.0 && q <= 1.0, "above 0 and at most 1");
    if is_rough && scenario.dimension == 1 {
        problems.say("friction", "friction: nothing rotates in one dimension; leave it out");
    }
    let spins = scenario.grains.iter().position(|grain| !grain.rotating.is_empty());
    if let (false, Some(k)) = (is_rough, spins) {
        problems.add(format!("grain.{k}.rotating"), "is given, but nothing has friction");
    }
    let axes = if scenario.dimension == 3 { 3 } else { 1 };
    for (k, grain) in scenario.grains.iter().enumerate().filter(|(_, g)| !g.rotating.is_empty()) {
        problems.vector(&format!("grain.{k}.rotating"), &grain.rotating, axes);
    }
}

fn one(path: &str, spec: &FrictionSpec, problems: &mut Problems) {
    let below = |field: &str| format!("{path}.{field}");
    let mut friction = |mu: f64| {
        problems.must(&below("mu"), mu, (0.0..=16.0).contains(&mu), "between 0 and 16");
    };
    let within = |x: f64| (-1.0..=1.0).contains(&x);
    match *spec {
        FrictionSpec::Constant { beta } => {
            problems.must(&below("beta"), beta, within(beta), "between -1 and 1");
        }
        FrictionSpec::Walton { mu, beta_0 } => {
            friction(mu);
            problems.must(&below("beta_0"), beta_0, within(beta_0), "between -1 and 1");
        }
        FrictionSpec::Spring { mu, stiffness, damping } => {
            friction(mu);
            problems.positive(&below("stiffness"), stiffness);
            problems.not_negative(&below("damping"), damping);
        }
    }
}
