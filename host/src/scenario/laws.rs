//! Which law holds between two materials? Reads materials, pairs and the law for all others; writes nothing.

use super::law::LawSpec;
use super::shape::{any_of, near};
use super::spec::Scenario;

/// The law of every pair of materials.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Laws {
    /// The materials' names; one without a name if the scenario has none.
    pub names: Vec<String>,
    between: Vec<Option<LawSpec>>,
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
        let mut between = vec![scenario.law; count * count];
        for (a, law) in own.iter().enumerate() {
            for (b, other) in own.iter().enumerate().filter(|(_, other)| *other == law) {
                between[a * count + b] = other.or(scenario.law);
            }
        }
        for pair in &scenario.pairs {
            let found = pair.between.each_ref().map(|name| names.iter().position(|n| n == name));
            if let [Some(a), Some(b)] = found {
                let law = of(pair.law, pair.restitution);
                (between[a * count + b], between[b * count + a]) = (law, law);
            }
        }
        Self { names, between }
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
