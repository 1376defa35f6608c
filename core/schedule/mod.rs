//! Who is next? The queue of all grains' events, and what of one instant comes first; reads predictions, writes the queue.

#[cfg(feature = "alloc")]
mod calendar;
#[cfg(not(feature = "alloc"))]
mod no_calendar;
mod queue;
mod simultaneous;
mod stale;
mod tournament;

pub(crate) use queue::EventQueue;
pub(crate) use simultaneous::{first_of_instant, is_tied};
