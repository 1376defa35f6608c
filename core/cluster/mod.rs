//! What do many bodies do that touch at once? Clusters: who is in one, their forces, steps and sleep; reads bodies and the rule, writes bodies.

mod contact;
mod crowd;
mod forces;
mod friction;
mod members;
mod order;
mod remembered;
mod resting;
mod settings;
mod sleep;
mod step;
mod transfer;
mod watch;

pub(crate) use crowd::{Course, Party, is_crowded};
pub(crate) use forces::{Crush, MAX_COLLISIONS};
pub(crate) use members::{Clusters, join, leave, wake};
pub(crate) use order::put_last_in_order;
pub(crate) use resting::for_each_resting;
pub(crate) use settings::Settings;
pub(crate) use step::{settle, step};
pub(crate) use transfer::Receiver;
pub use transfer::Transfer;
pub(crate) use watch::next_event;
