//! Which pictures are there? Reads results; writes scenes.

pub mod divergence;
pub mod fig6;
pub mod gas;
pub mod matrix;
pub mod space;
