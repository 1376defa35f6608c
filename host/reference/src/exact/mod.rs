//! Where is each grain, to about 12 digits? Reads a system and a law; writes its motion, contact by contact.

mod change;
mod flight;
mod run;
mod stop;
mod vibration;
mod window;

pub use run::{ContactRecord, Event, EventKind, Exact, Partner};
