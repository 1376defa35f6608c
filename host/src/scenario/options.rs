//! How are the event-driven methods told to treat what is out of the ordinary? Reads nothing; writes nothing, names the fields and their values.

use schemars::JsonSchema;
use serde::Deserialize;

/// How the event-driven methods treat what is out of the ordinary.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Options {
    /// What to do with a collision outside the table's domain; hard-sphere if left out.
    pub outside: OutsideSpec,
    /// What becomes of contacts that last or crowd; integrated if left out.
    pub enduring: EnduringSpec,
    /// How a contact ends when a third grain interrupts it, with `enduring = "paper"`; paired if left
    /// out.
    pub release: ReleaseSpec,
    /// Where the matrix of restitution comes from; table if left out.
    pub matrix: MatrixSpec,
    /// Which table; standard if left out.
    pub table: crate::tables::Size,
    /// t_c of the TC rule (s), for hard collisions; 0, the default, is no such rule.
    pub tc: f64,
    /// Write the event-driven methods' events to a CSV file.
    pub events: bool,
    /// How long `carom compare` runs the exact MD (s); positions are compared until then.
    pub exact_until: Option<f64>,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            outside: OutsideSpec::HardSphere,
            enduring: EnduringSpec::Integrated,
            release: ReleaseSpec::Paired,
            matrix: MatrixSpec::Table,
            table: crate::tables::Size::Standard,
            tc: 0.0,
            events: false,
            exact_until: None,
        }
    }
}

/// See [`carom::law::Outside`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum OutsideSpec {
    /// Stop with an error.
    Reject,
    /// Use the nearest collision inside.
    Clamp,
    /// Use the hard-sphere rule.
    HardSphere,
}

/// See [`carom::Enduring`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum EnduringSpec {
    /// As in the papers.
    Paper,
    /// Integrated.
    Integrated,
}

/// See [`carom::Release`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ReleaseSpec {
    /// Both at once.
    Paired,
    /// Each for itself.
    Independent,
}

/// Where the matrix of restitution comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum MatrixSpec {
    /// An embedded table.
    Table,
    /// The contact equation, integrated for each collision.
    Integrate,
}
