//! Who is next? The queue of all grains' events, and what of one instant comes first; reads predictions, writes the queue.

mod queue;
mod simultaneous;
mod stale;

pub(crate) use queue::EventQueue;
pub(crate) use simultaneous::{first_of_instant, is_tied};
