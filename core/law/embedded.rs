//! Which tables are embedded? Those that build.rs made for the enabled features; reads nothing at run time.
//!
//! A feature adds tables and changes none: a rule names the set that it reads, [`Compact`], [`Standard`],
//! [`Wide`] or [`Fine`]. What a program computes does not depend on which features another crate switches on.

use crate::scalar::Scalar;
#[cfg(all(
    feature = "fixed",
    any(feature = "compact", feature = "standard", feature = "wide", feature = "fine")
))]
use crate::scalar::{I16F16, I32F32};
pub use carom_tables::read;
#[cfg(all(feature = "fixed", any(feature = "compact", feature = "standard")))]
use carom_tables::read::Quantised;
use carom_tables::read::{Law, StoredNumber, Table};

/// What build.rs made.
#[allow(clippy::all, clippy::pedantic)]
mod made {
    include!(concat!(env!("OUT_DIR"), "/tables.rs"));
}
pub use made::*;

/// A set of embedded tables, one for each force law, in the form that numbers of type `S` read.
///
/// For `f32` and `f64` they are stored as `f32`; with the feature `f64-tables` the modules [`compact`],
/// [`standard`], [`wide`] and [`fine`] hold the same in `f64` besides, for [`crate::law::Soft::with_table`].
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

/// As [`Wide`], but 99.9 % of MP13's collisions are within 10⁻⁴ (linear, 250 KB) or 3·10⁻⁵ (viscoelastic, 60 KB): for hosts.
#[cfg(feature = "fine")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fine;

#[cfg(any(feature = "compact", feature = "standard", feature = "wide", feature = "fine"))]
macro_rules! table_set {
    ($set:ident, $number:ty, $stored:ty, $linear:path, $viscoelastic:path) => {
        impl TableSet<$number> for $set {
            type Stored = $stored;
            fn table(law: Law) -> &'static Table<$stored> {
                match law {
                    Law::LinearDashpot => &$linear,
                    Law::Viscoelastic => &$viscoelastic,
                }
            }
        }
    };
}

/// A set whose tables are quantised for fixed point, too.
#[cfg(any(feature = "compact", feature = "standard"))]
macro_rules! quantised_table_set {
    ($set:ident, $module:ident) => {
        table_set!($set, f32, f32, $module::LINEAR_DASHPOT, $module::VISCOELASTIC);
        table_set!($set, f64, f32, $module::LINEAR_DASHPOT, $module::VISCOELASTIC);
        #[cfg(feature = "fixed")]
        table_set!(
            $set,
            I32F32,
            Quantised,
            $module::LINEAR_DASHPOT_I32F32,
            $module::VISCOELASTIC_I32F32
        );
        #[cfg(feature = "fixed")]
        table_set!(
            $set,
            I16F16,
            Quantised,
            $module::LINEAR_DASHPOT_I16F16,
            $module::VISCOELASTIC_I16F16
        );
    };
}

#[cfg(feature = "compact")]
quantised_table_set!(Compact, compact);
#[cfg(feature = "standard")]
quantised_table_set!(Standard, standard);

/// A set whose tables have numbers too large to be quantised: fixed point reads their floats as bits.
#[cfg(any(feature = "wide", feature = "fine"))]
macro_rules! float_table_set {
    ($set:ident, $module:ident, $($number:ty),*) => {
        $(table_set!($set, $number, f32, made::$module::LINEAR_DASHPOT, made::$module::VISCOELASTIC);)*
    };
}

// (`wide` alone would also name a package.)
#[cfg(feature = "wide")]
float_table_set!(Wide, wide, f32, f64);
#[cfg(all(feature = "wide", feature = "fixed"))]
float_table_set!(Wide, wide, I32F32, I16F16);
#[cfg(feature = "fine")]
float_table_set!(Fine, fine, f32, f64);
#[cfg(all(feature = "fine", feature = "fixed"))]
float_table_set!(Fine, fine, I32F32, I16F16);
