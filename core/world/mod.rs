//! How does a user hold a world? Memory, builder, steps, observation, snapshots; reads and writes everything below.

mod advance;
mod builder;
mod change;
mod check_input;
mod check_scales;
mod check_snapshot;
mod describe;
mod digest;
mod gravity;
mod observe;
mod places;
mod predictions;
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

pub use builder::{NoRule, WorldBuilder};
pub use observe::{Event, Observer};
pub use searches::Searches;
pub use snapshot::Snapshot;
pub use state::World;
pub use statistics::Statistics;
#[cfg(feature = "alloc")]
pub use storage::HeapMemory;
pub use storage::{Buffers, Memory, Storage};
pub use view::{Motion, Relative, View};

pub use crate::detect::{EventKind, ScheduledEvent};
pub use crate::resolve::{EventOutcome, Release};
