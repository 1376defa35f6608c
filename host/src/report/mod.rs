//! In which files does a run end up? Reads samples; writes CSV, extended XYZ and JSON.

mod series;
mod xyz;

pub use series::{Series, events_head, write_events};
pub use xyz::write_frame;
