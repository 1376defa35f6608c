//! What can a scenario file say? Reads nothing; writes nothing, names the fields and their values.

use serde::Deserialize;

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
    /// How a contact ends when a third grain interrupts it.
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
