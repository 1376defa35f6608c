//! In what do grains move? Boundaries and gravity; reads positions, writes nothing.

use super::boundary::Boundary;
use super::obstacles::Obstacles;
use crate::particle::Body;
use crate::scalar::{Scalar, Vector, component};

/// What moves grains between events, and where they can be.
pub(crate) struct Domain<'m, S: Scalar, const D: usize> {
    /// Periodic axes and planes.
    pub boundary: Boundary<'m, S, D>,
    gravity: Vector<S, D>,
    weightless: bool,
    plain: bool,
}

impl<'m, S: Scalar, const D: usize> Domain<'m, S, D> {
    /// These boundaries under this gravity.
    pub fn new(boundary: Boundary<'m, S, D>, gravity: Vector<S, D>) -> Self {
        let plain = is_still(&boundary) && boundary.obstacles().is_none();
        let mut domain = Self { boundary, gravity, weightless: true, plain };
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

    /// Whether there are no obstacles, and nothing moves but grains, no plane and no image: kept, too.
    #[inline]
    pub fn is_plain(&self) -> bool {
        self.plain
    }

    /// Whether nothing moves but grains.
    #[inline]
    pub fn is_still(&self) -> bool {
        let stand = || self.boundary.obstacles().is_some_and(Obstacles::is_still);
        self.plain || stand() && is_still(&self.boundary)
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

    /// Separation r_a − r_b and relative velocity v_a − v_b (nearest images) of two bodies at this time.
    // Where nothing is sheared it is short; on small machines it is one function for all who ask.
    #[cfg_attr(feature = "alloc", inline)]
    #[cfg_attr(not(feature = "alloc"), inline(never))]
    pub fn relative(&self, a: &Body<S, D>, b: &Body<S, D>, time: S) -> [Vector<S, D>; 2] {
        self.boundary.relative([a.position - b.position, a.velocity - b.velocity], time)
    }

    /// The separation alone.
    #[cfg_attr(feature = "alloc", inline)]
    #[cfg_attr(not(feature = "alloc"), inline(never))]
    pub fn separation(&self, a: &Body<S, D>, b: &Body<S, D>, time: S) -> Vector<S, D> {
        let [separation, _] = self.relative(a, b, time);
        separation
    }

    /// What is added to the velocity of the second of two bodies to have it in the image that is the nearest to the first;
    /// none where all images stand.
    pub fn image_velocity(&self, a: &Body<S, D>, b: &Body<S, D>) -> Option<Vector<S, D>> {
        let images = self.boundary.images()?;
        let apart = component(&(a.position - b.position), images.shear.gradient);
        // Whatever the time is: only places move with it.
        let [_, velocity] = images.image(images.nearest_row(apart), S::zero());
        Some(velocity)
    }
}

/// Whether no plane moves and no image.
fn is_still<S: Scalar, const D: usize>(boundary: &Boundary<'_, S, D>) -> bool {
    boundary.planes().iter().all(|plane| !plane.moves()) && boundary.images().is_none()
}
