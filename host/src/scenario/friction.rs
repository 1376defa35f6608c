//! What can a scenario say of rough surfaces? Reads nothing; writes nothing, names the fields and their values.

use carom::law::Tangential;
use schemars::JsonSchema;
use serde::Deserialize;

/// What two surfaces do across the line of centres. Grains rotate as soon as one pair has it.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "lowercase", deny_unknown_fields)]
pub enum FrictionSpec {
    /// A constant coefficient of tangential restitution.
    Constant {
        /// β, from −1 (smooth) to 1 (perfectly rough).
        beta: f64,
    },
    /// Walton's rule: surfaces slide, or stick and part with −β₀ (Foerster, Louge, Chang & Allia, Phys. Fluids 6,
    /// 1108 (1994)).
    Walton {
        /// μ, Coulomb's coefficient of friction.
        mu: f64,
        /// β₀, from −1 to 1; 0 if left out.
        #[serde(default)]
        beta_0: f64,
    },
    /// A linear spring for as long as the contact lasts, held to μ times the normal force (Cundall & Strack,
    /// Géotechnique 29, 47 (1979)). For laws with forces.
    Spring {
        /// μ, Coulomb's coefficient of friction.
        mu: f64,
        /// k_t (N/m).
        stiffness: f64,
        /// γ_t (kg/s); 0 if left out.
        #[serde(default)]
        damping: f64,
    },
}

impl From<FrictionSpec> for Tangential<f64> {
    fn from(spec: FrictionSpec) -> Self {
        match spec {
            FrictionSpec::Constant { beta } => Self::Constant { beta },
            FrictionSpec::Walton { mu, beta_0 } => Self::Walton { mu, beta_0 },
            FrictionSpec::Spring { mu, stiffness, damping } => {
                Self::Spring { mu, stiffness, damping }
            }
        }
    }
}

/// I/(m R²) of a sphere.
pub const SPHERE: f64 = 0.4;
