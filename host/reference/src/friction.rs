//! What do surfaces do to each other across the line of centres? Reads nothing; writes nothing, names the constants.

use crate::error::{ReferenceError, positive, zero_or_more};

/// A linear spring across the line of centres, its force held to μ times the normal force (Cundall & Strack,
/// Géotechnique 29, 47, 1979); the spring is cut where it is held. Both grains have I = q m R².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Friction {
    /// μ ≥ 0.
    pub mu: f64,
    /// k_t > 0 (N/m).
    pub stiffness: f64,
    /// γ_t ≥ 0 (kg/s): a dashpot beside the spring, both together held to μ times the normal force.
    pub damping: f64,
    /// q, 2/5 for spheres.
    pub inertia: f64,
}

impl Friction {
    pub(crate) fn validate(&self) -> Result<(), ReferenceError> {
        zero_or_more("mu", self.mu)?;
        positive("tangential stiffness", self.stiffness)?;
        zero_or_more("tangential damping", self.damping)?;
        positive("inertia", self.inertia)
    }
}
