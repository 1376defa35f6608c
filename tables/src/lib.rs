//! What does a contact do, in three numbers? Reads a table (or, with `generate`, makes one); writes the scaled restitution of one collision.
//!
//! A soft collision of two smooth spheres depends on three dimensionless groups.
//! This crate holds the tables that answer for them ([`form`]), and with the feature
//! `generate` everything that makes such a table: the contact equation ([`contact`]),
//! the fit, the certificate and the Rust text for a `build.rs` ([`recipe`]).
#![cfg_attr(not(any(feature = "generate", test)), no_std)]

pub mod form;
pub mod law;
pub mod number;

#[cfg(feature = "generate")]
pub mod contact;
#[cfg(feature = "generate")]
mod fit;
#[cfg(feature = "generate")]
pub mod recipe;
#[cfg(feature = "generate")]
mod series;

pub use form::{Certificate, Domain, Groups, Scaled, Table};
pub use law::{End, Law};
pub use number::Real;
#[cfg(feature = "fixed")]
pub use number::{I16F16, I32F32};
#[cfg(feature = "generate")]
pub use recipe::Recipe;
