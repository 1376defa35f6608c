//! What is the life of one event? predict (when?), queue (who is next?), apply (now); reads matter and law.

pub(crate) mod apply;
mod bounce;
pub mod bracket;
pub(crate) mod contact;
mod glance;
pub(crate) mod order;
mod plane;
pub(crate) mod predict;
pub(crate) mod queue;
mod range;
pub(crate) mod rest;
pub mod root;
pub(crate) mod scene;
pub(crate) mod support;
mod touch;
pub(crate) mod turn;
pub(crate) mod wake;
mod wander;

pub use apply::Deed;
pub use queue::{Kind, Slot};
pub use scene::{Counters, Release};
