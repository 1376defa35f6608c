//! How is a table made for a `build.rs`? Reads a recipe; writes a fitted, certified table as Rust text.
//!
//! [`Recipe`] is the entrance.

mod bisections;
mod builder;
mod certify;
mod emit;
mod error;
mod generate;
mod generated;
mod history;
mod number_type;
mod pair;
mod pair_fit;
mod presets;

pub use builder::Recipe;
pub use error::Error;
pub use generated::GeneratedTable;
pub use history::emit_history;
pub use number_type::NumberType;
pub use pair::PairRecipe;
