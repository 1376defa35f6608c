//! What would force-based molecular dynamics do? Reads grains, box and force law; writes their motion.
//!
#![doc = include_str!("../README.md")]

mod cells;
mod cluster;
mod collocation;
mod contact_law;
mod error;
mod exact;
mod friction;
mod general_law;
mod hard;
mod law;
mod pair;
mod plate;
mod quiet;
mod roots;
mod rough;
mod rough_step;
#[cfg(feature = "serde")]
mod saved;
mod system;
mod timestep;
mod touch;
mod vector;

pub use contact_law::{ContactLaw, End};
pub use error::ReferenceError;
pub use exact::{ContactRecord, Event, EventKind, Exact, Partner};
pub use friction::Friction;
pub use general_law::{GeneralLaw, Sticky};
pub use hard::{HardImpact, collide_hard};
pub use law::ForceLaw;
pub use pair::{Collision, collide};
pub use plate::Plate;
pub use quiet::{Quiet, Stop};
pub use rough::{
    RoughGrain, RoughImpact, collide_general, collide_rough, collide_rough_with_plane,
};
pub use system::{Boundary, Grain, System};
pub use timestep::{ContactStep, Gear, Statistics, Tell, Verlet, VerletOptions};
