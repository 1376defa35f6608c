//! What bounds the axes of a scenario? Reads nothing; writes nothing, names the fields and their values.

use super::observe::Axis;
use schemars::JsonSchema;
use serde::Deserialize;

/// What bounds each axis.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
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
    /// Which fraction of the box all grains fill (area in two dimensions): sets the size of those
    /// sides, all equal, that say no `from` and `to`.
    pub packing_fraction: Option<f64>,
    /// A steady shear between two periodic axes (Lees and Edwards): the images of the box slide along each other.
    pub shear: Option<ShearSpec>,
}

/// A steady shear between two periodic axes (Lees and Edwards, 1972), for the event-driven methods.
///
/// The velocity of the flow grows by `rate` with each metre along `gradient` and is 0 in the middle of the box. Grains
/// of species and of the gas start with it, besides their own velocities; those that are listed or come from a file
/// start as fast as they are said to be. Temperatures and stresses are of velocities against the flow. There is no
/// gravity, and no wall across either axis.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShearSpec {
    /// The axis along which the grains flow.
    pub flow: Axis,
    /// The axis along which the flow's velocity grows.
    pub gradient: Axis,
    /// The shear rate (1/s).
    pub rate: f64,
}

/// What bounds one axis.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "lowercase", deny_unknown_fields)]
pub enum SideSpec {
    /// Nothing.
    #[default]
    Open,
    /// The box repeats.
    Periodic {
        /// Lower end (m); may be left out with a packing fraction.
        from: Option<f64>,
        /// Upper end (m).
        to: Option<f64>,
    },
    /// Two plane walls.
    Walls {
        /// Lower wall (m); may be left out with a packing fraction.
        from: Option<f64>,
        /// Upper wall (m).
        to: Option<f64>,
        /// Soft walls follow the contact law; hard ones need `restitution`. May be left out: hard if
        /// there is a restitution, else soft.
        surface: Option<SurfaceSpec>,
        /// Coefficient of restitution of hard walls.
        restitution: Option<f64>,
        /// Or: the name of the `[[material]]` they are made of; the law is that of it and the grain's.
        material: Option<String>,
        /// A₀ (m): both walls are where `from` and `to` say, and A₀ sin(2π (f t + φ)) further on; 0,
        /// the default, is at rest.
        #[serde(default)]
        amplitude: f64,
        /// f (Hz).
        #[serde(default)]
        frequency: f64,
        /// φ, in turns.
        #[serde(default)]
        phase: f64,
        /// How fast the lower and the upper wall go on steadily along the axis (m/s); 0, the default, is at rest.
        #[serde(default)]
        moving: [f64; 2],
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
        /// How fast it goes on steadily along the axis (m/s); 0, the default, is at rest or vibrates.
        #[serde(default)]
        moving: f64,
        /// Soft plates follow the contact law; hard ones need `restitution`. May be left out: hard if
        /// there is a restitution, else soft.
        surface: Option<SurfaceSpec>,
        /// Coefficient of restitution of a hard plate.
        restitution: Option<f64>,
        /// Or: the name of the `[[material]]` it is made of.
        material: Option<String>,
    },
}

/// What walls, plates and obstacles are said to be: surface, restitution and material.
pub type MadeSpec<'a> = (Option<SurfaceSpec>, Option<f64>, Option<&'a String>);

impl SideSpec {
    /// What walls and plates are said to be.
    pub fn surface(&self) -> Option<MadeSpec<'_>> {
        match self {
            Self::Walls { surface, restitution, material, .. }
            | Self::Plate { surface, restitution, material, .. } => {
                Some((*surface, *restitution, material.as_ref()))
            }
            Self::Open | Self::Periodic { .. } => None,
        }
    }

    /// How fast the lower and the upper wall go on steadily.
    pub fn moving(&self) -> [f64; 2] {
        match *self {
            Self::Walls { moving, .. } => moving,
            Self::Plate { moving, .. } => [moving, 0.0],
            Self::Open | Self::Periodic { .. } => [0.0; 2],
        }
    }

    /// Amplitude, frequency and phase of walls and plates.
    pub fn vibration(&self) -> Option<[f64; 3]> {
        match *self {
            Self::Walls { amplitude, frequency, phase, .. }
            | Self::Plate { amplitude, frequency, phase, .. } => {
                Some([amplitude, frequency, phase])
            }
            Self::Open | Self::Periodic { .. } => None,
        }
    }
}

impl Sides {
    /// The axes by name.
    pub fn named(&self) -> [(&'static str, &SideSpec); 3] {
        [("x", &self.x), ("y", &self.y), ("z", &self.z)]
    }
}

/// What walls are made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum SurfaceSpec {
    /// The contact law, with a partner of infinite mass.
    Soft,
    /// An instantaneous collision.
    Hard,
}
