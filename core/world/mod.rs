//! How does a user hold a world? Memory, builder, steps, observation, snapshots; reads and writes everything below.

mod advance;
#[cfg(feature = "obstacles")]
mod among_obstacles;
mod builder;
mod change;
mod check_facets;
mod check_input;
mod check_rotation;
mod check_scales;
mod check_snapshot;
mod describe;
mod digest;
mod gravity;
mod observe;
mod places;
mod predictions;
mod rotate;
mod rotating;
mod saved_rotation;
mod searches;
mod snapshot;
mod state;
mod statistics;
mod step;
mod step_clusters;
mod storage;
mod timekeeping;
mod together;
mod view;

#[cfg(feature = "obstacles")]
pub use among_obstacles::{NoMotion, WithObstacles};
pub use builder::{NoRule, WorldBuilder};
pub use observe::{Event, Observer};
pub use rotating::{Rotating, WithContacts};
pub use saved_rotation::{NoRotation, SavedRotation};
pub use searches::Searches;
pub use snapshot::{Borrowed, Snapshot};
pub use state::World;
pub use statistics::Statistics;
#[cfg(feature = "alloc")]
pub use storage::HeapMemory;
pub use storage::{Buffers, Memory, Storage};
pub use view::{Motion, Relative, View};

pub use crate::cluster::Transfer;
pub use crate::detect::{EventKind, ScheduledEvent};
pub use crate::resolve::{EventOutcome, Release};
pub use crate::space::{ObstacleBuffers, RotationBuffers};
