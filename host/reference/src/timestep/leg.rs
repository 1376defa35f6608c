//! How far has a run come on its way to an instant? Reads and writes nothing itself.

/// Equal steps to an instant. Between two of them velocities are half a step ahead.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Leg {
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) step: f64,
    pub(super) count: u64,
    pub(super) done: u64,
}

impl Leg {
    /// The time after the steps that were done.
    pub(super) fn now(&self) -> f64 {
        if self.done == self.count {
            return self.to;
        }
        self.from + self.done as f64 * (self.to - self.from) / self.count as f64
    }
}
