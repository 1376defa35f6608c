//! From how far must grains see each other? Reads radii; writes nothing.

use crate::scalar::Scalar;

/// Who is further off than this part of the larger radius of two is no crowd, however fast it comes: it is not known
/// in every grid.
const CROWD_GAP: f64 = 0.5;

/// The same as a distance.
pub(crate) fn crowd_gap<S: Scalar>(larger_radius: S) -> S {
    larger_radius * S::from_f64(CROWD_GAP)
}

/// Up to which distance grains must know of each other: they touch there, or crowd each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Sight {
    /// Whether contacts may be crowded.
    pub may_crowd: bool,
}

impl Sight {
    /// For grains of these radii.
    #[cfg(feature = "alloc")]
    pub fn of(self, a: f64, b: f64) -> f64 {
        a + b + if self.may_crowd { CROWD_GAP * a.max(b) } else { 0.0 }
    }

    /// For grains of this radius.
    pub fn of_equal<S: Scalar>(self, radius: S) -> S {
        let touching = radius + radius;
        if self.may_crowd { touching + crowd_gap(radius) } else { touching }
    }
}
