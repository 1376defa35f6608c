//! Which pictures are there? Reads results; writes scenes.

pub mod matrix;
pub mod space;
