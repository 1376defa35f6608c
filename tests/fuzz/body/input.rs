//! Which number comes next? Reads bytes, zeros when they are used up; writes nothing.

use carom::Scalar;

/// Bytes, taken one after the other.
pub struct Input<'a> {
    bytes: &'a [u8],
    /// No number so far was larger than a few thousand, smaller than its inverse, or not a number.
    pub moderate: bool,
}

/// Numbers that break things.
const EXTREME: [f64; 16] = [
    0.0,
    -0.0,
    f64::MIN_POSITIVE,
    1e-300,
    1e-38,
    1e-20,
    f64::EPSILON,
    1e-9,
    1e9,
    1e15,
    1e20,
    3e38,
    1e150,
    f64::MAX,
    f64::INFINITY,
    f64::NAN,
];

impl<'a> Input<'a> {
    pub const fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, moderate: true }
    }

    pub const fn is_empty(&self) -> bool {
        self.bytes.is_empty()
    }

    pub fn byte(&mut self) -> u8 {
        match self.bytes.split_first() {
            Some((&first, rest)) => {
                self.bytes = rest;
                first
            }
            None => 0,
        }
    }

    /// 0 to n − 1.
    pub fn below(&mut self, n: u8) -> u8 {
        self.byte() % n
    }

    /// 0 to 1, both included.
    pub fn fraction<S: Scalar>(&mut self) -> S {
        S::from_f64(f64::from(self.byte()) / 255.0)
    }

    /// A number above 0, in eighths, at most 32.
    pub fn size(&mut self) -> f64 {
        (f64::from(self.byte()) + 1.0) / 8.0
    }

    /// Mostly in eighths, so that things happen at once; sometimes off by a last place; now and then extreme.
    pub fn number<S: Scalar>(&mut self) -> S {
        let eighths = |byte: u8| f64::from(byte as i8) / 8.0;
        let number = match self.byte() {
            0..=159 => eighths(self.byte()),
            160..=199 => f64::from(i16::from_le_bytes([self.byte(), self.byte()])) / 256.0,
            200..=229 => {
                eighths(self.byte()) * (1.0 + S::RESOLUTION.to_f64() * eighths(self.byte()))
            }
            230..=242 => self.extreme(),
            _ => f64::from_le_bytes(std::array::from_fn(|_| self.byte())),
        };
        let size = number.abs();
        self.moderate &= size < 4096.0 && (size > 1.0 / 4096.0 || size == 0.0);
        S::from_f64(number)
    }

    fn extreme(&mut self) -> f64 {
        let byte = self.byte();
        let sign = if byte & 16 == 0 { 1.0 } else { -1.0 };
        sign * EXTREME[usize::from(byte & 15)]
    }
}
