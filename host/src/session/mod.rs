//! How do all methods of a scenario become files? Reads a scenario; writes a folder of results, whole or not at all.
//!
//! A run grows in the folder `unfinished` beside its results. When all of its methods are through, its
//! files move there together, so that no result of one run stands beside those of another. What a fault or
//! a kill leaves stays in `unfinished`; from a checkpoint there it can go on, to the same bits.

mod checkpoint;
mod scribe;
mod summary;
mod unfinished;
mod work;

pub use summary::{MethodSummary, Summary};
pub use work::{Orders, run};
