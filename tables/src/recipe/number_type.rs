//! In which number types can a table be stored? Reads a value as `f64`; writes the nearest stored number and its bytes.

#[cfg(feature = "fixed")]
use crate::read::real::QUANTISATION_STEP;
#[cfg(feature = "fixed")]
use crate::read::stored::Quantised;
use crate::read::stored::StoredNumber;

/// The number type in which a table is stored, and read when it is certified.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NumberType {
    /// Stored as `f32`, read in `f32` and `f64`.
    F32,
    /// Stored and read in `f64`.
    F64,
    /// Stored in steps of 2^−28, read in `I32F32`.
    #[cfg(feature = "fixed")]
    I32F32,
    /// Stored in steps of 2^−28, read in `I16F16`.
    #[cfg(feature = "fixed")]
    I16F16,
}

/// A number that a generated table can be stored in.
pub trait EncodeNumber: StoredNumber + std::fmt::Debug {
    /// The name of this type in Rust.
    const NAME: &'static str;
    /// The number type in which a table of it is read, unless the recipe says otherwise.
    const NUMBER_TYPE: NumberType;
    /// The largest value of this type.
    const MAX_VALUE: f64;
    /// The nearest value of this type.
    fn nearest(value: f64) -> Self;
    /// The value as `f64`.
    fn value(self) -> f64;
    /// The next larger value.
    fn next_above(self) -> Self;
    /// The bits, lowest byte first.
    fn le_bytes(self) -> Vec<u8>;
}

impl EncodeNumber for f32 {
    const NAME: &'static str = "f32";
    const NUMBER_TYPE: NumberType = NumberType::F32;
    const MAX_VALUE: f64 = f32::MAX as f64;
    fn nearest(value: f64) -> Self {
        value as f32
    }
    fn value(self) -> f64 {
        f64::from(self)
    }
    fn next_above(self) -> Self {
        libm::nextafterf(self, f32::INFINITY)
    }
    fn le_bytes(self) -> Vec<u8> {
        self.to_bits().to_le_bytes().to_vec()
    }
}

impl EncodeNumber for f64 {
    const NAME: &'static str = "f64";
    const NUMBER_TYPE: NumberType = NumberType::F64;
    const MAX_VALUE: f64 = f64::MAX;
    fn nearest(value: f64) -> Self {
        value
    }
    fn value(self) -> f64 {
        self
    }
    fn next_above(self) -> Self {
        libm::nextafter(self, f64::INFINITY)
    }
    fn le_bytes(self) -> Vec<u8> {
        self.to_bits().to_le_bytes().to_vec()
    }
}

#[cfg(feature = "fixed")]
impl EncodeNumber for Quantised {
    const NAME: &'static str = "Quantised";
    const NUMBER_TYPE: NumberType = NumberType::I32F32;
    const MAX_VALUE: f64 = 8.0 - QUANTISATION_STEP;
    fn nearest(value: f64) -> Self {
        // A cast saturates; what does not fit is refused before it comes to that.
        Quantised(libm::round(value / QUANTISATION_STEP) as i32)
    }
    fn value(self) -> f64 {
        f64::from(self.0) * QUANTISATION_STEP
    }
    fn next_above(self) -> Self {
        Quantised(self.0.saturating_add(1))
    }
    fn le_bytes(self) -> Vec<u8> {
        self.0.to_le_bytes().to_vec()
    }
}
