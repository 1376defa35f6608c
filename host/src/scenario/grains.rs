//! How does a scenario name grains? Reads nothing; writes nothing, names the fields and their values.

use schemars::JsonSchema;
use serde::Deserialize;
use std::path::PathBuf;

/// One grain.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GrainSpec {
    /// Radius (m).
    pub radius: f64,
    /// Mass (kg).
    pub mass: Option<f64>,
    /// Density of a sphere (kg/m³); that of the material if neither this nor `mass` is said.
    pub density: Option<f64>,
    /// The name of a `[[material]]`; may be left out if there is one at most.
    pub material: Option<String>,
    /// Centre (m).
    pub at: Vec<f64>,
    /// Velocity (m/s); at rest if left out.
    #[serde(default)]
    pub moving: Vec<f64>,
    /// Angular velocity (1/s), where there is friction: one number in two dimensions, three in three; none if left out.
    #[serde(default)]
    pub rotating: Vec<f64>,
}

/// Many grains, placed at random without overlap: the short form of one `[[species]]`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Gas {
    /// How many.
    pub count: usize,
    /// Fraction of the box (area in two dimensions) that the grains fill; sets the size of those
    /// sides, all equal, that say no `from` and `to`, and the height above a plate.
    pub packing_fraction: Option<f64>,
    /// Radius (m).
    pub radius: RadiusSpec,
    /// Density of the spheres (kg/m³); that of the material if left out.
    pub density: Option<f64>,
    /// The name of a `[[material]]`; may be left out if there is one at most.
    pub material: Option<String>,
    /// v_th (m/s): each component of a velocity is normal with variance v_th²/2; the total
    /// momentum is then set to zero.
    pub thermal_speed: f64,
    /// Seed of the random numbers (PCG 64): the same seed gives the same gas everywhere.
    pub seed: u64,
}

/// Many grains of one kind.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SpeciesSpec {
    /// For tables and files; "species 0" and so on if left out.
    pub name: Option<String>,
    /// How many; this or `packing_fraction`. A file has as many as it has.
    pub count: Option<usize>,
    /// Or: as many as fill this fraction of the region (area in two dimensions).
    pub packing_fraction: Option<f64>,
    /// Radius (m). A file may say it instead.
    pub radius: Option<RadiusSpec>,
    /// Density of the spheres (kg/m³); that of the material if left out.
    pub density: Option<f64>,
    /// The name of a `[[material]]`; may be left out if there is one at most.
    pub material: Option<String>,
    /// How they are placed: `fill` if left out. Species of the same placement are mixed.
    #[serde(default)]
    pub place: PlaceSpec,
    /// Granular temperature (J): velocities are normal, then scaled so that their mean is zero and
    /// T = ⟨m v²⟩/D exactly. At rest if none of this, `thermal_speed` and `moving` is said.
    pub temperature: Option<f64>,
    /// v_th (m/s): the same with ⟨m v²⟩/D = ⟨m⟩ v_th²/2.
    pub thermal_speed: Option<f64>,
    /// A velocity that all have besides (m/s), a number for each axis.
    #[serde(default)]
    pub moving: Vec<f64>,
}

/// One radius, or how radii are distributed.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(untagged, deny_unknown_fields)]
pub enum RadiusSpec {
    /// All the same.
    One(f64),
    /// From the smallest to the largest, drawn evenly in between.
    Range([f64; 2]),
    /// The same.
    Uniform {
        /// The smallest and the largest (m).
        uniform: [f64; 2],
    },
    /// Normal; what is more than three standard deviations off is drawn again.
    Gaussian {
        /// Mean (m).
        mean: f64,
        /// Standard deviation (m), less than a third of the mean.
        deviation: f64,
    },
    /// These, one after the other, again from the first after the last.
    List {
        /// Radii (m).
        list: Vec<f64>,
    },
}

/// How grains are placed. None overlaps anything.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "lowercase", deny_unknown_fields)]
pub enum PlaceSpec {
    /// At random: one after the other while they are few, else by compression (Lubachevsky and
    /// Stillinger, J. Stat. Phys. 60, 561 (1990)).
    Fill {
        /// Lower corner of the region (m); the box's if left out.
        from: Option<Vec<f64>>,
        /// Upper corner (m); the box's if left out. Above a plate that says none, the height is
        /// such that a fifth of the region is filled.
        to: Option<Vec<f64>>,
    },
    /// On a lattice that fills the region as widely as it can; what is too many of its sites is left
    /// empty, evenly.
    Lattice {
        /// Which one; close if left out.
        #[serde(default)]
        lattice: LatticeName,
        /// Lower corner of the region (m); the box's if left out.
        from: Option<Vec<f64>>,
        /// Upper corner (m); the box's if left out.
        to: Option<Vec<f64>>,
    },
    /// In rows over a plate or the lower wall, each in the hollows of the one below, with gaps: it
    /// settles when gravity acts.
    Layer {
        /// The gap between two of the largest, in units of their diameter; 0.05 if left out.
        gap: Option<f64>,
        /// Lower corner of the region (m); the box's if left out.
        from: Option<Vec<f64>>,
        /// Upper corner (m); the box's if left out. The height is what the rows need.
        to: Option<Vec<f64>>,
    },
    /// In a heap on a plate or the lower wall, rows that touch: a triangle in two dimensions, a
    /// pyramid on a square in three.
    Pile {
        /// Where its middle is (m), a number for each axis, of which the vertical one does not
        /// count; the middle of the box if left out.
        at: Option<Vec<f64>>,
    },
    /// Where a file says: extended XYZ (as `carom run` writes it), CSV or Parquet with columns x, y,
    /// z and, if there are, vx, vy, vz, radius, mass, species, frame or time. Velocities are the
    /// file's, unless `temperature` or `thermal_speed` is said.
    File {
        /// Its name, from the scenario's folder; it ends in .xyz, .csv or .parquet.
        path: PathBuf,
        /// Which frame, counted from 0; the last one if left out.
        frame: Option<usize>,
        /// Only grains of this species, as the file calls it.
        only: Option<String>,
    },
}

/// A lattice.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum LatticeName {
    /// A chain, a square or a simple cubic lattice.
    Cubic,
    /// A chain, a triangular or a face-centred cubic lattice.
    #[default]
    Close,
}

impl PlaceSpec {
    /// Lower and upper corner, as far as they are given.
    pub fn corners(&self) -> [Option<&Vec<f64>>; 2] {
        match self {
            Self::Fill { from, to }
            | Self::Lattice { from, to, .. }
            | Self::Layer { from, to, .. } => [from.as_ref(), to.as_ref()],
            Self::Pile { .. } | Self::File { .. } => [None, None],
        }
    }
}

impl Default for PlaceSpec {
    fn default() -> Self {
        Self::Fill { from: None, to: None }
    }
}
