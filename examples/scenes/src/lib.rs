//! What runs on every target? Scenes, the tilt box and a force-based run beside it; reads nothing, writes to a callback.
//!
//! Firmware, WebAssembly and the host include this one crate, so that they compute the same thing.
//! Units: millimetre, millisecond, and the mass of a sphere of 1 mm radius and 2.5 g/cm³ (Fig. 6: SI).
//! With them every number stays near one, as fixed-point scalars need it.
#![no_std]

pub mod heap;
#[cfg(feature = "obstacles")]
pub mod hourglass;
pub mod largest;
pub mod measure;
#[cfg(all(feature = "plates", feature = "obstacles"))]
pub mod replay;
pub mod rough;
pub mod scene;
pub mod tilt;
pub mod time_stepped;

#[cfg(all(feature = "plates", feature = "obstacles"))]
pub use replay::EventDigest;
pub use scene::{Number, Scene};
