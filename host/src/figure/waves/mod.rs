//! What does a shaken layer do? Waves that change sign in every cycle, in two dimensions; of the papers' outlook.

pub mod flow;
pub mod shaken_disks;
