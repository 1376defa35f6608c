//! Is this a grid for this box? Reads both, one of which may come from a file; writes nothing.

use super::boundary::Boundary;
use super::grid::Grid;
use super::periodic_axis::PeriodicAxis;
use crate::scalar::Scalar;

impl<S: Scalar, const D: usize> Grid<S, D> {
    /// Whether it is a grid for this box and grains of this diameter, zero if there is none.
    pub(crate) fn fits(&self, boundary: &Boundary<S, D>, reach: S) -> bool {
        self.axes().iter().enumerate().all(|(axis, along)| {
            let length = along.width * S::from_count(along.count);
            let is_round = |p: &PeriodicAxis<S>| {
                let off = (length - p.length).abs();
                along.low == p.low
                    && along.count >= 4
                    && (off < reach * S::from_f32(1e-3) || reach == S::zero())
            };
            let sheared = boundary.images().filter(|images| images.shear.gradient == axis);
            let same = match boundary.at_rest(axis) {
                Some(p) => along.periodic && along.length == p.length && is_round(&p),
                None => {
                    let open = !along.periodic && along.length == S::zero();
                    open && sheared.is_none_or(|images| is_round(&images.across))
                }
            };
            // The only cell of an open axis reaches to infinity, however wide it is.
            same && along.low.is_finite() && (along.width >= reach || along.count == 1)
        })
    }
}
