//! Where are things? Boundaries, gravity, free flight, and who is near whom; reads numbers and bodies, writes positions and lists.

mod boundary;
mod cells;
mod choose_grid;
#[cfg(feature = "alloc")]
mod choose_levels;
mod domain;
pub(crate) mod flight;
#[cfg(feature = "alloc")]
mod gather;
mod grid;
#[cfg(feature = "alloc")]
mod levels;
mod link;
#[cfg(feature = "alloc")]
mod look_in_levels;
#[cfg(not(feature = "alloc"))]
mod neighbour_lists;
#[cfg(feature = "alloc")]
mod neighbours;
#[cfg(not(feature = "alloc"))]
mod one_level;
mod particles;
mod plane;
mod plane_motion;
mod sight;
#[cfg(not(feature = "alloc"))]
mod walk;

pub use boundary::{Boundary, MAX_PLANES, PeriodicAxis};
pub use link::Link;
pub use plane::{Plane, Surface};
pub use plane_motion::{Drift, Vibration};

pub(crate) use boundary::SavedBoundary;
pub(crate) use cells::Cells;
#[cfg(feature = "alloc")]
pub(crate) use choose_levels::choose_cells;
pub(crate) use domain::Domain;
pub(crate) use grid::{CellFace, Grid};
#[cfg(not(feature = "alloc"))]
pub(crate) use neighbour_lists::NeighbourBatch;
#[cfg(feature = "alloc")]
pub(crate) use neighbours::{BATCH, NeighbourBatch};
#[cfg(not(feature = "alloc"))]
pub(crate) use one_level::choose_cells;
pub(crate) use particles::{Particles, largest_radius};
pub(crate) use sight::{Sight, crowd_gap};
