//! What did a run come to? Reads its last sample; writes nothing, is written as JSON.

use crate::run::Sample;
use crate::scenario::MethodName;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// What a run came to.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Summary {
    /// The scenario's title.
    pub title: String,
    /// How many grains.
    pub grains: usize,
    /// The program's version and a checksum of scenario, methods and start.
    pub known_by: String,
    /// What each method came to.
    pub runs: Vec<MethodSummary>,
    /// Why the run ended before its time, if it did: the last method's files end there.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub broken_off: Option<String>,
}

/// What one method came to.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct MethodSummary {
    /// The method.
    pub method: MethodName,
    /// The last sample's time (s).
    pub time: f64,
    /// Contacts until then.
    pub collisions: u64,
    /// Kinetic energy (J).
    pub kinetic_energy: f64,
    /// Seconds of computing.
    pub wall_seconds: f64,
    /// How often everything happened.
    pub statistics: Vec<(String, u64)>,
    /// How many grains move in which way.
    pub motions: Vec<(String, usize)>,
    /// A digest of the whole state at the end in hexadecimal digits: the same on every machine. None for MD, and
    /// for a run that broke off.
    #[serde(default)]
    pub digest: Option<String>,
    /// The files.
    pub files: Vec<PathBuf>,
}

impl MethodSummary {
    /// What stands in a sample.
    pub(super) fn new(method: MethodName, sample: &Sample) -> Self {
        let owned = |name: &str| name.to_owned();
        Self {
            method,
            time: sample.time,
            collisions: sample.collisions,
            kinetic_energy: sample.kinetic_energy,
            wall_seconds: 0.0,
            statistics: sample.statistics.iter().map(|(name, n)| (owned(name), *n)).collect(),
            motions: sample.motions.iter().map(|(name, n)| (owned(name), *n)).collect(),
            digest: None,
            files: Vec::new(),
        }
    }
}
