//! How are the figures of BSFP14 (Bannerman et al., Comput. Part. Mech. 1, 191, 2014) made? A ball on plates, and gases of hard spheres.

pub mod ball;
pub mod gas;
pub mod path;
pub mod plates;
pub mod three_body;
