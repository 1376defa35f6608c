//! Which law holds between two materials? Reads materials, pairs and the law for all others; writes nothing.

use super::friction::FrictionSpec;
use super::law::LawSpec;
use super::shape::{any_of, near};
use super::spec::Scenario;

/// The law of every pair of materials.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Laws {
    /// The materials' names; one without a name if the scenario has none.
    pub names: Vec<String>,
    between: Vec<Option<LawSpec>>,
    friction: Vec<Option<FrictionSpec>>,
}

/// A law, or its short form.
pub fn of(law: Option<LawSpec>, restitution: Option<f64>) -> Option<LawSpec> {
    law.or(restitution.map(|restitution| LawSpec::Constant { restitution }))
}

impl Laws {
    /// The laws of a scenario. Two materials have that of their `[[pair]]`, or their own if it is the
    /// same one, or that of `[law]`.
    pub fn new(scenario: &Scenario) -> Self {
        let mut names: Vec<String> =
            scenario.materials.iter().map(|material| material.name.clone()).collect();
        let mut own: Vec<Option<LawSpec>> =
            scenario.materials.iter().map(|m| of(m.law, m.restitution)).collect();
        if names.is_empty() {
            (names, own) = (vec![String::new()], vec![None]);
        }
        let count = names.len();
        let mut rough: Vec<_> = scenario.materials.iter().map(|m| m.friction).collect();
        rough.resize(count, None);
        let mut between = of_pairs(&own, scenario.law);
        let mut friction = of_pairs(&rough, scenario.friction);
        for pair in &scenario.pairs {
            let found = pair.between.each_ref().map(|name| names.iter().position(|n| n == name));
            if let [Some(a), Some(b)] = found {
                let law = of(pair.law, pair.restitution);
                (between[a * count + b], between[b * count + a]) = (law, law);
                let surfaces = pair.friction.or(friction[a * count + b]);
                (friction[a * count + b], friction[b * count + a]) = (surfaces, surfaces);
            }
        }
        Self { names, between, friction }
    }

    /// Whether there are laws whose contacts are integrated from the touch on, step by step.
    pub fn are_integrated(&self) -> bool {
        self.pairs().flatten().any(|law| matches!(law, LawSpec::L94 { .. }))
    }

    /// How many materials there are.
    pub fn count(&self) -> usize {
        self.names.len()
    }

    /// The law between two materials, if the scenario says one.
    pub fn between(&self, a: usize, b: usize) -> Option<LawSpec> {
        self.between.get(a * self.count() + b).copied().flatten()
    }

    /// The laws of all pairs, row by row.
    pub fn pairs(&self) -> impl Iterator<Item = Option<LawSpec>> {
        self.between.iter().copied()
    }

    /// What the surfaces of all pairs do, row by row; none of all if all are smooth.
    pub fn frictions(&self) -> impl Iterator<Item = Option<FrictionSpec>> {
        self.friction.iter().copied()
    }

    /// Whether any two surfaces have friction.
    pub fn has_friction(&self) -> bool {
        self.frictions().flatten().next().is_some()
    }

    /// The number of a material.
    ///
    /// # Errors
    /// What would be right, if there is no such material, or none is named where there are several.
    pub fn number(&self, name: Option<&str>) -> Result<usize, String> {
        let names: Vec<&str> = self.names.iter().map(String::as_str).collect();
        match name {
            None if names.len() == 1 => Ok(0),
            None => Err(format!("is missing, must be {}", any_of(&names))),
            Some(name) => names.iter().position(|one| *one == name).ok_or_else(|| {
                let defined = if names == [""] {
                    "there is no [[material]]".to_owned()
                } else {
                    near(name, &names)
                };
                format!("is {name:?}, which no [[material]] defines; {defined}")
            }),
        }
    }
}

/// What holds between two materials, row by row: their own if it is the same, or that of all others.
fn of_pairs<T: Copy + PartialEq>(own: &[Option<T>], of_all: Option<T>) -> Vec<Option<T>> {
    let pairs = own.iter().flat_map(|a| own.iter().map(move |b| (a, b)));
    pairs.map(|(a, b)| if a == b { a.or(of_all) } else { of_all }).collect()
}
