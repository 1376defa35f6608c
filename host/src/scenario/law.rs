//! Which laws can a scenario name, for materials and for pairs of them? Reads nothing; writes nothing, names the fields and their values.

use super::friction::FrictionSpec;
use schemars::JsonSchema;
use serde::Deserialize;

/// A contact law.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "lowercase", deny_unknown_fields)]
pub enum LawSpec {
    /// Linear spring-dashpot, MP13 Eq. (40).
    Lsd {
        /// k (N/m).
        stiffness: f64,
        /// γ (kg/s).
        damping: f64,
    },
    /// Viscoelastic spheres, MP13 Eq. (51).
    Viscoelastic {
        /// Y (Pa).
        young: f64,
        /// ν.
        poisson: f64,
        /// A (s).
        dissipation: f64,
    },
    /// Any powers, F = K x^(1 + β) + D m x^γ ẋ until the overlap x is none, so that the dashpot may pull at the end
    /// (L94, Eqs. 2 to 8); m is twice the reduced mass of two grains, and a grain's own at a wall.
    L94 {
        /// K (N/m^(1 + β)).
        stiffness: f64,
        /// β; 0, the default, is a linear spring, 1/2 a sphere.
        #[serde(default)]
        beta: f64,
        /// D (1/(s m^γ)).
        damping: f64,
        /// γ; 0, the default, is a linear dashpot.
        #[serde(default)]
        gamma: f64,
    },
    /// Hard spheres with a constant coefficient of restitution: event-driven only.
    Constant {
        /// ε.
        restitution: f64,
    },
}

impl LawSpec {
    /// Whether there is a force, and so a contact that lasts.
    pub const fn has_force(&self) -> bool {
        !matches!(self, Self::Constant { .. })
    }
}

/// What grains and walls are made of.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MaterialSpec {
    /// By which species, grains, walls and pairs call it.
    pub name: String,
    /// Density of a sphere (kg/m³); may be left out if whoever is made of it says density or mass.
    pub density: Option<f64>,
    /// What two of this material do when they touch.
    pub law: Option<LawSpec>,
    /// The same as `law = { kind = "constant", restitution = … }`.
    pub restitution: Option<f64>,
    /// What two surfaces of this material do across the line of centres.
    pub friction: Option<FrictionSpec>,
}

/// What two materials do when they touch each other.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PairLawSpec {
    /// The names of the two; their order does not matter.
    pub between: [String; 2],
    /// The law of their contacts.
    pub law: Option<LawSpec>,
    /// The same as `law = { kind = "constant", restitution = … }`.
    pub restitution: Option<f64>,
    /// What their surfaces do across the line of centres.
    pub friction: Option<FrictionSpec>,
}
