//! Are materials and their laws right? Reads them; writes a list of what is wrong.

use super::law::LawSpec;
use super::laws::Laws;
use super::problem::Problems;
use super::spec::Scenario;

fn law(path: &str, law: &LawSpec, problems: &mut Problems) {
    let below = |field: &str| format!("{path}.{field}");
    match *law {
        LawSpec::Lsd { stiffness, damping } => {
            problems.positive(&below("stiffness"), stiffness);
            problems.not_negative(&below("damping"), damping);
        }
        LawSpec::Viscoelastic { young, poisson, dissipation } => {
            problems.positive(&below("young"), young);
            let is_right = poisson > -1.0 && poisson <= 0.5;
            problems.must(&below("poisson"), poisson, is_right, "above -1 and at most 0.5");
            problems.not_negative(&below("dissipation"), dissipation);
        }
        LawSpec::L94 { stiffness, beta, damping, gamma } => {
            problems.positive(&below("stiffness"), stiffness);
            problems.must(&below("beta"), beta, (0.0..=15.0).contains(&beta), "from 0 to 15");
            problems.not_negative(&below("damping"), damping);
            let is_right = (0.0..=1.0 + beta).contains(&gamma);
            problems.must(&below("gamma"), gamma, is_right, "from 0 to 1 + beta");
        }
        LawSpec::Constant { restitution } => {
            problems.fraction(&below("restitution"), restitution);
        }
    }
}

/// A law or its short form.
fn one_law(path: &str, given: (Option<&LawSpec>, Option<f64>), problems: &mut Problems) {
    match given {
        (Some(_), Some(_)) => {
            problems
                .add(format!("{path}.restitution"), "is given, and so is law: give one of them");
        }
        (Some(one), None) => law(&format!("{path}.law"), one, problems),
        (None, Some(e)) => _ = problems.fraction(&format!("{path}.restitution"), e),
        (None, None) => {}
    }
}

/// The number of different materials that the engine can tell apart.
const MAX_MATERIALS: usize = 256;

/// What is wrong with them; the laws of all pairs.
pub fn materials(scenario: &Scenario, problems: &mut Problems) -> Laws {
    if let Some(one) = &scenario.law {
        law("law", one, problems);
    }
    let count = scenario.materials.len();
    if count > MAX_MATERIALS {
        problems.say("material", format!("there are {count} materials, {MAX_MATERIALS} at most"));
    }
    for (k, material) in scenario.materials.iter().enumerate() {
        let path = format!("material.{k}");
        if let Some(density) = material.density {
            problems.positive(&format!("{path}.density"), density);
        }
        if scenario.materials[..k].iter().any(|other| other.name == material.name) {
            let rest = format!("is {:?}, which another material is called too", material.name);
            problems.add(format!("{path}.name"), rest);
        }
        one_law(&path, (material.law.as_ref(), material.restitution), problems);
    }
    let laws = Laws::new(scenario);
    for (k, pair) in scenario.pairs.iter().enumerate() {
        let path = format!("pair.{k}");
        for name in &pair.between {
            if let Err(rest) = laws.number(Some(name)) {
                problems.add(format!("{path}.between"), rest);
            }
        }
        one_law(&path, (pair.law.as_ref(), pair.restitution), problems);
        if pair.law.is_none() && pair.restitution.is_none() {
            problems.say(&path, format!("pair {k}: give one of law and restitution"));
        }
    }
    laws
}
