//! What must hold for any bytes? A world that is stepped, a scenario that is run; reads bytes, panics if it does not hold.

pub mod draw;
pub mod judge;
pub mod play;
pub mod rule;
pub mod scenario;
pub mod snapshot;
pub mod world;
