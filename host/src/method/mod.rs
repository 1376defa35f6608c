//! By which method does a scenario run, and what can be asked of it? Reads a scenario; writes nothing, lends one running method.

mod ask;
mod choose;

pub use ask::{EventDriven, ForceBased, Logged, Method};
pub use choose::{force_law, rule, with};
