//! What is carom? Event-driven molecular dynamics of soft and hard grains; reads a description, writes trajectories.
//!
//! Grains fly freely, touch, and part. Between contacts nothing needs to be computed, so carom jumps
//! from one event to the next. A contact is not taken to be instantaneous: how long it lasts, by how
//! much the line of centres turns, how far apart and how fast the grains leave it are read from a
//! certified table, the *matrix of restitution* of Müller & Pöschel (Phys. Rev. E 87, 033301, 2013).
//! Events are detected by the rule of Bannerman et al. (Comput. Part. Mech. 1, 191, 2014), which
//! finite precision cannot break.
//!
//! No allocator, no unsafe code, no panic: the same engine on a microcontroller and a workstation.
//!
//! # The rooms, each looks down only
//! * [`scalar`]: what a value is.
//! * [`particle`]: what moves.
//! * [`space`]: where it is: boundaries, free flight, cells.
//! * [`law`]: what a contact does.
//! * `detect`: when something happens; it only reads.
//! * `schedule`: who is next.
//! * `cluster`: what many bodies do that touch at once.
//! * `resolve`: what happens then; it writes.
//! * [`world`]: the user's handle.
//! * [`error`]: every way it can say no.
//!
//! # Example: a viscoelastic pair
//! ```
//! use carom::law::{Outside, Soft, Viscoelastic};
//! use carom::{Grain, Memory, World};
//!
//! let rubber = Viscoelastic { young: 5.0e6, poisson: 0.4, dissipation: 1.0e-4 };
//! let mut memory = Memory::<f32, 2, 32>::new();
//! let mut world = World::builder(&mut memory)
//!     .walls([[0.0, 0.05], [0.0, 0.05]])
//!     .gravity([0.0, -9.81])
//!     .rule(Soft::viscoelastic(rubber, Outside::HardSphere))
//!     .grain(Grain::sphere(1.0e-3, 2500.0).at([0.01, 0.02]).moving([0.1, 0.0]))?
//!     .grain(Grain::sphere(2.0e-3, 2500.0).at([0.03, 0.02]).moving([-0.1, 0.0]))?
//!     .start()?;
//! world.advance_to(0.1)?;
//! world.set_gravity([9.81, 0.0])?; // between events, in the middle of a contact too
//! world.advance_to(0.2)?;
//! assert!(world.statistics().plane_collisions > 0);
//! # Ok::<(), carom::Error>(())
//! ```
#![no_std]
#![warn(
    clippy::missing_errors_doc,
    clippy::must_use_candidate,
    clippy::semicolon_if_nothing_returned,
    clippy::explicit_iter_loop,
    clippy::cast_lossless
)]
#![cfg_attr(
    not(test),
    deny(
        clippy::indexing_slicing,
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::unreachable,
        clippy::todo
    )
)]

#[cfg(feature = "alloc")]
extern crate alloc;
#[cfg(test)]
extern crate std;

mod cluster;
pub mod detect;
pub mod error;
pub mod law;
pub mod particle;
mod resolve;
pub mod scalar;
mod schedule;
pub mod space;
pub mod world;

pub use error::Error;
pub use law::Enduring;
/// The crate of [`scalar::Vector`]: positions and velocities are `nalgebra::SVector<S, D>`. For `f32` and `f64` they
/// have all its methods (`norm`, `dot`, `normalize`, ...); for every scalar there are [`scalar::norm`] and
/// [`scalar::dot`].
///
/// ```
/// use carom::{Grain, nalgebra::Vector2};
/// let grain = Grain::sphere(1.0e-3, 2500.0).at([0.0, 0.02]).moving([3.0, 4.0]);
/// assert_eq!(grain.velocity.norm(), 5.0);
/// assert_eq!(grain.velocity.dot(&Vector2::y()), 4.0);
/// let [x, y] = grain.position.into();
/// assert_eq!((x, y), (grain.position.x, grain.position.y));
/// ```
pub use nalgebra;
pub use particle::Grain;
pub use scalar::{Instant, Scalar, Vector};
#[cfg(feature = "alloc")]
pub use world::HeapMemory;
pub use world::{Memory, Observer, Release, Statistics, Storage, View, World};
