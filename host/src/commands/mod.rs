//! What does each command do? Reads the options of one command; writes its results.

pub mod bench;
pub mod collide;
pub mod compare;
pub mod demo;
pub mod divergence;
pub mod figure;
pub mod fluid;
pub mod merge;
pub mod run;
pub mod soak;
pub mod sweep;
pub mod table;
