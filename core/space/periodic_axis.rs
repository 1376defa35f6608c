//! Where does an axis repeat? Plain data; reads and writes nothing.

/// A periodic axis from `low` to `low + length`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PeriodicAxis<S> {
    /// Where the box begins.
    pub low: S,
    /// How long it is.
    pub length: S,
}
