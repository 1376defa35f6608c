//! Which figures of the papers can be made? Reads an id; writes nothing, returns the figure, its picture and the comparison.
//!
//! A figure is made by a function of [`Options`] that `list.rs` names. Its data are
//! a [`Figure`], whose serde form is what `carom figure ID --json` prints; its picture is a
//! [`Scene`](crate::plot::Scene), in most cases drawn by [`draw::draw`] from the data; and [`Note`]s
//! set the paper's numbers beside ours.

#[cfg(feature = "figures")]
pub mod bsfp14;
pub mod curves;
mod data;
pub mod draw;
pub mod fit;
#[cfg(feature = "figures")]
pub mod gases;
#[cfg(feature = "figures")]
pub mod hard;
#[cfg(feature = "figures")]
pub mod l94;
#[cfg(feature = "figures")]
mod list;
#[cfg(feature = "figures")]
pub mod mp13;
pub mod number;
#[cfg(feature = "figures")]
pub mod page;
#[cfg(feature = "figures")]
pub mod rest;
mod style;
mod table;
#[cfg(feature = "figures")]
pub mod walls;
#[cfg(feature = "figures")]
pub mod waves;

pub use data::{Axes, Entry, Figure, Made, Note, Options, Series, Value};
#[cfg(feature = "figures")]
pub use list::{all, find, print};
pub use table::write_csv;
