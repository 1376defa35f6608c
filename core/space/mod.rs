//! Where are things? Boundaries, gravity, free flight, and who is near whom; reads numbers and bodies, writes positions and lists.

mod across;
mod boundary;
mod cells;
mod choose_grid;
#[cfg(feature = "alloc")]
mod choose_levels;
mod contacts;
mod domain;
mod facet;
mod facet_lists;
pub(crate) mod flight;
#[cfg(feature = "alloc")]
mod gather;
mod grid;
mod grid_fits;
mod if_obstacles;
mod if_sheared;
mod inside;
#[cfg(feature = "alloc")]
mod levels;
mod link;
#[cfg(feature = "alloc")]
mod look_in_levels;
mod nearest;
#[cfg(not(feature = "alloc"))]
mod neighbour_lists;
#[cfg(feature = "alloc")]
mod neighbours;
#[cfg(not(feature = "plates"))]
mod no_plates;
mod obstacle_buffers;
mod obstacles;
#[cfg(not(feature = "alloc"))]
mod one_level;
mod particles;
mod periodic_axis;
mod plane;
mod plane_motion;
#[cfg(feature = "plates")]
mod plates;
mod pose;
mod rigid_motion;
mod rotation;
mod shear;
mod sight;
mod unit_normal;
#[cfg(not(feature = "alloc"))]
mod walk;

pub use boundary::{Boundary, MAX_PLANES};
pub use contacts::ContactState;
pub use facet::{Facet, chain, mesh, polygon};
pub use link::Link;
#[cfg(not(feature = "plates"))]
pub use no_plates::{Drift, Vibration};
pub use obstacle_buffers::ObstacleBuffers;
pub use periodic_axis::PeriodicAxis;
pub use plane::{Plane, Surface};
#[cfg(feature = "plates")]
pub use plates::{Drift, Vibration};
pub use rigid_motion::RigidMotion;
pub use rotation::RotationBuffers;
pub use shear::Shear;

pub(crate) use boundary::SavedBoundary;
pub(crate) use cells::Cells;
#[cfg(feature = "alloc")]
pub(crate) use choose_levels::choose_cells;
pub(crate) use contacts::Contacts;
pub(crate) use domain::Domain;
pub(crate) use grid::{CellFace, Grid};
#[cfg(not(feature = "alloc"))]
pub(crate) use neighbour_lists::NeighbourBatch;
#[cfg(feature = "alloc")]
pub(crate) use neighbours::{BATCH, NeighbourBatch};
pub(crate) use obstacles::Obstacles;
#[cfg(not(feature = "alloc"))]
pub(crate) use one_level::choose_cells;
pub(crate) use particles::{Particles, largest_radius};
pub(crate) use shear::Images;
pub(crate) use sight::{Sight, crowd_gap};
