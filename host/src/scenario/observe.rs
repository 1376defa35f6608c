//! What can a scenario ask to be measured? Reads nothing; writes nothing, names the fields and their values.

use anyhow::{Result, bail};
use schemars::JsonSchema;
use serde::Deserialize;

/// What is measured while a method runs: the table `[observe]` of a scenario.
///
/// Means, energies and rates, forces on walls and obstacles, and the torque on what turns, are measured wherever the table
/// stands, empty or not. All units are SI.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ObserveSpec {
    /// When measuring begins (s); at once if left out.
    #[serde(default)]
    pub from: f64,
    /// Time between two looks at the state (s); that between two samples if left out. Collisions are all seen.
    pub every: Option<f64>,
    /// Density, velocity and temperature along an axis.
    pub profile: Option<ProfileSpec>,
    /// The pair distribution function g(r).
    pub pair_distribution: Option<PairSpec>,
    /// Mean square displacement and velocity autocorrelation.
    pub correlations: Option<CorrelationSpec>,
    /// The surface of a layer, and the waves on it.
    pub surface: Option<ModesSpec>,
}

/// Density, velocity and temperature along an axis.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ProfileSpec {
    /// Along which axis.
    pub axis: Axis,
    /// Where it begins (m); where the box does if left out.
    pub from: Option<f64>,
    /// Where it ends (m); where the box does if left out.
    pub to: Option<f64>,
    /// Equal parts.
    #[serde(default = "fifty")]
    pub bins: u32,
}

/// An axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Axis {
    /// The first.
    X,
    /// The second.
    Y,
    /// The third.
    Z,
}

impl Axis {
    /// Its number, from 0.
    pub const fn number(self) -> usize {
        self as usize
    }

    /// Its name.
    pub const fn name(self) -> &'static str {
        ["x", "y", "z"][self as usize]
    }
}

/// The pair distribution function g(r).
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PairSpec {
    /// The largest distance of two centres (m); three of the largest diameters if left out.
    pub to: Option<f64>,
    /// Equal parts.
    #[serde(default = "hundred")]
    pub bins: u32,
    /// One look in so many: pairs cost more than all else.
    #[serde(default = "ten")]
    pub one_in: u32,
}

/// Mean square displacement and velocity autocorrelation.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CorrelationSpec {
    /// The longest time apart (s).
    pub to: f64,
    /// How many times apart, as nearly as looks allow.
    #[serde(default = "fifty")]
    pub points: u32,
    /// So many grains at most are followed.
    #[serde(default = "two_thousand")]
    pub grains: u32,
}

/// The surface of a layer and its Fourier modes, as waves along the axes across.
///
/// An amplitude is the root mean square over time, of A in A cos(k x + φ): half of the height from trough to crest. No
/// mode is shorter than four places. Where the plate vibrates and looks come a whole number of times in a cycle, what
/// changes sign from each cycle to the next is told apart: waves of half of the plate's frequency.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ModesSpec {
    /// Which axis leads up; the plate's if left out, or else that of gravity.
    pub up: Option<Axis>,
    /// How wide a place is at which the height is taken (m); such that it has 20 grains in the mean if left out.
    pub place: Option<f64>,
    /// Which height of the centres in a place; top if left out.
    #[serde(default)]
    pub height: HeightSpec,
}

/// Which height of a layer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum HeightSpec {
    /// 2 q₃ − q₂ of the third quartile and the median: the top of centres that fill the layer evenly, whatever has been thrown
    /// above it.
    #[default]
    Top,
    /// The mean of the centres.
    Mean,
}

const fn ten() -> u32 {
    10
}

const fn fifty() -> u32 {
    50
}

const fn hundred() -> u32 {
    100
}

const fn two_thousand() -> u32 {
    2_000
}

/// More parts than this are a slip of the pen.
const MAX_BINS: u32 = 100_000;

fn parts(name: &str, count: u32) -> Result<()> {
    match count {
        1..=MAX_BINS => Ok(()),
        _ => bail!("observe.{name} is {count}, must be from 1 to {MAX_BINS}"),
    }
}

/// More looks than this are a slip of the pen.
const MAX_LOOKS: f64 = 1e8;

impl ObserveSpec {
    /// Whether this can be measured in such a run.
    ///
    /// # Errors
    /// The field that is wrong.
    pub fn check(&self, sample: f64, duration: Option<f64>) -> Result<()> {
        let Self { from, every, .. } = self;
        if !(from.is_finite() && *from >= 0.0) {
            bail!("observe.from is {from}, must be at least 0");
        }
        if duration.is_some_and(|duration| *from >= duration) {
            bail!("observe.from is {from}, must be less than duration");
        }
        let every = every.unwrap_or(sample);
        if !(every.is_finite() && every > 0.0) {
            bail!("observe.every is {every}, must be above 0");
        }
        if duration.is_some_and(|duration| every > duration - from) {
            bail!("observe.every is {every}, must be at most duration - from");
        }
        if duration.is_some_and(|duration| duration / every > MAX_LOOKS) {
            bail!("observe.every is {every:?}: more than {MAX_LOOKS} looks in duration");
        }
        self.check_parts(every)
    }

    fn check_parts(&self, every: f64) -> Result<()> {
        if let Some(profile) = &self.profile {
            parts("profile.bins", profile.bins)?;
        }
        if let Some(pairs) = &self.pair_distribution {
            parts("pair_distribution.bins", pairs.bins)?;
            parts("pair_distribution.one_in", pairs.one_in)?;
        }
        if let Some(CorrelationSpec { to, points, grains }) = self.correlations {
            parts("correlations.points", points)?;
            if grains == 0 {
                bail!("observe.correlations.grains is 0, must be at least 1");
            }
            if !(to.is_finite() && to >= every) {
                bail!("observe.correlations.to is {to}, must be at least observe.every, {every}");
            }
        }
        Ok(())
    }
}
