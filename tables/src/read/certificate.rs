//! What does a table promise? Reads nothing; writes nothing, holds what its generator measured.

use super::domain::Domain;
use super::groups::ScaledRestitution;
use super::law::{End, Law};

/// What a table promises, measured by its generator through the same [`Table::read`](super::Table::read).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Certificate {
    /// The force law.
    pub law: Law,
    /// The end of the contact.
    pub end: End,
    /// Where the table answers.
    pub domain: Domain,
    /// Size in bytes of coefficients, rows, leaves and branches.
    pub bytes: usize,
    /// Largest number of coefficients that one reading uses.
    pub terms: usize,
    /// Largest error that was found, times `margin`.
    ///
    /// `tau` is relative (in a quantised table to `T` where `tau` is shorter than that), the others
    /// are absolute, `angle` is in radians. Measured in single and in double precision, or in the
    /// fixed-point number for which the table is meant.
    pub largest: ScaledRestitution<f64>,
    /// Largest error at typical collisions, times `margin`.
    ///
    /// Typical are, for a wide table, collisions drawn log-uniformly from MP13's Table I or II, else
    /// those distributed uniformly over the domain.
    pub typical: ScaledRestitution<f64>,
    /// The error that 99.9 % of the typical collisions stay below, as measured.
    pub quantile_999: ScaledRestitution<f64>,
    /// Number of collisions at which the errors were measured; the fit used none of them.
    pub points: usize,
    /// The factor between the errors that were measured and `largest` and `typical`.
    pub margin: f64,
    /// FNV-1a hash (64 bit) of layout and coefficients; the same on every machine.
    pub digest: u64,
    /// Where the equations come from.
    pub citation: &'static str,
}
