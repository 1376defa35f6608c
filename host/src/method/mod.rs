//! By which method does a scenario run, and what does every method have? Reads a scenario; writes nothing, hands out one running method.

mod event_driven;
mod force_based;
mod from_scenario;
mod interface;
mod l94;
mod obstacles;
mod running;
mod spins;
mod told;

pub use event_driven::EventDriven;
pub use force_based::ForceBased;
pub use from_scenario::{begin, force_law, rules, with, with_state};
pub use interface::{LoggedEvent, Method};
pub use running::Running;
