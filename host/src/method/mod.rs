//! By which method does a scenario run, and what does every method have? Reads a scenario; writes nothing, hands out one running method.

mod from_scenario;
mod implementations;

pub use from_scenario::{force_law, rules, with, with_state};
pub use implementations::{EventDriven, ForceBased, LoggedEvent, Method};
