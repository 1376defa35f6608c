//! What must hold for any bytes? A world that is stepped, one among obstacles, a scenario that is run; reads bytes, panics if it does not hold.

pub mod input;
pub mod invariants;
pub mod mesh;
pub mod rule;
pub mod run;
pub mod scenario;
pub mod tampered_snapshot;
pub mod world;
