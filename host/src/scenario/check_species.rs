//! Can these species be placed? Reads species; writes a list of what is wrong.

use super::check_fields::{density, material, radius};
use super::grains::{PlaceSpec, SpeciesSpec};
use super::laws::Laws;
use super::memory;
use super::problem::Problems;
use super::spec::Scenario;

/// What is wrong with the species of a scenario.
pub fn check(scenario: &Scenario, laws: &Laws, problems: &mut Problems) {
    for (number, species) in scenario.species.iter().enumerate() {
        one(scenario, laws, number, species, problems);
    }
}

fn one(
    scenario: &Scenario,
    laws: &Laws,
    number: usize,
    species: &SpeciesSpec,
    problems: &mut Problems,
) {
    let path = format!("species.{number}");
    let below = |field: &str| format!("{path}.{field}");
    count(scenario, &path, species, problems);
    match &species.radius {
        Some(radii) => radius(&below("radius"), radii, problems),
        None if matches!(species.place, PlaceSpec::File { .. }) => {}
        None => problems.add(below("radius"), "is missing"),
    }
    let made_of = material(laws, &path, species.material.as_ref(), problems);
    // A file may say masses.
    if species.density.is_some() || !matches!(species.place, PlaceSpec::File { .. }) {
        density(scenario, &path, species.density, made_of, problems);
    }
    let name = species.name.as_deref();
    let twice = |other: &SpeciesSpec| name.is_some() && other.name.as_deref() == name;
    if scenario.species[..number].iter().any(twice) {
        problems.add(below("name"), "is that of another species too");
    }
    match (species.temperature, species.thermal_speed) {
        (Some(_), Some(_)) => {
            problems
                .add(below("thermal_speed"), "is given, and so is temperature: give one of them");
        }
        (Some(temperature), None) => {
            problems.not_negative(&below("temperature"), temperature);
        }
        (None, Some(speed)) => _ = problems.not_negative(&below("thermal_speed"), speed),
        (None, None) => {}
    }
    if !species.moving.is_empty() {
        problems.vector(&below("moving"), &species.moving, scenario.dimension);
    }
    place(scenario, &below("place"), &species.place, problems);
}

fn count(scenario: &Scenario, path: &str, species: &SpeciesSpec, problems: &mut Problems) {
    let below = |field: &str| format!("{path}.{field}");
    if matches!(species.place, PlaceSpec::File { .. }) {
        for (field, is_given) in [
            ("count", species.count.is_some()),
            ("packing_fraction", species.packing_fraction.is_some()),
        ] {
            if is_given {
                problems.add(below(field), "is given, but the file says how many there are");
            }
        }
        return;
    }
    match (species.count, species.packing_fraction) {
        (Some(0), _) => problems.add(below("count"), "is 0, must be at least 1"),
        (Some(_), Some(_)) => problems.add(
            below("packing_fraction"),
            "is given, and so is count: give one of them (box.packing_fraction sets the size of the box)",
        ),
        (Some(count), None) => {
            if let Some(why) = memory::refusal(count, scenario.dimension) {
                problems.add(below("count"), why);
            }
        }
        (None, Some(packing)) => _ = problems.packing(&below("packing_fraction"), packing),
        (None, None) => problems.add(below("count"), "is missing, or packing_fraction in its place"),
    }
}

fn place(scenario: &Scenario, path: &str, place: &PlaceSpec, problems: &mut Problems) {
    let [from, to] = place.corners();
    for (field, corner) in [("from", from), ("to", to)] {
        if let Some(corner) = corner {
            problems.vector(&format!("{path}.{field}"), corner, scenario.dimension);
        }
    }
    if let (Some(from), Some(to)) = (from, to)
        && from.iter().zip(to).any(|(from, to)| from >= to)
    {
        problems.add(path, "has a from that is not below its to");
    }
    match place {
        PlaceSpec::Layer { gap: Some(gap), .. } => {
            problems.not_negative(&format!("{path}.gap"), *gap);
        }
        PlaceSpec::Pile { at: Some(at) } => {
            problems.vector(&format!("{path}.at"), at, scenario.dimension);
        }
        _ => {}
    }
}
