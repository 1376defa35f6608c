//! What can a scenario say of obstacles? Reads nothing; writes nothing, names the fields and their values.

use super::sides::{MadeSpec, SurfaceSpec};
use schemars::JsonSchema;
use serde::Deserialize;
use std::path::PathBuf;

/// An obstacle inside the box: one of a polygon, a chain, triangles and a file; for the event-driven methods.
///
/// Grains touch it from both sides. Pieces that follow each other share their corners. The box then has no periodic axis.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ObstacleSpec {
    /// The corners of a closed polygon in their order (m); in two dimensions.
    pub polygon: Option<Vec<Vec<f64>>>,
    /// The points of an open chain (m); in two dimensions.
    pub chain: Option<Vec<Vec<f64>>>,
    /// Triangles, each by its three corners (m); in three dimensions.
    pub triangles: Option<Vec<Vec<Vec<f64>>>>,
    /// Or: a mesh in a file beside the scenario, STL (binary or text) or OBJ by the end of its name; in three dimensions.
    pub file: Option<PathBuf>,
    /// How long the file's unit is (m): 1e-3 for millimetres. 1 if left out.
    pub unit: Option<f64>,
    /// By how much it is displaced from where its corners are (m), a number for each axis.
    #[serde(default)]
    pub at: Vec<f64>,
    /// Whether the mesh must be closed: each edge belongs to two triangles. A hole is then an error that names its place.
    #[serde(default)]
    pub closed: bool,
    /// Whether it is solid: nothing is placed inside of a polygon, or of a mesh, which then must be closed. Without it an
    /// obstacle is its walls, as that of an hourglass is, and grains may be placed on either side of them.
    #[serde(default)]
    pub solid: bool,
    /// How fast its surface moves along itself, from each corner of a polygon or chain to the next (m/s): a belt, or the
    /// wall of a round drum. Rough grains feel it.
    #[serde(default)]
    pub speed: f64,
    /// Or it moves as a whole, steadily with this velocity (m/s), a number for each axis; its corners are where it begins.
    pub velocity: Option<Vec<f64>>,
    /// Or it vibrates: a shaker, a sieve. Its corners are in the middle of its way.
    pub vibration: Option<VibrationSpec>,
    /// Or it turns at a constant rate: a drum, a stirrer. Its corners are where it begins.
    pub rotation: Option<RotationSpec>,
    /// Soft obstacles follow the contact law; hard ones need `restitution`. May be left out: hard if there is a restitution,
    /// else soft.
    pub surface: Option<SurfaceSpec>,
    /// Coefficient of restitution of a hard obstacle.
    pub restitution: Option<f64>,
    /// Or: the name of the `[[material]]` it is made of.
    pub material: Option<String>,
}

/// s(t) = amplitude sin(2π (frequency t + phase)).
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct VibrationSpec {
    /// How far it swings to either side (m), a number for each axis.
    pub amplitude: Vec<f64>,
    /// How often it swings (Hz).
    pub frequency: f64,
    /// Its phase at the start, in turns.
    #[serde(default)]
    pub phase: f64,
}

/// About an axis through a point.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RotationSpec {
    /// A point that stays where it is (m), a number for each axis.
    pub centre: Vec<f64>,
    /// How fast it turns (rad/s): one number in two dimensions, positive anticlockwise; in three a number for each axis.
    pub angular_velocity: Vec<f64>,
}

impl ObstacleSpec {
    /// Names of the ways in which it is said to move.
    pub fn motions(&self) -> Vec<&'static str> {
        let Self { velocity, vibration, rotation, .. } = self;
        let given = [
            ("velocity", velocity.is_some()),
            ("vibration", vibration.is_some()),
            ("rotation", rotation.is_some()),
        ];
        given.into_iter().filter(|(_, is_given)| *is_given).map(|(name, _)| name).collect()
    }

    /// What it is said to be: surface, restitution and material.
    pub fn made(&self) -> MadeSpec<'_> {
        (self.surface, self.restitution, self.material.as_ref())
    }

    /// How many of polygon, chain, triangles and file are given.
    pub fn shapes(&self) -> usize {
        let Self { polygon, chain, triangles, file, .. } = self;
        [polygon.is_some(), chain.is_some(), triangles.is_some(), file.is_some()]
            .into_iter()
            .filter(|is_given| *is_given)
            .count()
    }
}
