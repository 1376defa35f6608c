//! In which files does a run end up? Reads samples; writes CSV, extended XYZ and aligned text.

mod files;
mod series;
mod text;
mod xyz;

pub use files::Files;
pub use series::{Series, events_head, write_events};
pub use text::write_aligned;
pub use xyz::write_frame;
