//! Which tables are embedded? Those that build.rs made for the enabled features; reads nothing at run time.

use crate::scalar::Scalar;
pub use carom_tables::read;
use carom_tables::read::{StoredNumber, Table};

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

/// The table that [`crate::law::Soft::linear_dashpot`] uses for `f32` and `f64`.
#[must_use]
pub fn linear_dashpot() -> &'static Table<Stored> {
    &chosen::LINEAR_DASHPOT
}

/// The table that [`crate::law::Soft::viscoelastic`] uses for `f32` and `f64`.
#[must_use]
pub fn viscoelastic() -> &'static Table<Stored> {
    &chosen::VISCOELASTIC
}

/// A number type for which tables are embedded, made for reading in that type.
pub trait Embedded: Scalar {
    /// The number in which they are stored.
    type Stored: StoredNumber;
    /// The linear spring-dashpot's.
    fn linear_dashpot() -> &'static Table<Self::Stored>;
    /// The viscoelastic law's.
    fn viscoelastic() -> &'static Table<Self::Stored>;
}

macro_rules! embedded {
    ($type:ty, $stored:ty, $linear:expr, $viscoelastic:expr) => {
        impl Embedded for $type {
            type Stored = $stored;
            fn linear_dashpot() -> &'static Table<$stored> {
                $linear
            }
            fn viscoelastic() -> &'static Table<$stored> {
                $viscoelastic
            }
        }
    };
}

embedded!(f32, Stored, linear_dashpot(), viscoelastic());
embedded!(f64, Stored, linear_dashpot(), viscoelastic());

#[cfg(all(feature = "fixed", any(feature = "standard", feature = "compact")))]
mod quantised {
    use super::{Embedded, Table, chosen};
    use crate::scalar::{I16F16, I32F32};
    use carom_tables::read::Quantised;

    embedded!(I32F32, Quantised, &chosen::LINEAR_DASHPOT_I32F32, &chosen::VISCOELASTIC_I32F32);
    embedded!(I16F16, Quantised, &chosen::LINEAR_DASHPOT_I16F16, &chosen::VISCOELASTIC_I16F16);
}

// The wide tables have numbers too large to be quantised. Fixed point reads their floats as bits.
#[cfg(all(feature = "fixed", not(any(feature = "standard", feature = "compact"))))]
mod quantised {
    use super::{Embedded, Stored, Table, linear_dashpot, viscoelastic};
    use crate::scalar::{I16F16, I32F32};

    embedded!(I32F32, Stored, linear_dashpot(), viscoelastic());
    embedded!(I16F16, Stored, linear_dashpot(), viscoelastic());
}
