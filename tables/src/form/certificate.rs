//! What does a table promise? Reads nothing; writes nothing, holds what its generator measured.

use super::{Domain, End, Law, Scaled};

/// What a table promises, measured by its generator through the same [`Table::read`](super::Table::read).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Certificate {
    /// The force law.
    pub law: Law,
    /// The end of the contact.
    pub end: End,
    /// Where the table answers.
    pub domain: Domain,
    /// Bytes of coefficients, rows, leaves and branches.
    pub bytes: usize,
    /// Coefficients that one reading touches at most.
    pub terms: usize,
    /// Largest error: `tau` relative (of a quantised table: to T at least), the others absolute, `angle` in radians.
    /// The largest that was found, times `margin`: in single and in double precision, or in the
    /// fixed-point number for which it is meant.
    pub largest: Scaled<f64>,
    /// Largest error at typical collisions, times `margin`: those drawn log-uniformly from MP13's
    /// Tables I and II for a wide table, else those uniform in the domain.
    pub typical: Scaled<f64>,
    /// The error that 99.9 % of the typical collisions stay below, as measured.
    pub usual: Scaled<f64>,
    /// Number of points at which it was measured; the fit saw none of them.
    pub points: usize,
    /// The factor between what was measured and what `largest` promises.
    pub margin: f64,
    /// FNV-1a (64 bit) of layout and coefficients.
    pub digest: u64,
    /// Where the equations come from.
    pub citation: &'static str,
}
