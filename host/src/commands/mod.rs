//! What does each command do? Reads the options of one command; writes its results.

pub mod bench;
pub mod collide;
pub mod compare;
pub mod figure;
pub mod hard;
mod heaps;
mod impacts;
pub mod plot;
pub mod run;
pub mod scenario;
pub mod sweep;
pub mod table;
