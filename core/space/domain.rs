//! In what do grains move? Boundaries and gravity; reads positions, writes nothing.

use super::boundary::Boundary;
use crate::particle::Body;
use crate::scalar::{Scalar, Vector};

/// What moves grains between events, and where they can be.
pub(crate) struct Domain<'m, S: Scalar, const D: usize> {
    /// Periodic axes and planes.
    pub boundary: Boundary<'m, S, D>,
    gravity: Vector<S, D>,
    weightless: bool,
    still: bool,
}

impl<'m, S: Scalar, const D: usize> Domain<'m, S, D> {
    /// These boundaries under this gravity.
    pub fn new(boundary: Boundary<'m, S, D>, gravity: Vector<S, D>) -> Self {
        let still = boundary.planes().iter().all(|plane| !plane.moves());
        let mut domain = Self { boundary, gravity, weightless: true, still };
        domain.set_gravity(gravity);
        domain
    }

    /// Uniform gravity.
    #[inline]
    pub fn gravity(&self) -> &Vector<S, D> {
        &self.gravity
    }

    /// Whether gravity is zero: kept, so that a flight need not look.
    #[inline]
    pub fn is_weightless(&self) -> bool {
        self.weightless
    }

    /// Whether no plane moves: kept, too.
    #[inline]
    pub fn is_still(&self) -> bool {
        self.still
    }

    /// From now on this gravity acts.
    pub fn set_gravity(&mut self, gravity: Vector<S, D>) {
        self.gravity = gravity;
        self.weightless = gravity.iter().all(|&g| g == S::zero());
    }

    /// How fast plane `p` moves along its normal at a time.
    pub fn plane_speed(&self, p: usize, now: S) -> S {
        self.boundary.planes().get(p).map_or(S::zero(), |plane| plane.motion(now).speed)
    }

    /// Separation r_a − r_b (nearest image) of two bodies at the same time.
    pub fn separation(&self, a: &Body<S, D>, b: &Body<S, D>) -> Vector<S, D> {
        self.boundary.nearest(a.position - b.position)
    }
}
