//! What moves, and in which space? Grains, free flight, boundaries; reads numbers, writes positions.

pub mod boundary;
pub mod cells;
pub mod flight;
pub mod grain;
pub mod grid;

pub use boundary::{Boundary, Periodic, Plane, Surface};
pub use grain::{Body, Grain, Partner};
