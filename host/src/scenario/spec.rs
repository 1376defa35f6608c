//! What can a scenario file say? Reads nothing; writes nothing, names the fields and their values.

use serde::{Deserialize, Serialize};

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
    /// What is measured; nothing if left out.
    pub observe: Option<super::observe::ObserveSpec>,
}

/// A method of simulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
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
    /// The methods to run: those asked for, or all that the law allows.
    pub fn chosen_methods(&self) -> Vec<MethodName> {
        match (self.methods.is_empty(), self.law) {
            (false, _) => self.methods.clone(),
            (true, LawSpec::Constant { .. }) => vec![MethodName::Emd],
            (true, _) if self.hard_walls().is_some() => vec![MethodName::Emd, MethodName::EmdStar],
            (true, _) => MethodName::ALL.to_vec(),
        }
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

/// What bounds each axis.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sides {
    /// First axis.
    #[serde(default)]
    pub x: SideSpec,
    /// Second axis.
    #[serde(default)]
    pub y: SideSpec,
    /// Third axis.
    #[serde(default)]
    pub z: SideSpec,
}

/// What bounds one axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize)]
#[serde(tag = "kind", rename_all = "lowercase", deny_unknown_fields)]
pub enum SideSpec {
    /// Nothing.
    #[default]
    Open,
    /// The box repeats.
    Periodic {
        /// Lower end (m); may be left out with `gas.packing_fraction`.
        from: Option<f64>,
        /// Upper end (m).
        to: Option<f64>,
    },
    /// Two plane walls.
    Walls {
        /// Lower wall (m); may be left out with `gas.packing_fraction`.
        from: Option<f64>,
        /// Upper wall (m).
        to: Option<f64>,
        /// Soft walls follow the contact law; hard ones need `restitution`.
        surface: SurfaceSpec,
        /// Coefficient of restitution of hard walls.
        restitution: Option<f64>,
    },
    /// A plate below, z₀(t) = at + A₀ sin(2π (f t + φ)) (L94, Eq. 1); nothing above.
    Plate {
        /// Its mean place (m).
        at: f64,
        /// A₀ (m); 0, the default, is a plate at rest.
        #[serde(default)]
        amplitude: f64,
        /// f (Hz).
        #[serde(default)]
        frequency: f64,
        /// φ, in turns.
        #[serde(default)]
        phase: f64,
        /// Soft plates follow the contact law; hard ones need `restitution`.
        surface: SurfaceSpec,
        /// Coefficient of restitution of a hard plate.
        restitution: Option<f64>,
    },
}

/// What walls are made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum SurfaceSpec {
    /// The contact law, with a partner of infinite mass.
    Soft,
    /// An instantaneous collision.
    Hard,
}

/// The contact law.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
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
    /// Hard spheres with a constant coefficient of restitution: event-driven only.
    Constant {
        /// ε.
        restitution: f64,
    },
}

/// How the event-driven methods treat what is out of the ordinary.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Options {
    /// What to do with a collision outside the table's domain.
    pub outside: OutsideSpec,
    /// What becomes of contacts that last or crowd.
    pub enduring: EnduringSpec,
    /// How a contact ends when a third grain interrupts it, with `enduring = "paper"`.
    pub release: ReleaseSpec,
    /// Where the matrix of restitution comes from.
    pub matrix: MatrixSpec,
    /// Which table.
    pub table: crate::tables::Size,
    /// t_c of the TC rule (s), for hard collisions; 0, the default, is no such rule.
    pub tc: f64,
    /// Write the event-driven methods' events to a CSV file.
    pub events: bool,
    /// How long `carom compare` runs the exact MD (s); positions are compared until then.
    pub exact_until: Option<f64>,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            outside: OutsideSpec::HardSphere,
            enduring: EnduringSpec::Integrated,
            release: ReleaseSpec::Paired,
            matrix: MatrixSpec::Table,
            table: crate::tables::Size::Standard,
            tc: 0.0,
            events: false,
            exact_until: None,
        }
    }
}

/// See [`carom::law::Outside`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum OutsideSpec {
    /// Stop with an error.
    Reject,
    /// Use the nearest collision inside.
    Clamp,
    /// Use the hard-sphere rule.
    HardSphere,
}

/// See [`carom::Enduring`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum EnduringSpec {
    /// As in the papers.
    Paper,
    /// Integrated.
    Integrated,
}

/// See [`carom::Release`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ReleaseSpec {
    /// Both at once.
    Paired,
    /// Each for itself.
    Independent,
}

/// Where the matrix of restitution comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum MatrixSpec {
    /// An embedded table.
    Table,
    /// The contact equation, integrated for each collision.
    Integrate,
}

/// One grain.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GrainSpec {
    /// Radius (m).
    pub radius: f64,
    /// Mass (kg); this or `density`.
    pub mass: Option<f64>,
    /// Density of a sphere (kg/m³); this or `mass`.
    pub density: Option<f64>,
    /// Centre (m).
    pub at: Vec<f64>,
    /// Velocity (m/s); at rest if left out.
    #[serde(default)]
    pub moving: Vec<f64>,
}

/// Many grains, placed at random without overlap.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Gas {
    /// How many.
    pub count: usize,
    /// Fraction of the box (area in two dimensions) that the grains fill; sets the size of a cubic
    /// box whose sides say no `from` and `to`.
    pub packing_fraction: Option<f64>,
    /// Radius (m), or the smallest and the largest, drawn evenly in between.
    pub radius: RadiusSpec,
    /// Density of the spheres (kg/m³).
    pub density: f64,
    /// v_th (m/s): each component of a velocity is normal with variance v_th²/2; the total
    /// momentum is then set to zero.
    pub thermal_speed: f64,
    /// Seed of the random numbers (PCG 64): the same seed gives the same gas everywhere.
    pub seed: u64,
}

/// One radius or a range.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(untagged)]
pub enum RadiusSpec {
    /// All the same.
    One(f64),
    /// From the smallest to the largest.
    Range([f64; 2]),
}

impl RadiusSpec {
    /// Smallest and largest.
    pub const fn range(self) -> [f64; 2] {
        match self {
            Self::One(radius) => [radius, radius],
            Self::Range(range) => range,
        }
    }
}
