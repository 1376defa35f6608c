//! What does ordinary molecular dynamics give, and what does it cost? Reads a system and a law; writes its motion in fixed steps.

mod forces;
mod gear;
mod plan;
mod stop;
mod verlet;

pub use gear::Gear;
pub use verlet::{Statistics, Verlet, VerletOptions};
