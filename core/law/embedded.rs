//! Which tables are embedded? Those that build.rs made for the enabled features; reads nothing at run time.
//!
//! A feature adds tables and changes none: a rule names the set that it reads, [`Compact`], [`Standard`] or
//! [`Wide`]. What a program computes does not depend on which features another crate switches on.

use crate::scalar::Scalar;
pub use carom_tables::read;
use carom_tables::read::{Law, StoredNumber, Table};

/// What build.rs made.
#[cfg(any(feature = "compact", feature = "standard", feature = "wide"))]
#[allow(clippy::all, clippy::pedantic)]
mod made {
    include!(concat!(env!("OUT_DIR"), "/tables.rs"));
}
#[cfg(any(feature = "compact", feature = "standard", feature = "wide"))]
pub use made::*;

/// A set of embedded tables, one for each force law, in the form that numbers of type `S` read.
///
/// For `f32` and `f64` they are stored as `f32`; with the feature `f64-tables` the modules [`compact`],
/// [`standard`] and [`wide`] hold the same in `f64` besides, for [`crate::law::Soft::with_table`].
pub trait TableSet<S: Scalar> {
    /// The number in which the tables are stored.
    type Stored: StoredNumber;
    /// The table of this law.
    fn table(law: Law) -> &'static Table<Self::Stored>;
}

/// The smallest tables: about 2 KB a law, errors up to 1.5·10⁻⁴.
#[cfg(feature = "compact")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Compact;

/// The default tables: about 20 KB a law, errors up to 1.1·10⁻⁶.
#[cfg(feature = "standard")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Standard;

/// Tables over nearly all of MP13's Tables I and II, up to 92 KB a law.
#[cfg(feature = "wide")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wide;

#[cfg(any(feature = "compact", feature = "standard", feature = "wide"))]
macro_rules! table_set {
    ($set:ident, $number:ty, $stored:ty, $module:ident::{$linear:ident, $viscoelastic:ident}) => {
        impl TableSet<$number> for $set {
            type Stored = $stored;
            fn table(law: Law) -> &'static Table<$stored> {
                match law {
                    Law::LinearDashpot => &$module::$linear,
                    Law::Viscoelastic => &$module::$viscoelastic,
                }
            }
        }
    };
}

#[cfg(feature = "compact")]
mod compact_set {
    use super::{Compact, Law, Table, TableSet, compact};
    #[cfg(feature = "fixed")]
    use carom_tables::read::Quantised;
    table_set!(Compact, f32, f32, compact::{LINEAR_DASHPOT, VISCOELASTIC});
    table_set!(Compact, f64, f32, compact::{LINEAR_DASHPOT, VISCOELASTIC});
    #[cfg(feature = "fixed")]
    table_set!(Compact, crate::scalar::I32F32, Quantised, compact::{
        LINEAR_DASHPOT_I32F32, VISCOELASTIC_I32F32
    });
    #[cfg(feature = "fixed")]
    table_set!(Compact, crate::scalar::I16F16, Quantised, compact::{
        LINEAR_DASHPOT_I16F16, VISCOELASTIC_I16F16
    });
}

#[cfg(feature = "standard")]
mod standard_set {
    use super::{Law, Standard, Table, TableSet, standard};
    #[cfg(feature = "fixed")]
    use carom_tables::read::Quantised;
    table_set!(Standard, f32, f32, standard::{LINEAR_DASHPOT, VISCOELASTIC});
    table_set!(Standard, f64, f32, standard::{LINEAR_DASHPOT, VISCOELASTIC});
    #[cfg(feature = "fixed")]
    table_set!(Standard, crate::scalar::I32F32, Quantised, standard::{
        LINEAR_DASHPOT_I32F32, VISCOELASTIC_I32F32
    });
    #[cfg(feature = "fixed")]
    table_set!(Standard, crate::scalar::I16F16, Quantised, standard::{
        LINEAR_DASHPOT_I16F16, VISCOELASTIC_I16F16
    });
}

#[cfg(feature = "wide")]
mod wide_set {
    use super::{Law, Table, TableSet, Wide, wide};
    table_set!(Wide, f32, f32, wide::{LINEAR_DASHPOT, VISCOELASTIC});
    table_set!(Wide, f64, f32, wide::{LINEAR_DASHPOT, VISCOELASTIC});
    // The wide tables have numbers too large to be quantised. Fixed point reads their floats as bits.
    #[cfg(feature = "fixed")]
    table_set!(Wide, crate::scalar::I32F32, f32, wide::{LINEAR_DASHPOT, VISCOELASTIC});
    #[cfg(feature = "fixed")]
    table_set!(Wide, crate::scalar::I16F16, f32, wide::{LINEAR_DASHPOT, VISCOELASTIC});
}
