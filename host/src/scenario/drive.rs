//! What can drive a scenario? Reads nothing; writes nothing, names the fields and their values.

use super::observe::Axis;
use schemars::JsonSchema;
use serde::Deserialize;

/// What gives grains energy, or changes them while they run. Event-driven methods only.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum DriveSpec {
    /// A hard wall or plate from which grains come as from a gas behind it: along the normal from Maxwell's flux, across it
    /// from his distribution.
    ThermalWall {
        /// Across which axis.
        axis: Axis,
        /// Which of two walls; a plate is the lower one.
        #[serde(default)]
        side: EndName,
        /// k T (J).
        temperature: f64,
    },
    /// Andersen's thermostat: grains get new velocities from Maxwell's distribution.
    Andersen {
        /// k T (J).
        temperature: f64,
        /// How often a grain gets one (1/s).
        rate: f64,
    },
    /// White noise: every velocity gets a random kick, all together no momentum.
    WhiteNoise {
        /// ξ², by which the variance of a component grows (m²/s³).
        strength: f64,
        /// Time between two kicks (s); short against the mean free time.
        interval: f64,
    },
    /// Gravity in steps.
    GravityTable {
        /// Rows of a time (s) and a number for each axis (m/s²): gravity from that time on.
        rows: Vec<Vec<f64>>,
    },
    /// Gravity that turns in the plane of two axes, from the first to the second.
    TurningGravity {
        /// g (m/s²).
        magnitude: f64,
        /// In which plane.
        axes: [Axis; 2],
        /// How long a turn takes (s).
        period: f64,
        /// In how many steps.
        #[serde(default = "steps")]
        steps: u32,
    },
    /// A grain gets a kick.
    Kick {
        /// When (s).
        time: f64,
        /// Which: they are counted from 0, in the order of the file.
        grain: usize,
        /// What is added to its velocity (m/s).
        by: Vec<f64>,
    },
    /// A grain gets a velocity.
    SetVelocity {
        /// When (s).
        time: f64,
        /// Which: they are counted from 0, in the order of the file.
        grain: usize,
        /// The velocity (m/s).
        to: Vec<f64>,
    },
    /// A grain is taken out. The others keep their numbers.
    Remove {
        /// When (s).
        time: f64,
        /// Which: they are counted from 0, in the order of the file.
        grain: usize,
    },
}

const fn steps() -> u32 {
    360
}

/// An end of an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum EndName {
    /// The lower one.
    #[default]
    Low,
    /// The upper one.
    High,
}
