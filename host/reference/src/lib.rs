//! What would force-based molecular dynamics do? Reads grains, box and force law; writes their motion.
//!
#![doc = include_str!("../README.md")]

mod cells;
mod cluster;
mod collocation;
mod contact_law;
mod error;
mod exact;
mod law;
mod pair;
mod plate;
mod quiet;
mod roots;
mod system;
mod timestep;
mod vector;

pub use contact_law::{ContactLaw, End};
pub use error::ReferenceError;
pub use exact::{ContactRecord, Event, EventKind, Exact, Partner};
pub use law::ForceLaw;
pub use pair::{Collision, collide};
pub use plate::Plate;
pub use quiet::{Quiet, Stop};
pub use system::{Boundary, Grain, System};
pub use timestep::{Gear, Statistics, Verlet, VerletOptions};
