//! What is a value? The operations the engine uses on numbers, and on vectors and times made of them.
//!
//! Everything above this room is written against [`Scalar`]: `f32`, `f64` and, with the feature `fixed`,
//! `I32F32` and `I16F16`. All transcendental functions come from software, so a target
//! with a floating-point unit gives the same bits as one without; fixed point uses no float at all.

#[cfg(feature = "micromath")]
pub mod approximate;
mod axial;
mod clock;
#[cfg(feature = "fixed")]
mod fixed;
mod float;
mod instant;
mod into_instant;
mod lanes;
mod traits;
mod trigonometry;
mod vector;

pub(crate) use axial::{Axial, axes, moment, sliding, swept};
#[cfg(feature = "fixed")]
pub use carom_tables::fixed_point::{I16F16, I32F32};
pub use carom_tables::read::Real;
pub(crate) use clock::Clock;
pub use instant::{Instant, TimeSpan};
pub use into_instant::IntoInstant;
#[cfg(feature = "alloc")]
pub(crate) use lanes::{LANES, Lanes};
pub use traits::{
    Comparison, Elementary, Power, Products, Range, Rounding, Scalar, Timekeeping, Vector,
    WideProduct,
};
pub(crate) use vector::{all_finite, component, max_abs, reject, unit, vector};
pub use vector::{dot, norm};
