//! Can a heap stop the engine? Draws boxes of grains; runs them, returns what broke.
//!
//! Every box follows from its seed alone: the same number type and seed give the same box again.

mod check;
mod draw;
mod run;
mod summary;

pub use draw::{Drawn, Gravity, LawKind};
pub use run::{Ended, Number, Report, run};
pub use summary::{Families, Family, Summary, family};
