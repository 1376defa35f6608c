//! What does an ensemble of runs give? Reads a sweep file; writes one Parquet row for each run, however they are split.
//!
//! Every run that ends is a line in a journal beside the result, so that a sweep that was killed goes
//! on where it stopped. When all are done the journal becomes a Parquet file. Which runs a shard has,
//! in what order they end and how often they are interrupted leaves no trace in the merged file.

mod ensemble;
mod plan;
mod run;
mod table;

pub use crate::columns::{Cell, Column, Kind};
pub use ensemble::{Report, merge, sweep};
pub use plan::{Axis, Plan, Run, Spec};
pub use table::{Rows, Source, shard};
