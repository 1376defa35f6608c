//! How does fixed-point arithmetic work, exactly and without floats? Reads and writes the numbers `I32F32` and `I16F16`.
//!
//! [`I32F32`] and [`I16F16`] calculate as the types of the same names in the package `fixed`, but
//! overflow gives not-a-number. [`Product`] keeps a product exact until it is rounded. [`integer`] has
//! the two integer functions that other crates use as well.

mod conversion;
pub mod integer;
pub(crate) mod number;
mod product;
mod real;

pub use number::{I16F16, I32F32};
pub use product::Product;
