//! What does a shaken layer do? Waves that change sign in every cycle, in three dimensions and in two; of the papers' outlook.

pub mod faraday;
pub mod flow;
pub mod modes;
pub mod patterns;
pub mod shaken_disks;
