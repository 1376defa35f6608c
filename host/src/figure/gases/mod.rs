//! What do gases do that cool or collide? Viscoelastic cooling, a mixture that cools, the mean free time; of the papers' outlook.

pub mod cooling;
pub mod direct;
pub mod free_time;
pub mod mixture;
pub mod partial;
pub mod theory;
