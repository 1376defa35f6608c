//! What does a fluid of equal hard spheres do? Reads number, density and seed; writes how it runs, its pressure and its overlaps.
//!
//! Units: diameter σ, mass and kT at the start are 1. The box is periodic.

mod fluid;
mod overlaps;
pub mod pressure;

pub use fluid::{Fluid, Run, RunState, Spheres, grains};
pub use overlaps::{Impact, Overlaps};
pub use pressure::{Gauge, Mean, Measured, Plan, measure};
