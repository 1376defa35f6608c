//! What does ordinary molecular dynamics give, and what does it cost? Reads a system and a law; writes its motion in fixed steps.

mod advance;
mod forces;
mod gear;
mod leg;
mod plan;
mod stop;
mod told;
mod verlet;

pub use gear::Gear;
pub use told::{ContactStep, Tell};
pub use verlet::{Statistics, Verlet, VerletOptions};
