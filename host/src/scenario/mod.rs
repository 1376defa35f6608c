//! What is to be simulated? Reads a TOML file; writes nothing, returns a checked scenario.

mod checks;
mod place;
mod spec;
mod start;

pub use spec::{
    Gas, GrainSpec, LawSpec, MatrixSpec, Options, OutsideSpec, RadiusSpec, ReleaseSpec, SideSpec,
    Sides, SurfaceSpec,
};
pub use start::{Placed, Side, Start};

use anyhow::{Context, Result, anyhow};
use clap::ValueEnum;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// A scenario as its file says it. See `scenarios/` for three that are explained.
///
/// # Units
/// SI throughout.
#[derive(Clone, Debug, Deserialize)]
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
    /// Which methods `carom run` runs: md, md-exact, emd, emd*; md, emd and emd* if left out.
    #[serde(default)]
    pub methods: Vec<MethodName>,
    /// What bounds the axes; an axis left out is open.
    #[serde(default, rename = "box")]
    pub sides: Sides,
    /// The contact law.
    pub law: LawSpec,
    /// How the event-driven methods treat what is out of the ordinary.
    #[serde(default)]
    pub options: Options,
    /// Grains one by one.
    #[serde(default, rename = "grain")]
    pub grains: Vec<GrainSpec>,
    /// Grains by number, placed at random.
    pub gas: Option<Gas>,
}

/// A method of simulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize, ValueEnum)]
pub enum MethodName {
    /// Force-based molecular dynamics, velocity Verlet.
    #[serde(rename = "md")]
    Md,
    /// Force-based molecular dynamics, contact by contact, to about 12 digits.
    #[serde(rename = "md-exact")]
    #[value(name = "md-exact")]
    Exact,
    /// Event-driven, hard spheres with the law's ε(v).
    #[serde(rename = "emd")]
    Emd,
    /// Event-driven, with the full matrix of restitution.
    #[serde(rename = "emd*")]
    #[value(name = "emd*")]
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
    /// Reads a scenario file.
    ///
    /// # Errors
    /// One line that names file, line and field.
    pub fn read(file: &Path) -> Result<Self> {
        let name = file.display();
        let text = std::fs::read_to_string(file).with_context(|| format!("cannot read {name}"))?;
        Self::parse(&text).with_context(|| format!("{name}"))
    }

    /// Reads a scenario from text.
    ///
    /// # Errors
    /// One line that names line or field.
    ///
    /// ```
    /// use carom_host::scenario::Scenario;
    /// let text = "dimension = 1\nduration = 1.0\nsample = 0.1\n\
    ///     [law]\nkind = \"constant\"\nrestitution = 1.5\n\
    ///     [[grain]]\nradius = 0.1\nmass = 1.0\nat = [0.0]";
    /// let error = Scenario::parse(text).unwrap_err().to_string();
    /// assert_eq!(error, "law.restitution is 1.5, must be from 0 to 1");
    /// ```
    pub fn parse(text: &str) -> Result<Self> {
        let scenario: Self = toml::from_str(text).map_err(|error| {
            let line = error.span().map_or(1, |span| 1 + text[..span.start].matches('\n').count());
            anyhow!("line {line}: {}", error.message().replace('\n', ", "))
        })?;
        checks::check(&scenario)?;
        Ok(scenario)
    }

    /// The methods to run: those asked for, or all that the law allows.
    pub fn chosen_methods(&self) -> Vec<MethodName> {
        match (self.methods.is_empty(), self.law) {
            (false, _) => self.methods.clone(),
            (true, LawSpec::Constant { .. }) => vec![MethodName::Emd],
            (true, _) if self.hard_walls().is_some() => vec![MethodName::Emd, MethodName::EmdStar],
            (true, _) => MethodName::ALL.to_vec(),
        }
    }

    /// The same scenario, run by this method only.
    ///
    /// # Errors
    /// When the law or the box does not allow it.
    pub fn with_method(self, method: MethodName) -> Result<Self> {
        let scenario = Self { methods: vec![method], ..self };
        checks::check(&scenario)?;
        Ok(scenario)
    }

    /// The first axis with hard walls, which no force-based method knows.
    pub fn hard_walls(&self) -> Option<&'static str> {
        let sides = [("x", self.sides.x), ("y", self.sides.y), ("z", self.sides.z)];
        let hard = |side: SideSpec| match side {
            SideSpec::Walls { surface, .. } | SideSpec::Plate { surface, .. } => {
                surface == SurfaceSpec::Hard
            }
            _ => false,
        };
        sides.into_iter().find(|(_, side)| hard(*side)).map(|(name, _)| name)
    }
}
