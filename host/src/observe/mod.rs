//! What is measured while a method runs, and with what error? Reads collisions and states; writes tables of means, as CSV and Parquet.
//!
//! Everything that is measured is made of sums: over collisions, and over states at equal intervals. Sums
//! of parts of the time ([`Blocks`]) give every quantity and its error.

mod alone;
mod blocks;
mod correlations;
mod given;
mod layout;
mod obstacles;
mod pair_distribution;
mod profile;
mod quantities;
mod recorder;
mod state;
mod surface;
mod table;
mod tally;

pub use blocks::{Blocks, Mean};
pub use given::Given;
pub use layout::Layout;
pub use quantities::Quantity;
pub use recorder::{Looks, Recorder};
pub use table::Table;
pub use tally::Tally;
