//! By which method does a scenario run, and what does every method have? Reads a scenario; writes nothing, hands out one running method.

mod components;
mod enclose;
mod event_driven;
mod force_based;
mod force_law;
mod from_scenario;
mod interface;
mod l94;
mod obstacles;
mod rules;
mod running;
mod spins;
mod told;

pub use event_driven::EventDriven;
pub use force_based::ForceBased;
pub use force_law::force_law;
pub use from_scenario::{begin, with, with_state};
pub use interface::{LoggedEvent, Method};
pub use rules::rules;
pub use running::Running;
