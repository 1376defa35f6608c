//! From how far must grains see each other? Reads radii; writes nothing.

/// Up to which distance grains must know of each other: they touch there, or crowd each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sight {
    /// A gap, in units of the larger radius of the two.
    pub gap: f64,
}

impl Sight {
    /// For grains of these radii.
    pub fn of(&self, a: f64, b: f64) -> f64 {
        a + b + self.gap * a.max(b)
    }
}
