//! How are the figures of MP13 (Müller and Pöschel, Phys. Rev. E 87, 033301, 2013) made? The matrix of restitution, two grains, and gases of soft spheres, by eMD, eMD* and MD.

pub mod gas;
pub mod maps;
pub mod measure;
pub mod pair;
pub mod transport;
