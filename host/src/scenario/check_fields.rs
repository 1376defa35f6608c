//! Are density, material and radius right, wherever they stand? Reads them; writes a list of what is wrong.

use super::grains::RadiusSpec;
use super::laws::Laws;
use super::problem::Problems;
use super::sides::{MadeSpec, SurfaceSpec};
use super::spec::Scenario;

/// The number of a material that is named somewhere, if there is one.
pub fn material(
    laws: &Laws,
    path: &str,
    name: Option<&String>,
    problems: &mut Problems,
) -> Option<usize> {
    let found = laws.number(name.map(String::as_str));
    found.map_err(|rest| problems.add(format!("{path}.material"), rest)).ok()
}

/// Whether there is a density, and a right one.
pub fn density(
    scenario: &Scenario,
    path: &str,
    own: Option<f64>,
    material: Option<usize>,
    problems: &mut Problems,
) {
    let of_material = material.and_then(|number| scenario.materials.get(number)?.density);
    match (own, of_material, material) {
        (Some(density), ..) => _ = problems.positive(&format!("{path}.density"), density),
        (None, None, Some(_)) => {
            problems.add(format!("{path}.density"), "is missing, and its material has none");
        }
        _ => {}
    }
}

/// Whether all radii that can come of it are right.
pub fn radius(path: &str, radius: &RadiusSpec, problems: &mut Problems) {
    match radius {
        RadiusSpec::One(radius) => _ = problems.positive(path, *radius),
        RadiusSpec::Range([small, large]) | RadiusSpec::Uniform { uniform: [small, large] } => {
            if problems.positive(path, *small) && !(large.is_finite() && large >= small) {
                let rest =
                    format!("is [{small}, {large}], must be the smallest and then the largest");
                problems.add(path, rest);
            }
        }
        RadiusSpec::Gaussian { mean, deviation } => {
            let third = format!("at least 0 and less than a third of mean, {mean}");
            let is_right = *deviation >= 0.0 && 3.0 * deviation < *mean;
            if problems.positive(&format!("{path}.mean"), *mean) {
                problems.must(&format!("{path}.deviation"), *deviation, is_right, &third);
            }
        }
        RadiusSpec::List { list } if list.is_empty() => {
            problems.add(format!("{path}.list"), "is empty, must have at least one radius");
        }
        RadiusSpec::List { list } => {
            for (k, radius) in list.iter().enumerate() {
                problems.positive(&format!("{path}.list.{k}"), *radius);
            }
        }
    }
}

/// Whether walls or obstacles are made of something, and of one thing only.
pub fn made_of(
    path: &str,
    (surface, e, named): MadeSpec<'_>,
    laws: &Laws,
    problems: &mut Problems,
) {
    let restitution = format!("{path}.restitution");
    if named.is_some() {
        material(laws, path, named, problems);
        if surface.is_some() || e.is_some() {
            let rest =
                "is given, and so is surface or restitution: the material says what walls do";
            problems.add(format!("{path}.material"), rest);
        }
        return;
    }
    match (surface, e) {
        (_, Some(e)) if surface != Some(SurfaceSpec::Soft) => {
            problems.fraction(&restitution, e);
        }
        (Some(SurfaceSpec::Hard), None) => {
            problems.say(&restitution, format!("{restitution}: hard walls need one"));
        }
        (_, Some(_)) => {
            let message = format!("{restitution}: soft walls follow the law and have none");
            problems.say(&restitution, message);
        }
        (_, None) => {}
    }
}
