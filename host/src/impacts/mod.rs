//! What do single impacts of grains that rotate, rub or stick lead to? By the engine and by the reference, side by side.

mod case;
mod engine;
mod judge;
mod write;

pub use case::{COLUMNS, Case, Law, Surfaces, read};
pub use engine::{Answer, by_engine};
pub use judge::by_reference;
pub use write::{Both, Row, write};
