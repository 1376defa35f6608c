//! What would force-based molecular dynamics do? Reads grains, box and force law; writes their motion.
//!
//! The judge: Newton's equations of the same grains, integrated with the force laws themselves and
//! nothing of the event-driven core, its tables or its rules. It comes in two kinds:
//!
//! * [`Verlet`]: what is used in practice, and what the event-driven methods are timed against.
//! * [`Exact`]: the same motion to about 12 digits, contact by contact; [`collide`] for one pair.
//!
//! Against 176 isolated collisions integrated to 34 digits by other means, overdamped and passing
//! through included, [`collide`] is within 3e-14 (duration, relative), 2e-15 (1 − ε_r), 6e-13 (ε_ṙ)
//! and 4e-15 rad (ε_φ); L94's columns of ten beads in joint contact come out within 2e-12.
//!
//! Both know both ends of a contact ([`End`]), one, two and three dimensions, uniform gravity,
//! periodic boxes and soft plane walls.

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

pub use contact_law::ContactLaw;
pub use error::ReferenceError;
pub use exact::{ContactRecord, Event, EventKind, Exact, Partner};
pub use law::{End, ForceLaw};
pub use pair::{Collision, collide};
pub use plate::Plate;
pub use quiet::{Quiet, Stop};
pub use system::{Boundary, Grain, System};
pub use timestep::{Counters, Gear, Verlet, VerletOptions};
