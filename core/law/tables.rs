//! Which tables are embedded? Those that build.rs made for the enabled features; reads nothing at run time.

pub use carom_tables::form;
pub use carom_tables::form::Stored as Number;
pub use carom_tables::form::{Certificate, Domain, Groups, Scaled, Table};
pub use carom_tables::{End, Law};

/// The number in which the embedded tables are stored: `f32`, or `f64` with the feature `f64-tables`.
#[cfg(not(feature = "f64-tables"))]
pub type Stored = f32;
/// The number in which the embedded tables are stored: `f32`, or `f64` with the feature `f64-tables`.
#[cfg(feature = "f64-tables")]
pub type Stored = f64;

/// What build.rs made.
#[allow(clippy::all, clippy::pedantic)]
mod made {
    include!(concat!(env!("OUT_DIR"), "/tables.rs"));
}
pub use made::*;

#[cfg(not(any(feature = "standard", feature = "compact", feature = "wide")))]
compile_error!("carom needs a table: enable one of the features standard, compact, wide");

#[cfg(all(feature = "compact", not(feature = "standard")))]
use compact as chosen;
#[cfg(feature = "standard")]
use standard as chosen;
#[cfg(all(feature = "wide", not(any(feature = "standard", feature = "compact"))))]
use wide as chosen;

/// The table that [`crate::law::Soft::linear_dashpot`] uses.
#[must_use]
pub fn linear_dashpot() -> &'static Table<Stored> {
    &chosen::LINEAR_DASHPOT
}

/// The table that [`crate::law::Soft::viscoelastic`] uses.
#[must_use]
pub fn viscoelastic() -> &'static Table<Stored> {
    &chosen::VISCOELASTIC
}
