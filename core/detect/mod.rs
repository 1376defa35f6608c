//! When does something happen next? Reads bodies, boundaries and cells; writes nothing, returns predictions.

mod across;
mod among_moving;
mod among_obstacles;
mod approach;
pub mod bracketed_root;
mod cell_crossing;
mod collision_time;
mod facet_collision;
#[cfg(any(test, not(feature = "alloc")))]
mod horizon;
#[cfg(feature = "alloc")]
mod look;
#[cfg(not(feature = "alloc"))]
mod look_in_turn;
mod number_range;
mod plate_acceleration;
mod predictor;
#[cfg(feature = "alloc")]
mod prefilter;
pub mod root;
mod scheduled_event;
mod take_off;

pub(crate) use among_obstacles::facet_collision;
pub(crate) use approach::closing_speed;
pub(crate) use collision_time::{pair_collision, plane_collision};
#[cfg(not(feature = "alloc"))]
pub(crate) use predictor::next_event_alone;
pub(crate) use predictor::{next_event, next_event_after_crossing};
pub use scheduled_event::{EventKind, ScheduledEvent};
