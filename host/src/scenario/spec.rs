//! What can a scenario file say? Reads nothing; writes nothing, names the fields and their values.

use super::drive::DriveSpec;
use super::friction::FrictionSpec;
use super::grains::{Gas, GrainSpec, SpeciesSpec};
use super::law::{LawSpec, MaterialSpec, PairLawSpec};
use super::obstacle::ObstacleSpec;
use super::options::Options;
use super::sides::{SideSpec, Sides, SurfaceSpec};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// A scenario as its file says it. See `scenarios/` for three that are explained.
///
/// # Units
/// SI throughout.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Scenario {
    /// One line for tables and pictures.
    #[serde(default)]
    pub title: String,
    /// 1, 2 or 3.
    pub dimension: usize,
    /// Uniform gravity, a number for each axis (m/s²); none if left out.
    #[serde(default)]
    pub gravity: Vec<f64>,
    /// How long to run (s).
    pub duration: Option<f64>,
    /// Or: until so many collisions between grains have been seen at a sample.
    pub collisions: Option<u64>,
    /// Time between two samples (s).
    pub sample: f64,
    /// Which methods `carom run` runs; md, emd and emd* if left out, as far as the laws and walls allow.
    #[serde(default)]
    pub methods: Vec<MethodName>,
    /// What bounds the axes; an axis left out is open.
    #[serde(default, rename = "box")]
    pub sides: Sides,
    /// What stands inside the box.
    #[serde(default, rename = "obstacle")]
    pub obstacles: Vec<ObstacleSpec>,
    /// The contact law of all pairs of materials that have none of their own.
    pub law: Option<LawSpec>,
    /// What grains and walls are made of; with one or none of them, nobody needs to name it.
    #[serde(default, rename = "material")]
    pub materials: Vec<MaterialSpec>,
    /// What two different materials do.
    #[serde(default, rename = "pair")]
    pub pairs: Vec<PairLawSpec>,
    /// What the surfaces of all pairs of materials do that say nothing of it: grains rotate. Smooth if left out.
    pub friction: Option<FrictionSpec>,
    /// Moment of inertia of all grains in units of m R²: 0.4 for spheres, which it is if left out, 0.5 for disks.
    pub inertia: Option<f64>,
    /// How the event-driven methods treat what is out of the ordinary.
    #[serde(default)]
    pub options: Options,
    /// Grains one by one.
    #[serde(default, rename = "grain")]
    pub grains: Vec<GrainSpec>,
    /// Grains by number, placed at random.
    pub gas: Option<Gas>,
    /// Grains by kind: how many, how large, of what, where and how fast.
    #[serde(default)]
    pub species: Vec<SpeciesSpec>,
    /// What is measured; nothing if left out.
    pub observe: Option<super::observe::ObserveSpec>,
    /// What drives the grains while they run.
    #[serde(default, rename = "drive")]
    pub drives: Vec<DriveSpec>,
    /// Seed of all that is drawn for species and by what drives them (PCG 64): the same seed gives the same start
    /// everywhere.
    #[serde(default = "first_seed")]
    pub seed: u64,
    /// Where files are looked for that the scenario names.
    #[serde(skip)]
    pub folder: PathBuf,
}

const fn first_seed() -> u64 {
    1
}

/// A method of simulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema, Serialize)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
pub enum MethodName {
    /// Force-based molecular dynamics, velocity Verlet.
    #[serde(rename = "md")]
    Md,
    /// Force-based molecular dynamics, contact by contact, to about 12 digits.
    #[serde(rename = "md-exact")]
    #[cfg_attr(feature = "cli", value(name = "md-exact"))]
    Exact,
    /// Event-driven, hard spheres with the law's ε(v).
    #[serde(rename = "emd")]
    Emd,
    /// Event-driven, with the full matrix of restitution.
    #[serde(rename = "emd*")]
    #[cfg_attr(feature = "cli", value(name = "emd*"))]
    EmdStar,
}

impl MethodName {
    /// The three ways of the comparison.
    pub const ALL: [Self; 3] = [Self::Md, Self::Emd, Self::EmdStar];

    /// As it is written in tables and pictures.
    pub const fn label(self) -> &'static str {
        match self {
            Self::Md => "MD",
            Self::Exact => "MD, exact",
            Self::Emd => "eMD",
            Self::EmdStar => "eMD*",
        }
    }

    /// As it is written in file names.
    pub const fn file_stem(self) -> &'static str {
        match self {
            Self::Md => "md",
            Self::Exact => "md-exact",
            Self::Emd => "emd",
            Self::EmdStar => "emd-star",
        }
    }
}

impl Scenario {
    /// All laws that the scenario names.
    pub fn laws(&self) -> impl Iterator<Item = LawSpec> {
        let of_materials = self.materials.iter().map(|m| (m.law, m.restitution));
        let of_pairs = self.pairs.iter().map(|p| (p.law, p.restitution));
        let own = of_materials.chain(of_pairs).filter_map(|(law, restitution)| {
            law.or(restitution.map(|restitution| LawSpec::Constant { restitution }))
        });
        self.law.into_iter().chain(own)
    }

    /// The one law of all contacts; none if there are several.
    pub fn only_law(&self) -> Option<LawSpec> {
        let mut laws = self.laws();
        let first = laws.next()?;
        laws.all(|law| law == first).then_some(first)
    }

    /// Whether any two surfaces have friction, so that grains rotate.
    pub fn has_friction(&self) -> bool {
        let of_materials = self.materials.iter().filter_map(|m| m.friction);
        let of_pairs = self.pairs.iter().filter_map(|p| p.friction);
        self.friction.into_iter().chain(of_materials).chain(of_pairs).next().is_some()
    }

    /// The methods to run: those asked for, or all that the laws allow.
    pub fn chosen_methods(&self) -> Vec<MethodName> {
        if !self.methods.is_empty() {
            return self.methods.clone();
        }
        let has_force = self.laws().any(|law| law.has_force());
        match self.only_law() {
            _ if !has_force => vec![MethodName::Emd],
            Some(_)
                if self.event_driven_walls().is_none()
                    && self.drives.is_empty()
                    && self.obstacles.is_empty()
                    && !self.has_friction()
                    && self.sides.shear.is_none() =>
            {
                MethodName::ALL.to_vec()
            }
            _ => vec![MethodName::Emd, MethodName::EmdStar],
        }
    }

    /// The first axis with walls that no force-based method knows: hard, or of a material, or two that
    /// vibrate, or some that go on steadily.
    pub fn event_driven_walls(&self) -> Option<&'static str> {
        let is_one = |side: &SideSpec| {
            let (surface, restitution, material) = side.surface().unwrap_or_default();
            let vibrates = side.vibration().is_some_and(|[amplitude, ..]| amplitude != 0.0);
            surface == Some(SurfaceSpec::Hard)
                || restitution.is_some()
                || material.is_some()
                || vibrates && matches!(side, SideSpec::Walls { .. })
                || side.moving() != [0.0; 2]
        };
        self.sides.named().into_iter().find(|(_, side)| is_one(side)).map(|(name, _)| name)
    }
}
