//! Who is next? The queue of all grains' events, and what of one instant comes first; reads predictions, writes the queue.

mod order;
mod queue;

pub(crate) use order::first_of_instant;
pub(crate) use queue::EventQueue;
