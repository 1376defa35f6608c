//! How can carom say no? Every error names the field or knob, its value, and what would be right.

mod brief;
mod refusal;
mod words;

pub use brief::Brief;
pub use refusal::{Error, Subject};
