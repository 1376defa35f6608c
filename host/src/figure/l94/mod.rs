//! How are the figures of L94 (Luding et al., Phys. Rev. E 50, 4113, 1994) made? Columns, layers and shaken beads, by MD, ED and eMD*.

pub mod column;
pub mod hard;
pub mod height;
pub mod layer;
pub mod loss;
mod panels;
pub mod paths;
pub mod phase;
pub mod separation;
pub mod shaken;
pub mod table1;
