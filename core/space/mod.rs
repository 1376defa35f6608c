//! Where are things? Boundaries, gravity, free flight, and who is near whom; reads numbers and bodies, writes positions and lists.

mod boundary;
mod cells;
mod domain;
pub(crate) mod flight;
mod grid;
mod neighbours;
mod particles;
mod plane;

pub use boundary::{Boundary, MAX_PLANES, PeriodicAxis};
pub use cells::Link;
pub use plane::{Plane, Surface, Vibration};

pub(crate) use boundary::SavedBoundary;
pub(crate) use cells::Cells;
pub(crate) use domain::Domain;
pub(crate) use grid::{CellFace, Grid};
pub(crate) use neighbours::{BATCH, NeighbourBatch};
pub(crate) use particles::{Particles, largest_radius};
