//! Is the event-driven run the force-based one? The engine against the reference MD and the papers.

mod bsfp14;
mod divergence;
mod fluid;
mod haff;
mod l94;
mod mp13;
mod mp13_fig6;
mod shaken;
mod soak;
mod wall;
