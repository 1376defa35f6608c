//! What moves, and in which space? Grains, free flight, boundaries; reads numbers, writes positions.

pub mod boundary;
pub mod cells;
pub mod flight;
pub mod grain;
pub mod grid;
pub mod plane;

pub use boundary::{Boundary, Periodic};
pub use flight::Field;
pub use grain::{Body, Grain, Partner};
pub use plane::{Plane, Surface, Vibration};
