//! When does something happen next? Reads bodies, boundaries and cells; writes nothing, returns predictions.

mod approach;
pub mod bracket;
mod cell_crossing;
mod collision_time;
mod number_range;
mod predictor;
mod prefilter;
pub mod root;
mod scheduled_event;
mod shaking;
mod take_off;

pub(crate) use approach::closing_speed;
pub(crate) use predictor::{next_event, next_event_after_crossing};
pub use scheduled_event::{EventKind, ScheduledEvent};
