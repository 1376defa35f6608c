//! In how many bits do lists and trees keep the number of a grain? Reads and writes nothing else.

/// With the feature `alloc` worlds can be large, without it memory is short.
#[cfg(feature = "alloc")]
type Bits = u32;
#[cfg(not(feature = "alloc"))]
type Bits = u16;

/// The number of a grain, as lists and trees keep it: 32 bits with the feature `alloc`, 16 without.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Index(Bits);

impl Index {
    /// What memory holds that nobody has written yet.
    pub(crate) const ZERO: Self = Self(0);
    /// How many bits it has.
    pub(crate) const BITS: u32 = Bits::BITS;

    /// What a number is of which these are the lower bits; the others are zero.
    #[inline(always)]
    #[expect(clippy::allow_attributes, reason = "only with 16 bits something could be cut off")]
    #[allow(clippy::cast_possible_truncation, reason = "the builder refuses what does not fit")]
    pub(crate) fn new(number: u32) -> Self {
        Self(number as Bits)
    }

    /// The number.
    #[inline(always)]
    #[expect(clippy::allow_attributes, reason = "only with 16 bits there is something to convert")]
    #[allow(clippy::useless_conversion, reason = "not with 16 bits")]
    pub(crate) fn get(self) -> u32 {
        u32::from(self.0)
    }
}
