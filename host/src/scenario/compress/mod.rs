//! How densely can grains be packed at random? Reads small grains; writes nothing, returns where they are when grown.
//!
//! Lubachevsky and Stillinger, J. Stat. Phys. 60, 561 (1990): grains fly and collide as hard ones do, while
//! all grow at a constant rate until they are as large as they should be. The engine's own grains do not
//! grow, so this small event-driven loop stands for itself: it knows neither time nor mass nor law.

mod events;
mod facets;
mod grow;
mod predict;
mod state;

pub use grow::grow;
pub use state::Growth;
