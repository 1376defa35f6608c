//! Is the event-driven run the force-based one? The engine against the reference MD and the papers.

mod bsfp14;
mod divergence;
mod fig6;
mod fluid;
mod haff;
mod l94;
mod mp13;
mod shaken;
mod soak;
