//! What does a contact of two soft spheres do? Reads a table, or makes one (feature `generate`); writes the scaled restitution of one collision.
//!
//! A collision of two smooth, soft spheres depends on three dimensionless groups: eccentricity,
//! softness and damping (Müller & Pöschel, Phys. Rev. E 87, 033301, 2013; called MP13 below).
//!
//! * [`read`] says how a table is laid out and reads it. It is all that a program on a
//!   microcontroller needs; without the feature `generate` the crate is `no_std` and contains nothing
//!   else but the fixed-point numbers.
#![cfg_attr(feature = "fixed", doc = "* [`fixed_point`] has the numbers `I32F32` and `I16F16`.")]
#![cfg_attr(
    feature = "generate",
    doc = "* [`recipe`] makes a table for a `build.rs`: it fits, certifies and writes Rust text.\n\
           * [`contact`] integrates the equation of motion of one contact.\n\
           * [`collision`] turns material, radius and speed into the dimensionless groups.\n\
           * [`random`] draws the random numbers of fit and certificate."
)]
#![cfg_attr(not(any(feature = "generate", test)), no_std)]

pub mod read;

#[cfg(feature = "fixed")]
pub mod fixed_point;

#[cfg(feature = "generate")]
pub mod collision;
#[cfg(feature = "generate")]
pub mod contact;
#[cfg(feature = "generate")]
mod fit;
#[cfg(feature = "generate")]
mod pair_contact;
#[cfg(feature = "generate")]
pub mod random;
#[cfg(feature = "generate")]
pub mod recipe;
#[cfg(feature = "generate")]
mod taylor;
